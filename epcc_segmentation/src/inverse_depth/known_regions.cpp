// SPDX-License-Identifier: BSD-3-Clause
// Samples are carried into the earlier frame, planes adapted to what is seen, then each sample is asked.
#include "inverse_depth/known_regions.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "over_time/plane_motion.h"

namespace epcc {

namespace {

// Samples that tell how far a plane has moved: every so many rows, and every so many of their samples.
constexpr int kAdaptingRows = 8, kAdaptingColumns = 2;
constexpr int kPoseLooks = 2;  // the labels are carried by the expected pose, then by the one that was found

constexpr int kBlock = 8;           // samples
constexpr int kEnoughOfBlock = 16;  // of 64

}  // namespace

void KnownRegions::label(const InverseDepthImage& image, const KnownPlanes& known, const Rule& rule, RegionMap& map,
                         Continuation& continuation) {
  map.labels.assign(image.w.size(), 0);
  map.regions.assign(known.planes.size(), PlaneMoments());
  carried_.resize(known.views.size());
  continuation.pose = known.pose;
  for (int look = 0; look < kPoseLooks; ++look) {
    expect(known, continuation.pose);
    lookNear(image, known, continuation.pose.camera_to_map, rule);
    const AlignedPose aligned = alignPose(known.planes, seen_, known.pose, rule.error_scale);
    continuation.pose = aligned.pose;
    continuation.pose_information = aligned.information;
    continuation.squared_error = aligned.squared_error;
  }
  expect(known, continuation.pose);
  lookNear(image, known, continuation.pose.camera_to_map, rule);
  adapt(rule);
  labelSamples(image, known, map, continuation);
  map.accumulate(image);
}

void KnownRegions::expect(const KnownPlanes& known, const UncertainPose& pose) {
  const Eigen::Isometry3d camera(pose.camera_to_map);
  expected_.assign(known.planes.size() + 1, Expected());
  for (std::size_t k = 0; k < known.planes.size(); ++k) {
    const Eigen::Vector4d plane = planeSeenFrom(camera, known.planes[k].coefficients);
    const Eigen::Matrix<double, 3, 4> by_plane = inverseByPlane(plane);
    const Eigen::Matrix<double, 3, 4> by_map = by_plane * camera.matrix().transpose();
    const Eigen::Matrix<double, 3, 6> by_pose = by_plane * planeByMotion(plane);
    Expected& e = expected_[k + 1];
    e.covariance = by_map * Eigen::Matrix4d(known.planes[k].covariance) * by_map.transpose() +
                   by_pose * Eigen::Matrix<double, 6, 6>(pose.covariance) * by_pose.transpose();
    const Eigen::Vector3f q = (-plane.head<3>() / plane(3)).cast<float>();
    e.x = q.x();
    e.y = q.y();
    e.z = q.z();
    const Eigen::Matrix3d& c = e.covariance;
    const double upper[6] = {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)};
    for (int i = 0; i < 6; ++i) e.c[i] = static_cast<float>(upper[i]);
    e.slope_factor = static_cast<float>(slopeFactor(q.cast<double>(), std::abs(static_cast<double>(q.z()))));
  }
}

void KnownRegions::beginCarrying(const InverseDepthImage& image, const KnownPlanes& known, const Isometry3& pose) {
  for (std::size_t k = 0; k < carried_.size(); ++k) carried_[k].begin(image, known.views[k], pose);
}

// The samples that may be a plane's, as far as the expectation goes.
void KnownRegions::lookNear(const InverseDepthImage& image, const KnownPlanes& known, const Isometry3& pose,
                            const Rule& rule) {
  beginCarrying(image, known, pose);
  near_.assign(expected_.size(), PlaneMoments());
  for (int row = kAdaptingRows / 2; row < image.height; row += kAdaptingRows)
    for (std::size_t view = carried_.size(); view-- > 0;) {
      lookNearInRow(image, row, rule, carried_[view]);
    }
  const double share = std::min(1.0, kAdaptingRows * kAdaptingColumns / std::max(1.0, rule.pixels_per_sample));
  seen_.assign(expected_.size() - 1, SeenPlane());
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    seen_[k].rays = share * near_[k + 1].rays;
    seen_[k].rays_w = share * near_[k + 1].rays_w;
    seen_[k].samples = share * near_[k + 1].n;
  }
}

void KnownRegions::lookNearInRow(const InverseDepthImage& image, int row, const Rule& rule, CarriedLabels& carried) {
  const std::int32_t* pixels = carried.pixels(image, row);
  const auto gate = static_cast<float>(rule.max_residual * rule.max_residual);
  const auto v = static_cast<float>(image.along[static_cast<std::size_t>(row)]);
  for (int column = kAdaptingColumns / 2; column < image.width; column += kAdaptingColumns) {
    const std::int32_t label = carried.planeAt(pixels[column]);
    if (label == 0) continue;
    const std::size_t i = image.index(row, column);
    const Expected& e = expected_[static_cast<std::size_t>(label)];
    const auto u = static_cast<float>(image.across[static_cast<std::size_t>(column)]);
    const float residual = image.w[i] - (e.x * u + e.y * v + e.z);
    const float place = u * (e.c[0] * u + 2.0f * (e.c[1] * v + e.c[2])) + v * (e.c[3] * v + 2.0f * e.c[4]) + e.c[5];
    const float variance = e.slope_factor / image.weight[i];
    if (residual * residual <= gate * (variance + place))
      near_[static_cast<std::size_t>(label)].add(image.ray(row, column), static_cast<double>(image.w[i]),
                                                 static_cast<double>(variance));
  }
}

