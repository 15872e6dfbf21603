// SPDX-License-Identifier: BSD-3-Clause
// Walks along rows and columns from region to region.
#include "inverse_depth/region_contacts.h"

#include <algorithm>

namespace epcc {

void Contact::add(const InverseDepthImage& image, int row, int column, int other_row, int other_column) {
  const auto addRay = [&](int r, int c) {
    const double w = static_cast<double>(image.w[static_cast<std::size_t>(r) * image.width + c]);
    const Eigen::Vector3d ray = image.ray(r, c);
    rays.noalias() += (0.5 / image.variance(w, r) * ray) * ray.transpose();
  };
  ++count;
  addRay(row, column);
  addRay(other_row, other_column);
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

  RegionContacts search() {
    RegionContacts contacts;
    RegionPairLookup<Contact> contact(contacts);
    std::vector<LastLabel> above(static_cast<std::size_t>(image_.width));
    for (int row = 0; row < image_.height; ++row) {
      const std::int32_t* labels = map_.labels.data() + pixel(row, 0);
      LastLabel left;
      for (int column = 0; column < image_.width; ++column) {
        const std::int32_t label = labels[column];
        if (label == 0) continue;
        LastLabel& upper = above[static_cast<std::size_t>(column)];
        if (meets(left, label, column) && !seesBehind(pixel(row, left.place), pixel(row, column), 1, row))
          contact[{left.label, label}].add(image_, row, column, row, left.place);
        if (meets(upper, label, row) &&
            !seesBehind(pixel(upper.place, column), pixel(row, column), static_cast<std::size_t>(image_.width), row))
          contact[{upper.label, label}].add(image_, row, column, upper.place, column);
        left = {label, column};
        upper = {label, row};
      }
    }
    return contacts;
  }

 private:
  std::size_t pixel(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(column);
  }

  bool meets(const LastLabel& last, std::int32_t label, int place) const {
    return last.label != label && last.label != 0 && place - last.place <= bridge_ + 1;
  }

  /// Something between the two pixels lies farther away than both: a groove or a gap parts them.
  bool seesBehind(std::size_t first, std::size_t second, std::size_t step, int row) const {
    if (first + step == second) return false;
    const auto farther = static_cast<double>(std::min(image_.w[first], image_.w[second]));
    const double limit2 = residual2_ * image_.variance(farther, row);
    for (std::size_t between = first + step; between < second; between += step) {
      const double error = farther - static_cast<double>(image_.w[between]);
      if (image_.w[between] > 0.0f && error > 0.0 && error * error > limit2) return true;
    }
    return false;
  }

  const InverseDepthImage& image_;
  int bridge_;
  double residual2_;
  const RegionMap& map_;
};

}  // namespace

RegionContacts findContacts(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map) {
  return ContactSearch(image, bridge, residual, map).search();
}

}  // namespace epcc
