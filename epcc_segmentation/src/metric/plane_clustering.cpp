// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 2 of the paper, one function a step.
#include "metric/plane_clustering.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "metric/segment_distance.h"
#include "metric/smallest_eigenvector.h"

namespace epcc {

namespace {
constexpr std::size_t kNoPlane = std::numeric_limits<std::size_t>::max();
constexpr double kBeyond = 1.0 + 1e-9;       // a cost that is larger than the limit, whatever the rounding
constexpr std::size_t kForgottenLines = 32;  // at once: what is kept has to move
constexpr double kMinMeanDistance = 1e-6;    // floor of mu_jd, metres: Eq. 26 is 0/0 at the start

// Eq. 26 of an endpoint at `ratio` times the mean distance.
double weightAt(double ratio, EndpointWeight form) {
  switch (form) {
    case EndpointWeight::Printed:
      return std::exp(-ratio * ratio);
    case EndpointWeight::Exponential:
      return std::exp(-ratio);
    case EndpointWeight::Gaussian:
      return std::exp(-0.5 * ratio * ratio);
    case EndpointWeight::Cauchy:
      return 1.0 / (1.0 + ratio * ratio);
    case EndpointWeight::Huber:
      return ratio > 1.0 ? 1.0 / ratio : 1.0;
    case EndpointWeight::None:
      break;
  }
  return 1.0;
}
}  // namespace

void PlanePrototype::add(const Eigen::Vector3d& endpoint, EndpointWeight form) {
  const double d = std::abs(distance(endpoint));
  ++distances;
  mean_distance += (d - mean_distance) / distances;
  statistics.add(endpoint, weightAt(d / std::max(mean_distance, kMinMeanDistance), form));
}

void PlanePrototype::refit() {
  // Eq. 25 shrinks the covariance by (k - 2)/(k - 1) and adds what has no negative eigenvalue; a little less, for the
  // variance was rounded.
  const double shrunk = (fitted - 1.0) / (statistics.n - 1.0);
  normal = smallestEigenvector(statistics.covariance, fitted > 1 ? 0.999 * shrunk * variance : 0.0);
  variance = varianceAlong(statistics.covariance, normal);
  fitted = statistics.n;
}

void PlaneClustering::configure(const PaperParameters& parameters, const SensorModel& sensor) {
  parameters_ = parameters;
  sensor_ = sensor;
  const PlaneCriterion form = parameters.criterion;
  with_sensor_ = form == PlaneCriterion::PrototypeSensorSegment || form == PlaneCriterion::PrototypeSensor ? 1.0 : 0.0;
  with_segment_ =
      form == PlaneCriterion::PrototypeSensorSegment || form == PlaneCriterion::PrototypeSegment ? 1.0 : 0.0;
  smallest_cosine_ = std::cos(parameters.expert.planes.max_start_angle * M_PI / 180.0);
}

void PlaneClustering::begin(Projection projection) {
  projection_ = projection;
  segments_.clear();
  labels_.clear();
  lines_.clear();
  planes_.clear();
  free_planes_.clear();
  last_refused_.clear();
}

void PlaneClustering::addLine(const std::vector<ClusteredLine>& line_segments) {
  const std::size_t line = lines_.size();
  lines_.push_back({segments_.size(), segments_.size() + line_segments.size()});
  for (const auto& line_segment : line_segments) segments_.push_back(makeSegment(line_segment));
  labels_.resize(segments_.size(), kUnlabelled);
  std::fill(last_refused_.begin(), last_refused_.end(), nullptr);  // the segments may have moved

  for (std::size_t i = lines_[line].begin; i < lines_[line].end; ++i) {
    const int plane = bestPlane(segments_[i], line);
    if (plane != kUnlabelled) {
      labels_[i] = plane;
      addToPlane(plane, segments_[i]);
      continue;
    }
    const std::size_t partner = startPartner(segments_[i], line);
    if (partner != kNoPlane) startPlane(partner, i);
  }
}

void PlaneClustering::finish() {
  for (auto& label : labels_)
    if (label >= 0 && planes_[static_cast<std::size_t>(label)].segments < parameters_.min_segments) label = kUnlabelled;
}

PlaneClustering::Segment PlaneClustering::makeSegment(const ClusteredLine& line_segment) const {
  const auto depth = [this](const Eigen::Vector3d& p) { return isPerspective(projection_) ? p.z() : p.norm(); };
  Segment segment;
  segment.a = line_segment.a;
  segment.b = line_segment.b;
  const double depth_a = depth(segment.a);
  const double depth_b = depth(segment.b);
  segment.ray_a = segment.a / depth_a;
  segment.ray_b = segment.b / depth_b;
  segment.sensor_variance_a = sensor_.varianceZ(depth_a);
  segment.sensor_variance_b = sensor_.varianceZ(depth_b);
  segment.low = std::min(segment.a.y(), segment.b.y());
  segment.high = std::max(segment.a.y(), segment.b.y());
  segment.variance = line_segment.prototype.variance;
  segment.reach = parameters_.max_gap + sensor_.sigmaZ(0.5 * (depth_a + depth_b));
  return segment;
}

// Eq. 23 with the variances of Table 2; the larger of the two endpoints decides. `limit` or more where it is not below.
double PlaneClustering::cost(const PlanePrototype& plane, const Segment& segment, double limit) const {
  const auto endpoint_cost = [&](const Eigen::Vector3d& h, const Eigen::Vector3d& ray, double sensor_variance) {
    const double d = plane.distance(h);
    const double q = plane.normal.dot(ray);
    const double variance =
        std::max(plane.variance + with_sensor_ * sensor_variance * q * q + with_segment_ * segment.variance, 1e-18);
    // Most are far beyond: the division is for those that are not.
    return d * d > kBeyond * limit * variance ? limit : d * d / variance;
  };
  const double cost_a = endpoint_cost(segment.a, segment.ray_a, segment.sensor_variance_a);
  if (cost_a >= limit) return limit;
  return std::max(cost_a, endpoint_cost(segment.b, segment.ray_b, segment.sensor_variance_b));
}

// Segments that lie apart along the scan lines alone by more than Eq. 27 allows.
bool PlaneClustering::isBeyondReach(const Segment& segment, const Segment& neighbour) {
  const double gap = std::max(neighbour.low - segment.high, segment.low - neighbour.high);
  return gap > kBeyond * segment.reach;
}

// Eq. 27. Segments of neighbouring lines mostly begin or end side by side, which says enough.
bool PlaneClustering::isWithinReach(const Segment& segment, const Segment& neighbour) {
  const double limit = segment.reach * segment.reach;
  const double at_ends = std::min((segment.a - neighbour.a).squaredNorm(), (segment.b - neighbour.b).squaredNorm());
  return kBeyond * at_ends <= limit || squaredSegmentDistance(segment.a, segment.b, neighbour.a, neighbour.b) <= limit;
}

// Labelled segments of the nearest earlier scan line that has one that fits; the best cost wins.
int PlaneClustering::bestPlane(const Segment& segment, std::size_t line) {
  const double limit = parameters_.plane_k_max * parameters_.plane_k_max;
  const auto look_back = std::min(line, static_cast<std::size_t>(parameters_.expert.planes.look_back));
  for (std::size_t back = 1; back <= look_back; ++back) {
    const Line& previous = lines_[line - back];
    double best_cost = limit;
    int best = kUnlabelled;
    for (std::size_t j = previous.begin; j < previous.end; ++j) {
      if (labels_[j] < 0 || isBeyondReach(segment, segments_[j])) continue;
      const auto plane = static_cast<std::size_t>(labels_[j]);
      if (last_refused_[plane] == &segment) continue;  // by another of its segments
      const double c = cost(planes_[plane], segment, best_cost);
      if (c >= limit) last_refused_[plane] = &segment;
      if (c >= best_cost) continue;
      if (!isWithinReach(segment, segments_[j])) continue;
      best_cost = c;
      best = labels_[j];
    }
    if (best != kUnlabelled) return best;
  }
  return kUnlabelled;
}

// The unlabelled earlier segment that is most nearly coplanar with this one.
std::size_t PlaneClustering::startPartner(const Segment& segment, std::size_t line) const {
  const Eigen::Vector3d direction = (segment.b - segment.a).normalized();
  const auto look_back = std::min(line, static_cast<std::size_t>(parameters_.expert.planes.pair_look_back));
  double best_ratio = 0.25 * parameters_.plane_k_max * parameters_.plane_k_max;
  std::size_t best = kNoPlane;
  for (std::size_t back = 1; back <= look_back; ++back) {
    const Line& previous = lines_[line - back];
    for (std::size_t j = previous.begin; j < previous.end; ++j) {
      if (labels_[j] != kUnlabelled || isBeyondReach(segment, segments_[j])) continue;
      const Segment& partner = segments_[j];
      const Eigen::Vector3d partner_vector = partner.b - partner.a;
      if (std::abs(direction.dot(partner_vector.normalized())) < smallest_cosine_) continue;
      const Eigen::Vector3d normal = partner_vector.cross(segment.a - partner.a).normalized();
      const double d = (segment.b - partner.a).dot(normal);
      const double q = normal.dot(segment.ray_b);
      const double ratio = d * d / std::max(segment.sensor_variance_b * q * q + segment.variance, 1e-18);
      if (ratio > best_ratio || (best != kNoPlane && ratio >= best_ratio)) continue;
      if (!isWithinReach(segment, partner)) continue;
      best_ratio = ratio;
      best = j;
    }
  }
  return best;
}

void PlaneClustering::addToPlane(int plane, const Segment& segment) {
  PlanePrototype& prototype = planes_[static_cast<std::size_t>(plane)];
  prototype.add(segment.a, parameters_.endpoint_weight);
  prototype.add(segment.b, parameters_.endpoint_weight);
  prototype.refit();
  ++prototype.segments;
}

// All four endpoints count alike: there is no prototype yet to take distances to.
void PlaneClustering::startPlane(std::size_t first, std::size_t second) {
  PlanePrototype prototype;
  const int plane = freePlace();
  for (const std::size_t i : {first, second}) {
    prototype.statistics.add(segments_[i].a);
    prototype.statistics.add(segments_[i].b);
    labels_[i] = plane;
  }
  prototype.refit();
  prototype.segments = 2;
  planes_[static_cast<std::size_t>(plane)] = prototype;
}

int PlaneClustering::freePlace() {
  if (!free_planes_.empty()) {
    const int plane = free_planes_.back();
    free_planes_.pop_back();
    return plane;
  }
  planes_.emplace_back();
  last_refused_.push_back(nullptr);
  return static_cast<int>(planes_.size()) - 1;
}

void PlaneClustering::release(int plane) {
  std::replace(labels_.begin(), labels_.end(), plane, kReleased);
  last_refused_[static_cast<std::size_t>(plane)] = nullptr;
  free_planes_.push_back(plane);
}

void PlaneClustering::forgetOldLines() {
  const auto kept = static_cast<std::size_t>(parameters_.expert.planes.look_back);
  if (lines_.size() < 2 * kept + kForgottenLines) return;
  const auto lines = static_cast<std::ptrdiff_t>(lines_.size() - kept);
  const std::size_t segments = lines_[static_cast<std::size_t>(lines)].begin;
  lines_.erase(lines_.begin(), lines_.begin() + lines);
  for (Line& line : lines_) {
    line.begin -= segments;
    line.end -= segments;
  }
  segments_.erase(segments_.begin(), segments_.begin() + static_cast<std::ptrdiff_t>(segments));
  labels_.erase(labels_.begin(), labels_.begin() + static_cast<std::ptrdiff_t>(segments));
}

}  // namespace epcc
