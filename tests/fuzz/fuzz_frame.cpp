// SPDX-License-Identifier: BSD-3-Clause
// How bytes become frames.
#include "tests/fuzz/fuzz_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epcc::fuzz {

FuzzScene FuzzScene::take(FuzzInput& input) {
  FuzzScene scene;
  for (int i = input.number(0, 3); i > 0; --i) {
    const double x = input.small(), y = input.small();
    scene.planes.emplace_back(0.25 * x, 0.25 * y, 0.1 + std::abs(input.small()));
  }
  return scene;
}

double FuzzScene::distance(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& plane : planes) {
    const double at = (1.0 - plane.dot(from)) / plane.dot(ray);
    if (at > 0.0) nearest = std::min(nearest, at);
  }
  return std::isfinite(nearest) ? nearest : 0.0;
}

void FuzzFrame::takeSize(FuzzInput& input) {
  width = input.number(1, kMaxWidth);
  height = input.number(1, kMaxHeight);
  camera = {width, height, 0.6 * width, 0.6 * width, 0.5 * (width - 1), 0.5 * (height - 1)};
  if (!input.oneIn(8)) return;
  for (double* number : {&camera.fx, &camera.fy, &camera.cx, &camera.cy})
    if (input.oneIn(2)) *number = input.anyNumber();
}

void FuzzFrame::takeReading(FuzzInput& input) {
  noise_ = input.byte() / 4096.0;
  random_ = input.raw<std::uint16_t>() | 1U;
  if (input.oneIn(8)) unit_ = std::abs(input.anyNumber());
  transposed_ = input.oneIn(8);
  closes_round_ = input.oneIn(4);
  has_mask_ = input.oneIn(8);
  if (!input.oneIn(8)) return;
  has_options_ = true;
  options_.is_distance = input.oneIn(2);
  if (input.oneIn(2)) options_.invalid = input.anyNumber();
  options_.min_depth = cloud_options_.min_depth = input.anyNumber();
  options_.max_depth = cloud_options_.max_depth = input.anyNumber();
  cloud_options_.sensor = static_cast<CloudOptions::Sensor>(input.byte() % 3);
  if (input.oneIn(2)) cloud_options_.invalid = static_cast<float>(input.anyNumber());
  if (input.oneIn(2)) cloud_options_.unit = input.anyNumber();
  if (input.oneIn(2)) cloud_options_.projection = static_cast<Projection>(input.byte() % 3);
  if (!input.oneIn(2)) return;
  SensorPose viewpoint;
  viewpoint.origin = {input.anyNumber(), input.anyNumber(), input.anyNumber()};
  cloud_options_.viewpoint = viewpoint;
}

void FuzzFrame::takeCloudPose(FuzzInput& input) {
  stride = input.oneIn(4) ? 4 + input.byte() % 5 : 3;
  finds_geometry_ = finds_geometry_ || kind == Kind::FoundCloud || kind == Kind::FoundScan;
  if (!finds_geometry_) return;
  const Eigen::Vector3d axis{input.small(), input.small(), 1.0};  // braces: from left to right
  const double angle = input.small(), x = input.small(), y = input.small(), z = input.small();
  cloud_pose_ = Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(angle, axis.normalized());
}

FuzzFrame FuzzFrame::take(FuzzInput& input) {
  FuzzFrame frame;
  const int kind = input.byte() % 32;  // what takes long is rare
  frame.kind = static_cast<Kind>(kind < kKinds ? kind : kind % 5);
  frame.takeSize(input);
  frame.takeReading(input);
  frame.takeCloudPose(input);
  return frame;
}

FuzzFrame FuzzFrame::takeUnknownCloud(FuzzInput& input) {
  FuzzFrame frame;
  frame.kind = static_cast<Kind>(static_cast<int>(Kind::FoundCloud) + input.byte() % 3);
  frame.finds_geometry_ = true;
  frame.takeSize(input);
  frame.takeReading(input);
  frame.takeCloudPose(input);
  return frame;
}

FuzzFrame FuzzFrame::takeDepth(FuzzInput& input) {
  FuzzFrame frame;
  frame.takeSize(input);
  frame.takeReading(input);
  frame.transposed_ = false;
  return frame;
}

