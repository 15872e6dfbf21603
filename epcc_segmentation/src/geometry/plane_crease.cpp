// SPDX-License-Identifier: BSD-3-Clause
// The line of two planes in inverse depth, where it is linear in the ray.
#include "geometry/plane_crease.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace epcc {

namespace {
constexpr double kMaxResidual = 4.0;  // standard deviations that a gap's pixel may be off both planes
}

PlaneCrease::PlaneCrease(const PixelRays& rays, const SensorModel& sensor, const EdgeOptions& options,
                         const Eigen::Vector3d& q, const Eigen::Vector3d& other_q)
    : rays_(&rays),
      sensor_(&sensor),
      options_(&options),
      q_(q),
      difference_(q - other_q),
      mean_(0.5 * (q + other_q)),
      direction_(Eigen::Vector3d::Zero()),
      foot_(Eigen::Vector3d::Zero()) {
  const Eigen::Vector3d cross = q.cross(other_q);
  angle_ = std::atan2(cross.norm(), q.dot(other_q));
  if (!(angle_ > options.min_angle) || !(cross.norm() > 0.0)) return;
  direction_ = cross.normalized();
  // The points p of a plane have q . p = 1; the foot is that of the line nearest to the sensor.
  Eigen::Matrix3d equations;
  equations << q.transpose(), other_q.transpose(), direction_.transpose();
  foot_ = equations.inverse() * Eigen::Vector3d(1.0, 1.0, 0.0);
  exists_ = foot_.allFinite();
}

Eigen::Vector2d PlaneCrease::gradient(double column, double row) const {
  return {difference_.dot(rays_->rayByColumn(column)), difference_.dot(rays_->rayByRow(row))};
}

double PlaneCrease::offset(double column, double row) const {
  const double slope = gradient(column, row).norm();
  return slope > 0.0 ? difference_.dot(rays_->ray(column, row)) / slope : std::numeric_limits<double>::infinity();
}

bool PlaneCrease::isNear(double column, double row) const {
  const Eigen::Vector3d ray = rays_->ray(column, row);
  const double w = mean_.dot(ray);
  if (!exists_ || !(w > 0.0)) return false;
  const double slope = gradient(column, row).norm();
  const double step = std::abs(difference_.dot(ray));
  return step <= options_->place_pixels * slope + options_->max_step * rays_->sigma(*sensor_, ray, w) &&
         step <= options_->max_offset * slope;
}

Eigen::Vector3d PlaneCrease::nearestPoint(double column, double row) const {
  const Eigen::Vector2d slope = gradient(column, row);
  const double square = slope.squaredNorm();
  Eigen::Vector3d ray = rays_->ray(column, row);
  if (square > 0.0) {
    const Eigen::Vector2d move = -difference_.dot(ray) / square * slope;
    ray = rays_->ray(column + move.x(), row + move.y());
  }
  const double w = q_.dot(ray);
  const Eigen::Vector3d point = w > 0.0 ? Eigen::Vector3d(ray / w) : foot_;
  return foot_ + direction_.dot(point - foot_) * direction_;
}

const PlaneCrease* PlaneCreases::find(int first, int second) {
  const auto known = creases_.find({first, second});
  if (known != creases_.end()) return known->second.exists() ? &known->second : nullptr;
  const auto& q = planes_[static_cast<std::size_t>(first - 1)];
  const auto& other = planes_[static_cast<std::size_t>(second - 1)];
  if (!q || !other) return nullptr;
  const auto added = creases_.emplace(std::make_pair(first, second), PlaneCrease(rays_, sensor_, options_, *q, *other));
  return added.first->second.exists() ? &added.first->second : nullptr;
}

namespace {

/// A run of pixels without a label between two with one, along a row or a column.
struct Gap {
  int row, column;            // of the label before
  int row_step, column_step;  // from pixel to pixel
  int length;                 // pixels without a label
  std::int32_t before, after;
};

class GapBridge {
 public:
  GapBridge(const PixelRays& rays, const SensorModel& sensor, const EdgeOptions& options,
            const std::vector<std::optional<Eigen::Vector3d>>& planes, PlaneCreases& creases,
            std::vector<std::int32_t>& labels)
      : rays_(rays), sensor_(sensor), options_(options), planes_(planes), creases_(creases), labels_(labels) {}

