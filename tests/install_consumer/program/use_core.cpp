// SPDX-License-Identifier: BSD-3-Clause
// The core alone: a rendered depth image of a wall and a floor gives two planes.
#include <epcc_segmentation/contours.h>
#include <epcc_segmentation/plane_extractor.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  epcc::PinholeCamera camera;
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 130.0;
  camera.cx = 79.5;
  camera.cy = 59.5;
  std::vector<float> depth;
  for (int row = 0; row < camera.height; ++row) {
    const double down = (row - camera.cy) / camera.fy;
    const double z = down > 0.3 ? 0.6 / down : 2.0;  // wall 2 m ahead, floor 0.6 m below
    depth.insert(depth.end(), static_cast<std::size_t>(camera.width), static_cast<float>(z));
  }
  epcc::PlaneExtractor extractor;
  epcc::PlaneSegmentation result;
  const bool done = extractor.extract(epcc::DepthFrame::fromDepth(depth.data(), camera), result);
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
