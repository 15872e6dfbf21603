// SPDX-License-Identifier: BSD-3-Clause
// A robot drives towards a wall: the planes keep their numbers, and the map its place, although odometry jumps.
#include "12_tracking_node.h"

#include <cstdio>
#include <cstring>

#include "room.h"

namespace {

/// As sensor_msgs/Image and sensor_msgs/CameraInfo.
struct Image {
  std::uint32_t height, width;
  std::string encoding;
  std::uint32_t step;  // bytes of a row
  std::vector<std::uint8_t> data;
};
struct CameraInfo {
  std::uint32_t height, width;
  double k[9];
};

/// The room from a camera that is nearer to the wall ahead.
Image depthImage(double forward, unsigned seed) {
  const std::vector<float> depth = example::depthOfRoom(seed, forward);
  Image image{240, 320, "32FC1", 320 * sizeof(float), {}};
  image.data.resize(image.step * image.height);
  std::memcpy(image.data.data(), depth.data(), image.data.size());
  return image;
}

}  // namespace

int main() {
  const epcc::PinholeCamera c = example::camera();
  const CameraInfo info{240, 320, {c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}};
  int frame = 0;
  example::TrackingNode node(
      [&frame](const example::PlaneMessage& message) {
        if (message.pose_jumped) std::printf("frame %2d: odometry has jumped\n", frame);
        if (frame % 5 != 4) return;
        std::printf("frame %2d: the camera is %.2f m ahead;", frame, message.camera_to_map.translation().z());
        for (const auto& plane : message.planes)
          std::printf(" plane %d %.2f m away", static_cast<int>(plane.label), plane.coefficients(3));
        std::printf("\n");
      },
      [](const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); });
  for (; frame < 20; ++frame) {
    const double forward = 0.02 * frame;
    epcc::Isometry3 odometry = epcc::Isometry3::Identity();
    odometry.translation().z() = forward + (frame < 12 ? 0.0 : 0.5);  // a wheel slips
    node.onDepth(depthImage(forward, static_cast<unsigned>(frame)), info, frame / 30.0, odometry);
  }
}

// Prints:
//   frame  4: the camera is 0.08 m ahead; plane 1 2.92 m away plane 2 1.00 m away plane 3 1.50 m away
//   frame  9: the camera is 0.18 m ahead; plane 1 2.82 m away plane 2 1.00 m away plane 3 1.50 m away
//   frame 12: odometry has jumped
//   frame 14: the camera is 0.28 m ahead; plane 1 2.72 m away plane 2 1.00 m away plane 3 1.50 m away
//   frame 19: the camera is 0.38 m ahead; plane 1 2.62 m away plane 2 1.00 m away plane 3 1.50 m away
