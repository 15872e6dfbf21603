// SPDX-License-Identifier: BSD-3-Clause
// Finds neighbouring regions by walking along rows and columns.
#include "inverse_depth/region_contacts.h"

#include <utility>

namespace epcc {

void Contact::add(const InverseDepthImage& image, int row, int column, int other_row, int other_column) {
  const auto weightAt = [&image](int r, int c) { return static_cast<double>(image.weight[image.index(r, c)]); };
  const double weight = 0.5 * (weightAt(row, column) + weightAt(other_row, other_column));
  const Eigen::Vector3d middle = 0.5 * (image.ray(row, column) + image.ray(other_row, other_column));
  ++count;
  rays.noalias() += (weight * middle) * middle.transpose();
}

namespace {

/// The labelled pixel last seen on a line.
struct LastLabel {
  std::int32_t label = 0;  ///< 0: none yet
  int place = 0;
};

/// Finds where labels follow each other on a row or column.
class ContactSearch {
 public:
  ContactSearch(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map)
      : image_(image), bridge_(bridge), residual2_(residual * residual), map_(map) {}

  // Inside a region nothing needs to be remembered: of the pixels before only those at its end count.
  RegionContacts search() {
    above_.assign(static_cast<std::size_t>(image_.width), LastLabel());
    const std::vector<std::int32_t> no_row(static_cast<std::size_t>(image_.width), 0);
    for (int row = 0; row < image_.height; ++row) {
      const std::int32_t* labels = map_.labels.data() + image_.index(row, 0);
      const std::int32_t* upper_labels = row > 0 ? labels - image_.width : no_row.data();
      left_ = LastLabel();
      std::int32_t left_label = 0;
      for (int column = 0; column < image_.width; ++column) {
        const std::int32_t label = labels[column];
        const std::int32_t upper_label = upper_labels[column];
        if (label != left_label) meetLeft(row, column, label, left_label);
        if (label != upper_label) meetAbove(row, column, label, upper_label);
        left_label = label;
      }
    }
    return std::move(contacts_);
  }

 private:
  void meetLeft(int row, int column, std::int32_t label, std::int32_t left_label) {
    if (left_label != 0) left_ = {left_label, column - 1};
    if (meets(left_, label, column) && !seesBehind(image_.index(row, left_.place), image_.index(row, column), 1))
      contact_[{left_.label, label}].add(image_, row, column, row, left_.place);
  }

  void meetAbove(int row, int column, std::int32_t label, std::int32_t upper_label) {
    LastLabel& upper = above_[static_cast<std::size_t>(column)];
    if (upper_label != 0) upper = {upper_label, row - 1};
    if (meets(upper, label, row) && !seesBehind(image_.index(upper.place, column), image_.index(row, column),
                                                static_cast<std::size_t>(image_.width)))
      contact_[{upper.label, label}].add(image_, row, column, upper.place, column);
  }

  bool meets(const LastLabel& last, std::int32_t label, int place) const {
    return label != 0 && last.label != 0 && last.label != label && place - last.place <= bridge_ + 1;
  }

  /// Something between the two pixels lies farther away than both: a groove or a gap parts them.
  bool seesBehind(std::size_t first, std::size_t second, std::size_t step) const {
    if (first + step == second) return false;
    const std::size_t farther = image_.w[first] < image_.w[second] ? first : second;
    const auto weight = static_cast<double>(image_.weight[farther]);
    for (std::size_t between = first + step; between < second; between += step) {
      const double error = static_cast<double>(image_.w[farther]) - static_cast<double>(image_.w[between]);
      if (image_.w[between] > 0.0f && error > 0.0 && error * error * weight > residual2_) return true;
    }
    return false;
  }

  const InverseDepthImage& image_;
  int bridge_;
  double residual2_;
  const RegionMap& map_;
  RegionContacts contacts_;
  RegionPairLookup<Contact> contact_{contacts_};
  LastLabel left_;                ///< on this row, before the pixels without a label
  std::vector<LastLabel> above_;  ///< the same, per column
};

}  // namespace

RegionContacts findContacts(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map) {
  return ContactSearch(image, bridge, residual, map).search();
}

}  // namespace epcc
