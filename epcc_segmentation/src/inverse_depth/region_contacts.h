// SPDX-License-Identifier: BSD-3-Clause
// Which regions may be one surface: neighbours in the image, and regions seen on both sides of an occluder.
#pragma once

#include <cstdint>
#include <vector>

#include "inverse_depth/label_borders.h"
#include "inverse_depth/region_map.h"
#include "inverse_depth/region_pairs.h"

namespace epcc {

/// Where two regions meet.
struct Contact {
  int count = 0;        ///< places
  double rays[6] = {};  ///< sum of ray ray^T / sigma^2 over them, the upper triangle: xx, xy, xz, yy, yz, zz

  /// Adds one place: its weight 1/sigma^2 and its ray.
  void add(double weight, double x, double y, double z) {
    const double wx = weight * x, wy = weight * y, wz = weight * z;
    const double products[6] = {wx * x, wx * y, wx * z, wy * y, wy * z, wz * z};
    for (int k = 0; k < 6; ++k) rays[k] += products[k];
    ++count;
  }
  /// The place between two pixels.
  void add(const InverseDepthImage& image, int row, int column, int other_row, int other_column);
  Contact& operator+=(const Contact& other);
  /// Sum of (q . ray)^2 / sigma^2 over the places.
  double squares(const Eigen::Vector3d& q) const;
};

inline void Contact::add(const InverseDepthImage& image, int row, int column, int other_row, int other_column) {
  const auto weightAt = [&image](int r, int c) { return static_cast<double>(image.weight[image.index(r, c)]); };
  const auto middle = [](const std::vector<double>& coordinate, int i, int j) {
    return 0.5 * (coordinate[static_cast<std::size_t>(i)] + coordinate[static_cast<std::size_t>(j)]);
  };
  const double weight = 0.5 * (weightAt(row, column) + weightAt(other_row, other_column));
  const double x = middle(image.across, column, other_column);
  const double y = middle(image.along, row, other_row);
  const double z = middle(image.forward, column, other_column);
  add(weight, x, y, z);
}

/// The contacts of pairs of regions. Keeps its memory from frame to frame.
class RegionContacts {
 public:
  void clear();
  Contact& operator[](const RegionPair& pair) {
    const auto number = static_cast<std::size_t>(table.add(pair));
    if (number == contacts.size()) contacts.emplace_back();
    return contacts[number];
  }
  /// Pairs that are new get their numbers in the order of the other's.
  RegionContacts& operator+=(const RegionContacts& other);
  /// That of a pair, null if it has none.
  const Contact* find(const RegionPair& pair) const;

  RegionPairTable table;          ///< their numbers
  std::vector<Contact> contacts;  ///< by number
};

/// What the search for contacts remembers of a band's lines, kept from frame to frame.
struct ContactSearchMemory {
  RegionContacts contacts;  ///< of a band of rows that is not the first
  RowBorders borders;
  RowBits upper_labelled;         ///< of the row above
  PixelList left, above;          ///< pixels whose neighbour has another label
  PixelList left_gap, above_gap;  ///< pixels whose neighbour has none
  PixelList ends;                 ///< pixels without a label below one with
  std::vector<int> last_row;      ///< per column: the last row with a label above the pixels without one
};

/// Regions whose labels follow each other on a row or column across at most `bridge` unlabelled pixels, none of which
/// lies farther away than both by more than `residual` sigma: a groove separates surfaces even if they are coplanar.
void findContacts(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map,
                  std::vector<ContactSearchMemory>& memory, RegionContacts& contacts, int threads = 1);

/// What the search for occluded contacts remembers of the lines, kept from frame to frame.
struct OcclusionMemory {
  struct Plane {
    double x = 0.0, y = 0.0, z = 0.0;  ///< q
    double max_square = 0.0;           ///< of a residual on the plane
  };
  struct Begin {
    int row, line;
  };
  struct Place {
    int row, column, other_row, other_column;
    int hidden;  ///< pixels between the two
  };
  /// A band of lines.
  struct Band {
    RowBits left, above;
    PixelList columns;
    std::vector<int> begins;                 ///< of the runs on a line
    std::vector<std::int32_t> labels;        ///< of the runs on a line
    std::vector<Begin> begins_on_columns;    ///< in the order of rows
    std::vector<Place> on_rows, on_columns;  ///< where regions face each other
  };
  std::vector<Plane> planes;  ///< per label
  std::vector<Band> bands;
  std::vector<int> sorted_begins;    ///< rows of the beginnings on columns, in the order of columns
  std::vector<int> first_of_column;  ///< in sorted_begins
};

/// Regions that face each other on a row or column across something nearer than the plane of the longer run by more
/// than `residual` sigma, which takes no more pixels than max_occluder times those of the two, with nothing farther
/// away between them. They may be one surface behind an occluder. Across at most `bridge` pixels they are neighbours,
/// as findContacts() has them: such places count too, but only of regions that face each other across more somewhere.
void findOccludedContacts(const InverseDepthImage& image, int bridge, double max_occluder, double residual,
                          const RegionMap& map, OcclusionMemory& memory, RegionContacts& contacts, int threads = 1);

}  // namespace epcc
