// SPDX-License-Identifier: BSD-3-Clause
// Samples are carried into the earlier frame, planes adapted to what is seen, then each sample is asked.
#include "inverse_depth/known_regions.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "inverse_depth/open_blocks.h"
#include "over_time/plane_motion.h"

namespace epcc {

namespace {

// Samples that tell where the camera is and how far each plane has moved: every so many of their rows.
constexpr int kAdaptingColumns = 2;

constexpr std::int32_t kNew = -2;  // instead of a label

/// Calls work(begin, end) for the parts of a row that have measured samples without a label, in whole blocks.
template <typename Work>
void forOpenParts(const std::int32_t* labels, const float* w, int width, const Work& work) {
  const auto isOpen = [&](int column) {
    int open = 0;
    if (column + kKnownBlock <= width)
      for (int k = column; k < column + kKnownBlock; ++k) open |= (labels[k] <= 0) & (w[k] > 0.0f);
    else
      for (int k = column; k < width; ++k) open |= (labels[k] <= 0) & (w[k] > 0.0f);
    return open != 0;
  };
  for (int begin = 0; begin < width; begin += kKnownBlock) {
    if (!isOpen(begin)) continue;
    int end = begin + kKnownBlock;
    while (end < width && isOpen(end)) end += kKnownBlock;
    work(begin, std::min(end, width));
    begin = end;
  }
}

}  // namespace

void KnownRegions::label(const InverseDepthImage& image, const KnownPlanes& known, const Rule& rule, RegionMap& map,
                         Continuation& continuation) {
  map.labels.assign(image.w.size(), 0);
  map.regions.assign(known.planes.size(), PlaneMoments());
  carried_.resize(known.views.size());
  // By the expected pose, then by the one that was found.
  for (std::size_t k = 0; k < carried_.size(); ++k) carried_[k].begin(image, known.views[k]);
  carryFrom(known, known.pose.camera_to_map);
  expect(known, known.pose);
  lookNear(image, rule);
  const UncertainPose found = alignPose(known.planes, seen_, known.pose, rule.error_scale).pose;
  carryFrom(known, found.camera_to_map);
  expect(known, found);
  lookNear(image, rule);
  adapt(rule);
  const AlignedPose aligned = alignPose(known.planes, seen_, known.pose, rule.error_scale);
  continuation.pose = aligned.pose;
  continuation.pose_information = aligned.information;
  continuation.squared_error = aligned.squared_error;
  labelSamples(image, map, continuation);
  if (known.search)
    for (std::int32_t& label : map.labels) label = std::max(label, 0);
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

void KnownRegions::carryFrom(const KnownPlanes& known, const Isometry3& pose) {
  for (std::size_t k = 0; k < carried_.size(); ++k) carried_[k].carryFrom(pose, known.views[k].camera_to_map);
}

// The samples that may be a plane's, as far as the expectation goes.
void KnownRegions::lookNear(const InverseDepthImage& image, const Rule& rule) {
  near_.assign(expected_.size(), PlaneMoments());
  for (int row = rule.row_step / 2; row < image.height; row += rule.row_step) lookNearInRow(image, row, rule);
  const double share = std::min(1.0, rule.row_step * kAdaptingColumns / std::max(1.0, rule.pixels_per_sample));
  seen_.assign(expected_.size() - 1, SeenPlane());
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    seen_[k].rays = share * near_[k + 1].rays;
    seen_[k].rays_w = share * near_[k + 1].rays_w;
    seen_[k].samples = share * near_[k + 1].n;
  }
}

// What the first view says, and where that shows no plane the next one.
const std::int32_t* KnownRegions::expectedInRow(const InverseDepthImage& image, int row) {
  row_expected_.assign(static_cast<std::size_t>(image.width), 0);
  for (CarriedLabels& carried : carried_)
    forOpenParts(row_expected_.data(), image.w.data() + image.index(row, 0), image.width, [&](int begin, int end) {
      const std::int32_t* planes = carried.planes(image, row, begin, end);
      std::int32_t* expected = row_expected_.data() + begin;
      for (int k = 0; k < end - begin; ++k) expected[k] = expected[k] > 0 ? expected[k] : planes[k];
    });
  return row_expected_.data();
}

void KnownRegions::lookNearInRow(const InverseDepthImage& image, int row, const Rule& rule) {
  const std::int32_t* const expected = expectedInRow(image, row);
  const auto gate = static_cast<float>(rule.max_residual * rule.max_residual);
  const auto v = static_cast<float>(image.along[static_cast<std::size_t>(row)]);
  for (int column = kAdaptingColumns / 2; column < image.width; column += kAdaptingColumns) {
    const std::int32_t label = expected[column];
    if (label <= 0) continue;
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
  adapted_.assign(expected_.size(), KnownRowPlane());
  for (std::size_t k = 1; k < expected_.size(); ++k) {
    const Expected& e = expected_[k];
    const Eigen::Vector3d q(static_cast<double>(e.x), static_cast<double>(e.y), static_cast<double>(e.z));
    const Eigen::Matrix3d& known = e.covariance;
    const SeenPlane& seen = seen_[k - 1];
    const Eigen::Vector3d change =
        known * (Eigen::Matrix3d::Identity() + seen.rays * known).inverse() * (seen.rays_w - seen.rays * q);
    const Eigen::Vector3d fitted = q + change;
    const double mean_w = near_[k].n > 0.0 ? near_[k].meanW() : std::abs(fitted.z());
    const double limit = rule.max_residual * rule.max_residual * slopeFactor(fitted, mean_w);
    adapted_[k] = {static_cast<float>(fitted.x()), static_cast<float>(fitted.y()), static_cast<float>(fitted.z()),
                   static_cast<float>(limit)};
  }
}

// What the first view says stands where the depth agrees, then what the next one says. What was no plane in the last
// view was segmented in vain, and is passed over.
void KnownRegions::labelSamples(const InverseDepthImage& image, RegionMap& map, Continuation& continuation) {
  continuation.from_first_view = continuation.from_views = 0;
  new_.clear();
  continuation.samples =
      static_cast<std::size_t>(std::count_if(image.w.begin(), image.w.end(), [](float w) { return w > 0.0f; }));
  for (std::size_t view = 0; view < carried_.size(); ++view) {
    std::size_t count = 0;
    for (int row = 0; row < image.height; ++row)
      count += takeLabels(image, row, view, map.labels.data() + image.index(row, 0));
    if (view == 0) continuation.from_first_view = count;
    continuation.from_views += count;
  }
  spread(image, map);
}

// Blocks that have all their labels are passed over.
std::size_t KnownRegions::takeLabels(const InverseDepthImage& image, int row, std::size_t view, std::int32_t* labels) {
  CarriedLabels& carried = carried_[view];
  const bool is_last = view + 1 == carried_.size();
  const auto along = static_cast<float>(image.along[static_cast<std::size_t>(row)]);
  const std::size_t first = image.index(row, 0);
  std::size_t count = 0;
  forOpenParts(labels, image.w.data() + first, image.width, [&](int begin, int end) {
    const std::size_t i = first + static_cast<std::size_t>(begin);
    const KnownRow part = {image.w.data() + i, image.weight.data() + i, carried.across() + begin, along, end - begin};
    const std::int32_t* const planes = carried.planes(image, row, begin, end);
    count += takeExpected(part, adapted_.data(), planes, labels + begin);
    if (is_last) markUnlabelled(part, planes, first + static_cast<std::size_t>(begin), labels + begin);
  });
  return count;
}

// As the last view has it: new, or no plane so far.
void KnownRegions::markUnlabelled(const KnownRow& part, const std::int32_t* planes, std::size_t first,
                                  std::int32_t* labels) {
  for (int k = 0; k < part.count; ++k) {
    if (labels[k] != 0 || planes[k] > 0 || !(part.w[k] > 0.0f)) continue;
    labels[k] = planes[k] == kUnseen ? kNew : kPassedOver;
    if (planes[k] == kUnseen) new_.push_back(first + static_cast<std::size_t>(k));
  }
}

// What is new beside a plane may be more of it: from the left and from above, then from the right and from below.
void KnownRegions::spread(const InverseDepthImage& image, RegionMap& map) const {
  const auto width = static_cast<std::size_t>(image.width);
  const auto takeFrom = [&](std::size_t sample, std::size_t beside) {
    const std::int32_t label = map.labels[beside];
    if (label <= 0) return;
    const KnownRowPlane& plane = adapted_[static_cast<std::size_t>(label)];
    const auto across = static_cast<float>(image.across[sample % width]);
    const auto along = static_cast<float>(image.along[sample / width]);
    const float residual = image.w[sample] - (plane.x * across + plane.y * along + plane.z);
    if (residual * residual * image.weight[sample] <= plane.max_square) map.labels[sample] = label;
  };
  for (auto i = new_.begin(); i != new_.end(); ++i) {
    if (*i % width > 0) takeFrom(*i, *i - 1);
    if (map.labels[*i] == kNew && *i >= width) takeFrom(*i, *i - width);
  }
  for (auto i = new_.rbegin(); i != new_.rend(); ++i) {
    if (map.labels[*i] == kNew && *i % width + 1 < width) takeFrom(*i, *i + 1);
    if (map.labels[*i] == kNew && *i + width < map.labels.size()) takeFrom(*i, *i + width);
    if (map.labels[*i] == kNew) map.labels[*i] = 0;
  }
}

}  // namespace epcc
