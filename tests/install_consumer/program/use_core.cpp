// SPDX-License-Identifier: BSD-3-Clause
// The core alone: a rendered depth image of a wall and a floor gives two planes.
#include <epcc_segmentation/contours.h>
#include <epcc_segmentation/plane_extractor.h>

#include <cmath>
#include <cstdio>

#include "wall_and_floor.h"

int main() {
  const WallAndFloor room;
  epcc::PlaneExtractor extractor;
  epcc::PlaneSegmentation result;
  const bool done = extractor.extract(room.frame(), result);
  const auto contours =
      epcc::traceAllContours(result.labels, result.width, result.height, static_cast<int>(result.planes.size()));
  // The library's numbers are read as it wrote them, whatever flags this is built with.
  for (const epcc::Plane& plane : result.planes) {
    const bool is_wall = std::abs(plane.coefficients(2)) > 0.9;
    if (std::abs(plane.coefficients(3) - (is_wall ? 2.0 : 0.6)) > 0.01) return 2;
    if (!(plane.signedDistance(plane.centroid) < 1e-6) || !(plane.rms < 1e-3) || plane.pixel_count < 1000) return 3;
  }
  std::printf("%zu planes, %zu with an outline %s\n", result.planes.size(), contours.size(), extractor.error().c_str());
  return done && result.planes.size() == 2 ? 0 : 1;
}
