// SPDX-License-Identifier: BSD-3-Clause
// Walks along rows and columns from region to region.
#include "inverse_depth/region_contacts.h"

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

/// Adds up contacts. Borders come in runs, so the pair before is looked at first.
class ContactCollector {
 public:
  ContactCollector(const InverseDepthImage& image, const std::vector<std::int32_t>& labels, RegionContacts& contacts)
      : image_(image), labels_(labels), contacts_(contacts) {}

  /// Two labelled pixels that follow each other on a line.
  void meet(int row, int column, int other_row, int other_column) {
    const RegionPair pair(labelAt(row, column), labelAt(other_row, other_column));
    if (pair.low == pair.high) return;
    if (contact_ == nullptr || !(pair == pair_)) {
      pair_ = pair;
      contact_ = &contacts_[pair];  // stays where it is when others are added
    }
    contact_->add(image_, row, column, other_row, other_column);
  }

  std::int32_t labelAt(int row, int column) const {
    return labels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
                   static_cast<std::size_t>(column)];
  }

 private:
  const InverseDepthImage& image_;
  const std::vector<std::int32_t>& labels_;
  RegionContacts& contacts_;
  RegionPair pair_{0, 0};
  Contact* contact_ = nullptr;
};

}  // namespace

RegionContacts findContacts(const InverseDepthImage& image, int bridge, const RegionMap& map) {
  RegionContacts contacts;
  ContactCollector collector(image, map.labels, contacts);
  std::vector<int> last_row(static_cast<std::size_t>(image.width), -1);  // last labelled row of each column
  for (int row = 0; row < image.height; ++row) {
    int last_column = -1;
    for (int column = 0; column < image.width; ++column) {
      if (collector.labelAt(row, column) == 0) continue;
      if (last_column >= 0 && column - last_column <= bridge + 1) collector.meet(row, column, row, last_column);
      last_column = column;
      int& above = last_row[static_cast<std::size_t>(column)];
      if (above >= 0 && row - above <= bridge + 1) collector.meet(row, column, above, column);
      above = row;
    }
  }
  return contacts;
}

}  // namespace epcc
