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
  int count = 0;  ///< places
  /// Sum of ray ray^T / sigma^2 over them; it is symmetric.
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  /// Adds one place, between two pixels.
  void add(const InverseDepthImage& image, int row, int column, int other_row, int other_column);
  Contact& operator+=(const Contact& other);
  /// Sum of (q . ray)^2 / sigma^2 over the places.
  double squares(const Eigen::Vector3d& q) const;
};

/// The contacts of pairs of regions. Keeps its memory from frame to frame.
class RegionContacts {
 public:
  void clear();
  Contact& operator[](const RegionPair& pair) {
    const auto number = static_cast<std::size_t>(table.add(pair));
    if (number == contacts.size()) contacts.emplace_back();
    return contacts[number];
  }
  /// That of a pair, null if it has none.
  const Contact* find(const RegionPair& pair) const;

  RegionPairTable table;          ///< their numbers
  std::vector<Contact> contacts;  ///< by number
};

/// What the search for contacts remembers of the lines, kept from frame to frame.
struct ContactSearchMemory {
  RowBorders borders;
  std::vector<int> last_row;  ///< per column: the last row with a label above the pixels without one
};

/// Regions whose labels follow each other on a row or column across at most `bridge` unlabelled pixels, none of which
/// lies farther away than both by more than `residual` sigma: a groove separates surfaces even if they are coplanar.
void findContacts(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map,
                  ContactSearchMemory& memory, RegionContacts& contacts);

/// What the search for occluded contacts remembers of the lines, kept from frame to frame.
struct OcclusionMemory {
  struct Plane {
    double x = 0.0, y = 0.0, z = 0.0;  ///< q
    double max_square = 0.0;           ///< of a residual on the plane
  };
  struct Begin {
    int row, line;
  };
  std::vector<Plane> planes;             ///< per label
  RowBorders borders;
  std::vector<int> begins;               ///< of the runs on a line
  std::vector<Begin> begins_on_columns;  ///< in the order of rows
  std::vector<int> sorted_begins;        ///< their rows, in that of columns
  std::vector<int> first_of_column;      ///< in sorted_begins
};

/// Regions that face each other on a row or column across something nearer than the plane of the longer run by more
/// than `residual` sigma, which takes no more pixels than max_occluder times those of the two, with nothing farther
/// away between them. They may be one surface behind an occluder.
void findOccludedContacts(const InverseDepthImage& image, double max_occluder, double residual, const RegionMap& map,
                          OcclusionMemory& memory, RegionContacts& contacts);

}  // namespace epcc
