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

/// The labelled pixel last seen on a line.
struct LastLabel {
  std::int32_t label = 0;  ///< 0: none yet
  int place = 0;
};

}  // namespace

RegionContacts findContacts(const InverseDepthImage& image, int bridge, const RegionMap& map) {
  RegionContacts contacts;
  RegionPairLookup<Contact> contact(contacts);
  const auto meets = [bridge](const LastLabel& last, std::int32_t label, int place) {
    return last.label != label && last.label != 0 && place - last.place <= bridge + 1;
  };
  std::vector<LastLabel> above(static_cast<std::size_t>(image.width));
  for (int row = 0; row < image.height; ++row) {
    const std::int32_t* labels = map.labels.data() + static_cast<std::size_t>(row) * image.width;
    LastLabel left;
    for (int column = 0; column < image.width; ++column) {
      const std::int32_t label = labels[column];
      if (label == 0) continue;
      LastLabel& upper = above[static_cast<std::size_t>(column)];
      if (meets(left, label, column)) contact[{left.label, label}].add(image, row, column, row, left.place);
      if (meets(upper, label, row)) contact[{upper.label, label}].add(image, row, column, upper.place, column);
      left = {label, column};
      upper = {label, row};
    }
  }
  return contacts;
}

}  // namespace epcc
