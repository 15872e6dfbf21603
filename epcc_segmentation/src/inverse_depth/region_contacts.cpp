// SPDX-License-Identifier: BSD-3-Clause
// Finds neighbouring regions at the borders of the labels.
#include "inverse_depth/region_contacts.h"

#include <algorithm>

namespace epcc {

void Contact::add(const InverseDepthImage& image, int row, int column, int other_row, int other_column) {
  const auto weightAt = [&image](int r, int c) { return static_cast<double>(image.weight[image.index(r, c)]); };
  const auto middle = [](const std::vector<double>& coordinate, int i, int j) {
    return 0.5 * (coordinate[static_cast<std::size_t>(i)] + coordinate[static_cast<std::size_t>(j)]);
  };
  const double weight = 0.5 * (weightAt(row, column) + weightAt(other_row, other_column));
  const double x = middle(image.across, column, other_column);
  const double y = middle(image.along, row, other_row);
  const double z = middle(image.forward, column, other_column);
  ++count;
  xx += weight * x * x;
  xy += weight * x * y;
  xz += weight * x * z;
  yy += weight * y * y;
  yz += weight * y * z;
  zz += weight * z * z;
}

Contact& Contact::operator+=(const Contact& other) {
  count += other.count;
  xx += other.xx;
  xy += other.xy;
  xz += other.xz;
  yy += other.yy;
  yz += other.yz;
  zz += other.zz;
  return *this;
}

double Contact::squares(const Eigen::Vector3d& q) const {
  return q.x() * (xx * q.x() + xy * q.y() + xz * q.z()) + q.y() * (xy * q.x() + yy * q.y() + yz * q.z()) +
         q.z() * (xz * q.x() + yz * q.y() + zz * q.z());
}

void RegionContacts::clear() {
  table.clear();
  contacts.clear();
}

const Contact* RegionContacts::find(const RegionPair& pair) const {
  const int number = table.numberOf(pair);
  return number < 0 ? nullptr : &contacts[static_cast<std::size_t>(number)];
}

namespace {

/// Finds where labels follow each other on a row or column. Inside a region nothing needs to be looked at: each row
/// tells by bits where a label begins or ends, to the left and above.
class ContactSearch {
 public:
  ContactSearch(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map,
                ContactSearchMemory& memory, RegionContacts& contacts)
      : image_(image),
        bridge_(bridge),
        residual2_(residual * residual),
        labels_(map.labels.data()),
        borders_(memory.borders),
        last_row_(memory.last_row),
        contacts_(contacts) {}

  void search() {
    borders_.resize(image_.width);
    last_row_.assign(static_cast<std::size_t>(image_.width), -bridge_ - 2);  // out of reach
    for (int row = 0; row < image_.height; ++row) {
      markBorders(labels_, image_.width, row, borders_);
      last_column_ = -bridge_ - 2;
      for (std::size_t word = 0; word < borders_.left.size(); ++word) {
        const int place = static_cast<int>(word) * 64;
        const std::uint64_t labelled = borders_.labelled[word];
        forEachBit(borders_.left[word], place, [&](int column) { meetLeft(row, column); });
        forEachBit(borders_.above[word] & ~labelled, place,
                   [&](int column) { last_row_[static_cast<std::size_t>(column)] = row - 1; });
        forEachBit(borders_.above[word] & labelled, place, [&](int column) { meetAbove(row, column); });
      }
    }
  }

 private:
  std::int32_t labelAt(int row, int column) const { return labels_[image_.index(row, column)]; }

  void meetLeft(int row, int column) {
    if (labelAt(row, column - 1) != 0) last_column_ = column - 1;
    if (labelAt(row, column) != 0 && column - last_column_ <= bridge_ + 1) meet(row, column, row, last_column_, 1);
  }

  void meetAbove(int row, int column) {
    const bool touches = labelAt(row - 1, column) != 0;
    const int upper_row = touches ? row - 1 : last_row_[static_cast<std::size_t>(column)];
    if (row - upper_row <= bridge_ + 1) meet(row, column, upper_row, column, static_cast<std::size_t>(image_.width));
  }

  void meet(int row, int column, int other_row, int other_column, std::size_t step) {
    const std::int32_t label = labelAt(row, column);
    const std::int32_t other = labelAt(other_row, other_column);
    if (label == other || seesBehind(image_.index(other_row, other_column), image_.index(row, column), step)) return;
    contacts_[{other, label}].add(image_, row, column, other_row, other_column);
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
  const std::int32_t* labels_;
  RowBorders& borders_;
  std::vector<int>& last_row_;
  int last_column_ = 0;  ///< the same, on this row
  RegionContacts& contacts_;
};

}  // namespace

void findContacts(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map,
                  ContactSearchMemory& memory, RegionContacts& contacts) {
  contacts.clear();
  ContactSearch(image, bridge, residual, map, memory, contacts).search();
}

}  // namespace epcc
