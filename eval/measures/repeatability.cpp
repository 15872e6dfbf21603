// SPDX-License-Identifier: BSD-3-Clause
// Pixels are carried from one view into the other, and regions compared by the pixels they share.
#include "eval/measures/repeatability.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace epcc {

namespace {

constexpr double kSameDepthMetres = 0.02;
constexpr double kSameDepthShare = 0.02;
constexpr double kFlatSigmas = 3.0;
constexpr long kFlatPercent = 85;

bool hasPercent(long part, long whole, long percent) {
  return 100 * part >= percent * whole;
}

/// The pixel of `view` that a point in its camera frame falls into, or -1.
std::int32_t pixelOf(const PosedView& view, const Eigen::Vector3d& point) {
  const PinholeCamera& camera = view.camera;
  if (!(point.z() > 0.0)) return -1;
  const double column = std::floor(camera.fx * point.x() / point.z() + camera.cx + 0.5);
  const double row = std::floor(camera.fy * point.y() / point.z() + camera.cy + 0.5);
  if (!(column >= 0.0 && column < camera.width && row >= 0.0 && row < camera.height)) return -1;
  return static_cast<std::int32_t>(row) * camera.width + static_cast<std::int32_t>(column);
}

bool showsTheSame(float depth, double expected) {
  return isMeasured(depth) && std::abs(depth - expected) <= kSameDepthMetres + kSameDepthShare * expected;
}

/// Shared pixels by label of the first frame, of the second, and by both.
struct SharedCounts {
  std::vector<long> from, to;
  std::map<std::pair<std::uint16_t, std::uint16_t>, long> both;  ///< both above 0
  long shared = 0, labelled = 0;
};

SharedCounts countShared(const std::vector<std::int32_t>& shared, const SeenRegions& from, const SeenRegions& to) {
  SharedCounts counts;
  counts.from.resize(from.planes.size() + 1);
  counts.to.resize(to.planes.size() + 1);
  long* last = nullptr;  // neighbours mostly have the same pair of labels
  std::pair<std::uint16_t, std::uint16_t> last_pair;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    if (shared[i] < 0) continue;
    const std::pair pair(from.labels.data[i], to.labels.data[static_cast<std::size_t>(shared[i])]);
    ++counts.shared;
    ++counts.from[pair.first];
    ++counts.to[pair.second];
    if (pair.first == 0 || pair.second == 0) continue;
    ++counts.labelled;
    if (last == nullptr || pair != last_pair) last = &counts.both[pair];
    last_pair = pair;
    ++*last;
  }
  return counts;
}

/// The region of the second frame that shares most with this one, the first of equal ones; 0 for none.
std::uint16_t partnerOf(std::uint16_t region, const SharedCounts& counts, long& overlap) {
  std::uint16_t partner = 0;
  overlap = 0;
  for (auto it = counts.both.lower_bound({region, 0}); it != counts.both.end() && it->first.first == region; ++it)
    if (it->second > overlap) {
      overlap = it->second;
      partner = it->first.second;
    }
  return partner;
}

bool isRepeated(std::uint16_t region, std::uint16_t partner, long overlap, const SharedCounts& counts) {
  return partner != 0 && hasPercent(overlap, counts.from[region], kRepeatedPercent) &&
         hasPercent(overlap, counts.to[partner], kRepeatedPercent);
}

void comparePlanes(const Plane& first, const Plane& second, const Eigen::Isometry3d& to_from, Repeatability& result) {
  const Eigen::Vector3d normal = to_from.linear() * Eigen::Vector3d(first.coefficients.head<3>());
  const Eigen::Vector3d other = second.coefficients.head<3>();
  const double angle = std::atan2(normal.cross(other).norm(), std::abs(normal.dot(other)));
  result.millidegrees.add(std::lround(1e3 * 180.0 / M_PI * angle));
  const double offset = second.signedDistance(to_from * Eigen::Vector3d(first.centroid));
  result.micrometres.add(std::lround(1e6 * std::abs(offset)));
}

}  // namespace

bool isMeasured(float depth) {
  return depth > 0.0F && std::isfinite(depth);
}

Eigen::Vector3d pointOf(const PosedView& view, int row, int column) {
  const PinholeCamera& camera = view.camera;
  const double z = view.depth.at(row, column);
  return {(column - camera.cx) / camera.fx * z, (row - camera.cy) / camera.fy * z, z};
}

