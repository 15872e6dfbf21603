// SPDX-License-Identifier: BSD-3-Clause
// An image of a driver as it lies in memory: 16-bit millimetres, rows padded. Nothing is copied.
#include <epcc_segmentation/plane_extractor.h>

#include <cmath>
#include <cstdint>
#include <cstdio>

#include "room.h"

int main() {
  const epcc::PinholeCamera camera = example::camera();
  const std::vector<float> metres = example::depthOfRoom();

  // Many drivers begin each row at a multiple of 64 bytes or more: here 320 values in rows of 384.
  constexpr int kRow = 384;
  std::vector<std::uint16_t> image(static_cast<std::size_t>(kRow * camera.height), 0);
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column)
      image[static_cast<std::size_t>(row * kRow + column)] =
          static_cast<std::uint16_t>(std::lround(1000.0f * metres[static_cast<std::size_t>(row * 320 + column)]));

  epcc::DepthView<std::uint16_t> view;
  view.data = image.data();
  view.width = camera.width;
  view.height = camera.height;
  view.row_stride = kRow * sizeof(std::uint16_t);  // bytes; 0, the default, says that rows adjoin
  view.scale = 0.001;                              // metres per unit, the default of 16-bit images

  epcc::PlaneExtractor extractor;
  epcc::PlaneSegmentation result;
  if (!extractor.extract(epcc::DepthFrame::fromDepth(view, camera), result)) return 1;
  for (const epcc::Plane& plane : result.planes)
    std::printf("%5zu pixels, %.2f m away\n", plane.pixel_count, plane.coefficients(3));

  // A view that does not fit the camera is an error with a name for programs and words for people.
  view.width = 160;
  if (!extractor.extract(epcc::DepthFrame::fromDepth(view, camera), result))
    std::printf("%s%s\n", extractor.status() == epcc::Status::SizeMismatch ? "SizeMismatch: " : "",
                extractor.error().c_str());
}

// Prints:
//   48501 pixels, 3.00 m away
//   15687 pixels, 1.00 m away
//   12375 pixels, 1.50 m away
//   SizeMismatch: the camera's size is not that of the depth image