// What is expected is one observation of the plane, the samples near it are another.
void KnownRegions::adapt(const Rule& rule) {
  for (std::size_t k = 1; k < expected_.size(); ++k) {
    Expected& e = expected_[k];
    const Eigen::Vector3d q(static_cast<double>(e.x), static_cast<double>(e.y), static_cast<double>(e.z));
    const Eigen::Matrix3d& known = e.covariance;
    const SeenPlane& seen = seen_[k - 1];
    const Eigen::Vector3d change =
        known * (Eigen::Matrix3d::Identity() + seen.rays * known).inverse() * (seen.rays_w - seen.rays * q);
    const Eigen::Vector3d fitted = q + change;
    e.x = static_cast<float>(fitted.x());
    e.y = static_cast<float>(fitted.y());
    e.z = static_cast<float>(fitted.z());
    const double mean_w = near_[k].n > 0.0 ? near_[k].meanW() : std::abs(fitted.z());
    e.slope_factor = static_cast<float>(slopeFactor(fitted, mean_w));
    e.max_square = static_cast<float>(rule.max_residual * rule.max_residual) * e.slope_factor;
  }
}

// What the first view says stands where the depth agrees, then what the next one says.
void KnownRegions::labelSamples(const InverseDepthImage& image, const KnownPlanes& known, RegionMap& map,
                                Continuation& continuation) {
  beginCarrying(image, known, continuation.pose.camera_to_map);
  continuation.from_first_view = continuation.from_views = 0;
  continuation.samples =
      static_cast<std::size_t>(std::count_if(image.w.begin(), image.w.end(), [](float w) { return w > 0.0f; }));
  for (std::size_t view = 0; view < carried_.size(); ++view) {
    std::size_t count = 0;
    for (int row = 0; row < image.height; ++row)
      count += takeLabels(image, row, carried_[view], map.labels.data() + image.index(row, 0));
    if (view == 0) continuation.from_first_view = count;
    continuation.from_views += count;
  }
}

std::size_t KnownRegions::takeLabels(const InverseDepthImage& image, int row, CarriedLabels& carried,
                                     std::int32_t* labels) const {
  const std::int32_t* pixels = carried.pixels(image, row);
  const float* across = carried.across();
  const auto along = static_cast<float>(image.along[static_cast<std::size_t>(row)]);
  const float* w = image.w.data() + image.index(row, 0);
  const float* weight = image.weight.data() + image.index(row, 0);
  std::size_t count = 0;
  for (int column = 0; column < image.width; ++column) {
    const std::int32_t label = carried.planeAt(pixels[column]);
    const Expected& e = expected_[static_cast<std::size_t>(label)];
    const float residual = w[column] - (e.x * across[column] + e.y * along + e.z);
    const bool stands = (labels[column] == 0) & (label != 0) & (residual * residual * weight[column] <= e.max_square);
    labels[column] = stands ? label : labels[column];
    count += stands ? 1 : 0;
  }
  return count;
}

// Single samples that miss their plane are of no surface: only blocks with enough of them, and those around, are
// segmented anew.
void KnownRegions::hideLabelled(InverseDepthImage& image, const RegionMap& map) {
  const int columns = (image.width + kBlock - 1) / kBlock, rows = (image.height + kBlock - 1) / kBlock;
  block_counts_.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  const auto block = [&](int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  };
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const std::size_t i = image.index(row, column);
      block_counts_[block(row / kBlock, column / kBlock)] += (map.labels[i] == 0) & (image.w[i] > 0.0f) ? 1 : 0;
    }
  all_w_ = image.w;
  for (int block_row = 0; block_row < rows; ++block_row)
    for (int block_column = 0; block_column < columns; ++block_column) {
      bool taken = false;
      for (int i = std::max(0, block_row - 1); i <= std::min(rows - 1, block_row + 1); ++i)
        for (int j = std::max(0, block_column - 1); j <= std::min(columns - 1, block_column + 1); ++j)
          taken |= block_counts_[block(i, j)] >= kEnoughOfBlock;
      const int end_row = std::min(image.height, (block_row + 1) * kBlock);
      const int end_column = std::min(image.width, (block_column + 1) * kBlock);
      for (int row = block_row * kBlock; row < end_row; ++row)
        for (int column = block_column * kBlock; column < end_column; ++column) {
          const std::size_t i = image.index(row, column);
          image.w[i] = taken && map.labels[i] == 0 ? image.w[i] : 0.0f;
        }
    }
}

void KnownRegions::showAll(InverseDepthImage& image) {
  image.w.swap(all_w_);
}

}  // namespace epcc
