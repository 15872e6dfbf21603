// SPDX-License-Identifier: BSD-3-Clause
// The order of a scanner's rings and columns in a cloud.
#pragma once

#include "epcc_segmentation/cloud_geometry.h"
#include "geometry/ray_tables.h"

namespace epcc {

/// Whether the scan closes, which columns of each ring have one azimuth, and the order of the rings by elevation, from
/// the tables of a scanner that was measured last on the lattice. Rings between those of the lattice lie between them.
ScanGrid scanGrid(const PointLattice& lattice, const CloudView& cloud, const PoseHypothesis& pose,
                  const RayTables& tables);

}  // namespace epcc
