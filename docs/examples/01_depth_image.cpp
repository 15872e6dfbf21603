// SPDX-License-Identifier: BSD-3-Clause
// A depth image in memory, in metres: planes and labels. Needs Eigen alone.
#include <epcc_segmentation/plane_extractor.h>

#include <cstdio>

#include "room.h"

int main() {
  const epcc::PinholeCamera camera = example::camera();     // width, height, fx, fy, cx, cy in pixels
  const std::vector<float> depth = example::depthOfRoom();  // metres, row by row; 0 and NaN are "not measured"

  epcc::PlaneExtractor extractor;  // keep it: it reuses its memory, and measures the sensor over the frames
  epcc::PlaneSegmentation result;
  if (!extractor.extract(epcc::DepthFrame::fromDepth(depth.data(), camera), result)) {
    std::fprintf(stderr, "%s\n", extractor.error().c_str());
    return 1;
  }

  // (a, b, c, d): a x + b y + c z + d = 0; x right, y down, z forward, metres; the normal points to the camera.
  for (const epcc::Plane& plane : result.planes) {
    const auto& p = plane.coefficients;
    std::printf("%5zu pixels, normal (%5.2f %5.2f %5.2f), %.2f m away, rms %.0f mm\n", plane.pixel_count, p(0), p(1),
                p(2), p(3), 1000.0 * plane.rms);
  }
  // labels[row * width + column] is 0 for no plane, else k for planes[k - 1].
  std::printf("label of the pixel in row 200, column 160: %d\n", result.labels[200 * 320 + 160]);
}

// Prints:
//   48507 pixels, normal (-0.00 -0.00 -1.00), 3.00 m away, rms 9 mm
//   15678 pixels, normal (-0.00 -1.00 -0.00), 1.00 m away, rms 5 mm
//   12373 pixels, normal (-1.00 -0.00 -0.00), 1.50 m away, rms 7 mm
//   label of the pixel in row 200, column 160: 2
