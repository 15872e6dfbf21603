// SPDX-License-Identifier: BSD-3-Clause
// Small frames of every kind made of any bytes: planes with noise and odd values, or no sense at all.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/depth_frame.h"
#include "tests/fuzz/fuzz_input.h"

namespace epcc::fuzz {

/// Up to three planes n . p = 1, the nearest of which is seen.
struct FuzzScene {
  std::vector<Eigen::Vector3d> planes;

  static FuzzScene take(FuzzInput& input);
  /// Along the ray from a place; 0 if there is nothing.
  double distance(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) const;
};

/// The values of a frame and how they are read.
class FuzzFrame {
 public:
  enum class Kind { Depth, Millimetres, Cloud, Backward, Scan, FoundCloud, FoundScan, RawCloud };
  static constexpr int kKinds = 8;
  static constexpr int kMaxWidth = 32, kMaxHeight = 24;

  /// Kind, size and all that says how to read it; the pixels follow with fill().
  static FuzzFrame take(FuzzInput& input);
  /// A camera's depth image, as trackers and streams take it.
  static FuzzFrame takeDepth(FuzzInput& input);
  /// A cloud whose geometry is to be found, which takes longest.
  static FuzzFrame takeUnknownCloud(FuzzInput& input);
  /// What is seen from a place, with the bytes that are left as errors.
  void fill(const FuzzScene& scene, const Eigen::Isometry3d& camera_to_world, FuzzInput& input);

  /// Of a cloud whose geometry is found.
  const CloudGeometry& geometry() const { return *geometry_; }
  /// It lives as long as this.
  DepthFrame view() const;

  Kind kind = Kind::Depth;
  int width = 1;
  int height = 1;
  PinholeCamera camera;
  std::vector<float> values;  ///< depths, or points `stride` apart
  std::vector<std::uint16_t> millimetres;
  std::size_t stride = 3;

 private:
  void takeSize(FuzzInput& input);
  void takeReading(FuzzInput& input);
  void takeCloudPose(FuzzInput& input);
  Eigen::Vector3d ray(int row, int column) const;
  float withError(double value, FuzzInput& input);
  void store(std::size_t pixel, const Eigen::Vector3d& ray, double distance, FuzzInput& input);

  double unit_ = 1.0;   // of the values, metres
  double noise_ = 0.0;  // relative
  std::uint32_t random_ = 1;
  bool finds_geometry_ = false, transposed_ = false, closes_round_ = false, has_mask_ = false, has_options_ = false;
  std::vector<std::uint8_t> mask_;
  DepthOptions options_;
  CloudOptions cloud_options_;
  Eigen::Isometry3d cloud_pose_ = Eigen::Isometry3d::Identity();
  std::shared_ptr<CloudGeometry> geometry_;
};

}  // namespace epcc::fuzz