  void bridge() {
    const std::vector<std::int32_t> given = labels_;
    for (int row = 0; row < rays_.height(); ++row) alongLine(given, row, 0, 0, 1, rays_.width());
    for (int column = 0; column < rays_.width(); ++column) alongLine(given, 0, column, 1, 0, rays_.height());
  }

 private:
  void alongLine(const std::vector<std::int32_t>& given, int row, int column, int row_step, int column_step,
                 int count) {
    int last = -1;
    std::int32_t last_label = 0;
    for (int i = 0; i < count; ++i) {
      const std::int32_t label = given[rays_.index(row + i * row_step, column + i * column_step)];
      if (label == 0) continue;
      const int length = i - last - 1;
      if (last >= 0 && length > 0 && length <= options_.max_gap && label != last_label)
        fill({row + last * row_step, column + last * column_step, row_step, column_step, length, last_label, label});
      last = i;
      last_label = label;
    }
  }

  void fill(const Gap& gap) {
    const PlaneCrease* crease = creases_.find(std::min(gap.before, gap.after), std::max(gap.before, gap.after));
    if (crease == nullptr) return;
    const auto offset = [&](int i) {
      return crease->offset(gap.column + i * gap.column_step, gap.row + i * gap.row_step);
    };
    const auto isNear = [&](int i) {
      return crease->isNear(gap.column + i * gap.column_step, gap.row + i * gap.row_step);
    };
    const double first = offset(0), last = offset(gap.length + 1);
    int of_before = 0;  // pixels of the gap that go to the label before
    if (first * last <= 0.0) {
      while (of_before < gap.length && offset(of_before + 1) * first > 0.0) ++of_before;
      if (!isNear(of_before) && !isNear(of_before + 1)) return;
    } else {  // the line is on one side of the gap: all of it is the other's
      of_before = std::abs(first) < std::abs(last) ? 0 : gap.length;
      if (!isNear(of_before == 0 ? 0 : gap.length + 1)) return;
    }
    for (int i = 1; i <= gap.length; ++i)
      if (!maySee(gap, i)) return;
    for (int i = 1; i <= gap.length; ++i) {
      std::int32_t& label = labels_[rays_.index(gap.row + i * gap.row_step, gap.column + i * gap.column_step)];
      if (label == 0) label = i <= of_before ? gap.before : gap.after;
    }
  }

  /// The pixel measured nothing, or something that one of the planes explains.
  bool maySee(const Gap& gap, int i) const {
    const int row = gap.row + i * gap.row_step, column = gap.column + i * gap.column_step;
    const auto w = static_cast<double>(rays_.measured(row, column));
    if (w <= 0.0) return true;
    const Eigen::Vector3d ray = rays_.ray(column, row);
    const double limit = kMaxResidual * rays_.sigma(sensor_, ray, w);
    for (const std::int32_t label : {gap.before, gap.after})
      if (std::abs(planes_[static_cast<std::size_t>(label - 1)]->dot(ray) - w) <= limit) return true;
    return false;
  }

  const PixelRays& rays_;
  const SensorModel& sensor_;
  const EdgeOptions& options_;
  const std::vector<std::optional<Eigen::Vector3d>>& planes_;
  PlaneCreases& creases_;
  std::vector<std::int32_t>& labels_;
};

}  // namespace

void bridgeGaps(const PixelRays& rays, const SensorModel& sensor, const EdgeOptions& options,
                const std::vector<std::optional<Eigen::Vector3d>>& planes, PlaneCreases& creases,
                std::vector<std::int32_t>& labels) {
  if (options.max_gap > 0) GapBridge(rays, sensor, options, planes, creases, labels).bridge();
}

}  // namespace epcc