Eigen::Vector3d FuzzFrame::ray(int row, int column) const {
  if (kind != Kind::Scan && kind != Kind::FoundScan)
    return {(column - 0.5 * (width - 1)) / (0.6 * width), (row - 0.5 * (height - 1)) / (0.6 * width), 1.0};
  // x forward, y left, z up; the scene's planes lie along z and the others around it
  const double azimuth = 2.0 * M_PI * column / width, elevation = 0.4 - 0.8 * row / std::max(1, height - 1);
  return {std::cos(elevation) * std::cos(azimuth), -std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

/// A byte for each pixel: 0 as it is, up to 127 an error, then odd values; behind the end noise from a seed.
float FuzzFrame::withError(double value, FuzzInput& input) {
  random_ = random_ * 1664525U + 1013904223U;
  const double error = static_cast<double>(random_ >> 16) / 32768.0 - 1.0;
  const std::uint8_t byte = input.byte();
  if (byte == 255) return input.raw<float>();
  if (byte >= 128) return static_cast<float>(FuzzInput::odd(byte - 128));
  if (byte > 0) return static_cast<float>(value * (1.0 + (byte - 64) / 256.0));
  return static_cast<float>(value * (1.0 + noise_ * error) / unit_);
}

void FuzzFrame::store(std::size_t pixel, const Eigen::Vector3d& ray, double distance, FuzzInput& input) {
  if (kind == Kind::Depth) {
    values[pixel] = withError(distance, input);
    return;
  }
  if (kind == Kind::Millimetres) {
    const float value = 1000.0F * withError(distance, input);
    millimetres[pixel] = value > 0.0F && value < 65535.0F ? static_cast<std::uint16_t>(value) : std::uint16_t{65535};
    return;
  }
  float* const p = &values[pixel * stride];
  if (kind == Kind::RawCloud) {
    for (int k = 0; k < 3; ++k) p[k] = input.left() >= 4 ? input.raw<float>() : static_cast<float>(ray(k));
    return;
  }
  const auto along = static_cast<double>(withError(distance, input));
  Eigen::Vector3d point = along * ray;
  if (kind == Kind::Backward) point = Eigen::Vector3d(point.x(), -point.y(), -point.z());
  if (finds_geometry_) point = cloud_pose_ * point;
  const bool none = distance == 0.0 && along == 0.0;
  for (int k = 0; k < 3; ++k) p[k] = none ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(point(k));
}

void FuzzFrame::fill(const FuzzScene& scene, const Eigen::Isometry3d& camera_to_world, FuzzInput& input) {
  const auto pixels = static_cast<std::size_t>(width * height);
  if (kind == Kind::Millimetres)
    millimetres.assign(pixels, 0);
  else
    values.assign(pixels * (kind == Kind::Depth ? 1 : stride), 0.0F);
  mask_.assign(pixels, 1);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const auto pixel = static_cast<std::size_t>(row * width + column);
      const Eigen::Vector3d line = ray(row, column);
      if (has_mask_) mask_[pixel] = (row + column) % 5 == 0 ? 0 : 1;
      store(pixel, line, scene.distance(camera_to_world.translation(), camera_to_world.linear() * line), input);
    }
  geometry_.reset();
  if (finds_geometry_)
    geometry_ = std::make_shared<CloudGeometry>(
        findGeometry(values.data(), stride, width, height, has_options_ ? cloud_options_ : CloudOptions()));
}

DepthFrame FuzzFrame::view() const {
  const auto unmasked = [&]() {
    if (kind == Kind::Depth) return DepthFrame::fromDepth({values.data(), width, height, 0, unit_}, camera);
    if (kind == Kind::Millimetres)
      return DepthFrame::fromDepth({millimetres.data(), width, height, 0, 0.001 * unit_}, camera);
    if (geometry_) return DepthFrame::fromPoints(values.data(), stride, width, height, *geometry_);
    const Projection projection = kind == Kind::Scan       ? Projection::Spherical
                                  : kind == Kind::Backward ? Projection::PerspectiveBackward
                                                           : Projection::Perspective;
    return DepthFrame::fromPoints(values.data(), stride, width, height, projection);
  };
  DepthFrame frame = unmasked();
  if (has_options_ && frame.isPinhole()) frame = frame.readAs(options_);
  if (has_mask_) frame = frame.masked(mask_.data());
  if (closes_round_ && frame.projection() == Projection::Spherical) frame = frame.closedRound();
  return transposed_ ? frame.transposed() : frame;
}

}  // namespace epcc::fuzz
