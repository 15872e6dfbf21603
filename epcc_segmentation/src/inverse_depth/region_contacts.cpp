// SPDX-License-Identifier: BSD-3-Clause
// Walks along rows and columns from region to region.
#include "inverse_depth/region_contacts.h"

namespace epcc {

void Contact::add(const InverseDepthImage& image, int row, int column, int other_row, int other_column) {
  const auto weighted = [&image](int r, int c) -> Eigen::Matrix3d {
    const double w = static_cast<double>(image.w[static_cast<std::size_t>(r) * image.width + c]);
    const Eigen::Vector3d ray = image.ray(r, c);
    return ray * ray.transpose() / image.variance(w, r);
  };
  ++count;
  rays += 0.5 * (weighted(row, column) + weighted(other_row, other_column));
}

namespace {

/// Collects, along one line of pixels, the label changes across at most `bridge` unlabelled pixels.
class ContactCounter {
 public:
  ContactCounter(const InverseDepthImage& image, int bridge, RegionContacts& contacts)
      : image_(image), bridge_(bridge), contacts_(contacts) {}

  void add(int row, int column, int position, std::int32_t label) {
    if (label == 0) return;
    if (last_label_ != 0 && last_label_ != label && position - last_position_ <= bridge_ + 1) {
      Contact& contact = contacts_[RegionPair(label, last_label_)];
      contact.add(image_, row, column, last_row_, last_column_);
    }
    last_label_ = label;
    last_position_ = position;
    last_row_ = row;
    last_column_ = column;
  }

 private:
  const InverseDepthImage& image_;
  int bridge_;
  RegionContacts& contacts_;
  std::int32_t last_label_ = 0;
  int last_position_ = 0;
  int last_row_ = 0;
  int last_column_ = 0;
};

}  // namespace

RegionContacts findContacts(const InverseDepthImage& image, int bridge, const RegionMap& map) {
  RegionContacts contacts;
  std::vector<ContactCounter> columns(static_cast<std::size_t>(image.width), ContactCounter(image, bridge, contacts));
  for (int row = 0; row < image.height; ++row) {
    ContactCounter along_row(image, bridge, contacts);
    for (int column = 0; column < image.width; ++column) {
      const std::int32_t label = map.labels[static_cast<std::size_t>(row) * image.width + column];
      along_row.add(row, column, column, label);
      columns[static_cast<std::size_t>(column)].add(row, column, row, label);
    }
  }
  return contacts;
}

}  // namespace epcc