SeenRegions seenRegions(const PosedView& view, const PlaneSegmentation& segmentation, const SensorModel& sensor) {
  const std::size_t pixels = view.depth.data.size();
  if (segmentation.labels.size() != pixels || segmentation.width != view.depth.width)
    throw std::invalid_argument("the segmentation has another size than the view");
  if (segmentation.planes.size() >= kIgnoreLabel) throw std::invalid_argument("more planes than labels can name");
  SeenRegions regions{LabelImage(view.depth.width, view.depth.height), segmentation.planes, {}};
  std::vector<long> counts(regions.planes.size() + 1), near(regions.planes.size() + 1);
  for (int row = 0; row < view.depth.height; ++row)
    for (int column = 0; column < view.depth.width; ++column) {
      const float depth = view.depth.at(row, column);
      const std::int32_t label =
          segmentation.labels[static_cast<std::size_t>(row) * static_cast<std::size_t>(view.depth.width) +
                              static_cast<std::size_t>(column)];
      if (label <= 0 || static_cast<std::size_t>(label) > regions.planes.size() || !isMeasured(depth)) continue;
      const auto region = static_cast<std::size_t>(label);
      regions.labels.at(row, column) = static_cast<std::uint16_t>(label);
      const double distance = regions.planes[region - 1].signedDistance(pointOf(view, row, column));
      ++counts[region];
      near[region] += std::abs(distance) <= kFlatSigmas * sensor.sigmaZ(depth) ? 1 : 0;
    }
  regions.flat.resize(counts.size());
  for (std::size_t region = 1; region < counts.size(); ++region)
    regions.flat[region] = counts[region] > 0 && hasPercent(near[region], counts[region], kFlatPercent);
  return regions;
}

std::vector<std::int32_t> sharedPixels(const PosedView& from, const PosedView& to) {
  const Eigen::Isometry3d to_from = to.pose.inverse() * from.pose;
  std::vector<std::int32_t> shared(from.depth.data.size(), -1);
  std::size_t i = 0;
  for (int row = 0; row < from.depth.height; ++row)
    for (int column = 0; column < from.depth.width; ++column, ++i) {
      if (!isMeasured(from.depth.data[i])) continue;
      const Eigen::Vector3d point = to_from * pointOf(from, row, column);
      const std::int32_t pixel = pixelOf(to, point);
      if (pixel >= 0 && showsTheSame(to.depth.data[static_cast<std::size_t>(pixel)], point.z())) shared[i] = pixel;
    }
  return shared;
}

Repeatability& Repeatability::operator+=(const Repeatability& other) {
  pairs += other.pairs;
  shared += other.shared;
  labelled += other.labelled;
  repeated_pixels += other.repeated_pixels;
  regions += other.regions;
  repeated += other.repeated;
  millidegrees += other.millidegrees;
  micrometres += other.micrometres;
  return *this;
}

Repeatability repeatability(const std::vector<std::int32_t>& shared, const SeenRegions& from, const SeenRegions& to,
                            const Eigen::Isometry3d& to_from) {
  const SharedCounts counts = countShared(shared, from, to);
  Repeatability result;
  result.pairs = 1;
  result.shared = counts.shared;
  result.labelled = counts.labelled;
  for (std::size_t region = 1; region < counts.from.size(); ++region) {
    if (counts.from[region] < kMinSharedPixels || !from.flat[region]) continue;
    ++result.regions;
    long overlap = 0;
    const std::uint16_t partner = partnerOf(static_cast<std::uint16_t>(region), counts, overlap);
    if (!isRepeated(static_cast<std::uint16_t>(region), partner, overlap, counts) || !to.flat[partner]) continue;
    ++result.repeated;
    result.repeated_pixels += counts.from[region];
    comparePlanes(from.planes[region - 1], to.planes[partner - 1U], to_from, result);
  }
  return result;
}

Repeatability repeatability(const PosedView& from_view, const SeenRegions& from, const PosedView& to_view,
                            const SeenRegions& to) {
  return repeatability(sharedPixels(from_view, to_view), from, to, to_view.pose.inverse() * from_view.pose);
}

}  // namespace epcc
