// SPDX-License-Identifier: BSD-3-Clause
// Linear first guesses, then Levenberg and Marquardt's steps on axis and place.
#include "geometry/scanner_pose.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "quantile.h"

namespace epcc {

namespace {

constexpr int kParameters = 5;
constexpr int kMaxSteps = 30;
constexpr double kStepOfDerivative = 1e-5;
constexpr double kOutlierRatio = 5.0;  // times the median residual
using Step = Eigen::Matrix<double, kParameters, 1>;

std::size_t ringOf(const PointLattice::Point& point, bool rings_are_columns) {
  return static_cast<std::size_t>(rings_are_columns ? point.column : point.row);
}
std::size_t columnOf(const PointLattice::Point& point, bool rings_are_columns) {
  return static_cast<std::size_t>(rings_are_columns ? point.row : point.column);
}

struct Scatter {
  double n = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& p) {
    n += 1.0;
    first += p;
    second += p * p.transpose();
  }
  Eigen::Matrix3d aboutMean() const {
    return n > 0.0 ? Eigen::Matrix3d(second - first * first.transpose() / n) : Eigen::Matrix3d::Zero();
  }
};

/// The signed axes of the cloud's frame come first: where the axis points up, so do z and y.
Eigen::Vector3d upwards(const Eigen::Vector3d& axis) {
  int largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis(largest) < 0.0 ? Eigen::Vector3d(-axis) : axis;
}

double halfTurnAtMost(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

/// Residuals of azimuth and elevation after the tables, which are the means of what is left, are taken out.
class TableResiduals {
 public:
  TableResiduals(const PointLattice& lattice, bool rings_are_columns)
      : lattice_(lattice), rings_are_columns_(rings_are_columns) {
    const std::size_t rows = lattice.rows().size(), columns = lattice.columns().size();
    rings_ = rings_are_columns ? columns : rows;
    columns_ = rings_are_columns ? rows : columns;
  }

  void operator()(const PoseHypothesis& pose, std::vector<double>& residuals) {
    const auto& points = lattice_.points();
    residuals.resize(2 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d s = pose.inSensor(points[i].p);
      residuals[2 * i] = std::atan2(s.y(), s.x());
      residuals[2 * i + 1] = std::atan2(s.z(), std::hypot(s.x(), s.y()));
    }
    takeOutMeans(residuals, 1, rings_, true);
    for (int pass = 0; pass < 3; ++pass) {
      takeOutMeans(residuals, 0, columns_, false);
      takeOutMeans(residuals, 0, rings_, true);
    }
  }

 private:
  void takeOutMeans(std::vector<double>& values, std::size_t part, std::size_t groups, bool of_rings) {
    sine_.assign(groups, 0.0);
    cosine_.assign(groups, 0.0);
    const auto& points = lattice_.points();
    const auto groupOf = [&](std::size_t i) {
      return of_rings ? ringOf(points[i], rings_are_columns_) : columnOf(points[i], rings_are_columns_);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      sine_[groupOf(i)] += std::sin(values[2 * i + part]);
      cosine_[groupOf(i)] += std::cos(values[2 * i + part]);
    }
    for (std::size_t g = 0; g < groups; ++g) sine_[g] = std::atan2(sine_[g], cosine_[g]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double& value = values[2 * i + part];
      value = halfTurnAtMost(value - sine_[groupOf(i)]);
    }
  }

  const PointLattice& lattice_;
  bool rings_are_columns_;
  std::size_t rings_, columns_;
  std::vector<double> sine_, cosine_;
};

PoseHypothesis moved(const PoseHypothesis& pose, const Step& step, double length) {
  PoseHypothesis next = pose;
  const Eigen::Vector3d tilt(step(0), step(1), 0.0);
  const double angle = tilt.norm();
  if (angle > 0.0) next.axes = pose.axes * Eigen::AngleAxisd(angle, tilt / angle).toRotationMatrix();
  next.origin += length * step.tail<3>();
  return next;
}

/// Sum of squares, each no larger than the limit.
double cost(const std::vector<double>& residuals, double limit) {
  double sum = 0.0;
  for (const double r : residuals) sum += std::min(r * r, limit);
  return sum;
}

}  // namespace

Eigen::Matrix3d axesAbout(const Eigen::Vector3d& up) {
  Eigen::Matrix3d axes;
  axes.col(2) = up.normalized();
  int largest = 0;
  axes.col(2).cwiseAbs().maxCoeff(&largest);
  const Eigen::Vector3d forward = Eigen::Vector3d::Unit((largest + 1) % 3);  // x to an axis z, z to y
  axes.col(0) = (forward - forward.dot(axes.col(2)) * axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

PoseHypothesis scannerAt(const PointLattice& lattice, const Eigen::Vector3d& origin, bool rings_are_columns) {
  std::vector<Scatter> rings(std::max(lattice.rows().size(), lattice.columns().size()));
  for (const PointLattice::Point& point : lattice.points())
    rings[ringOf(point, rings_are_columns)].add((point.p - origin).normalized());
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Scatter& ring : rings) sum += ring.aboutMean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  PoseHypothesis pose;
  pose.is_scanner = true;
  pose.rings_are_columns = rings_are_columns;
  pose.axes = axesAbout(upwards(solver.eigenvectors().col(0)));
  pose.origin = origin;
  return pose;
}

PoseHypothesis scannerFromColumns(const PointLattice& lattice, bool rings_are_columns) {
  const std::size_t most = std::max(lattice.rows().size(), lattice.columns().size());
  std::vector<Scatter> columns(most);
  for (const PointLattice::Point& point : lattice.points()) columns[columnOf(point, rings_are_columns)].add(point.p);
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  Eigen::Vector3d offsets = Eigen::Vector3d::Zero();
  for (const Scatter& column : columns) {
    if (column.n < 4.0) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(column.aboutMean());
    // Points on a line lie in many planes.
    const double weight = solver.eigenvalues()(1) / std::max(solver.eigenvalues()(2), 1e-300);
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    normals += weight * normal * normal.transpose();
    offsets += weight * normal * normal.dot(column.first / column.n);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
  PoseHypothesis pose;
  pose.is_scanner = true;
  pose.rings_are_columns = rings_are_columns;
  pose.axes = axesAbout(upwards(solver.eigenvectors().col(0)));
  for (int k = 1; k < 3; ++k)
    if (solver.eigenvalues()(k) > 0.0)
      pose.origin +=
          solver.eigenvectors().col(k) * (solver.eigenvectors().col(k).dot(offsets) / solver.eigenvalues()(k));
  // Per ring: height = start + slope * distance, with one start.
  struct Line {
    double n = 0.0, d = 0.0, dd = 0.0, h = 0.0, dh = 0.0;
  };
  std::vector<Line> rings(most);
  for (const PointLattice::Point& point : lattice.points()) {
    const Eigen::Vector3d s = pose.inSensor(point.p);
    const double d = std::hypot(s.x(), s.y());
    Line& line = rings[ringOf(point, rings_are_columns)];
    line.n += 1.0;
    line.d += d;
    line.dd += d * d;
    line.h += s.z();
    line.dh += d * s.z();
  }
  double weight = 0.0, sum = 0.0;
  for (const Line& line : rings) {
    if (!(line.dd > 0.0)) continue;
    weight += line.n - line.d * line.d / line.dd;
    sum += line.h - line.d * line.dh / line.dd;
  }
  if (weight > 0.0) pose.origin += (sum / weight) * pose.axes.col(2);
  return pose;
}

void refineScanner(const PointLattice& lattice, PoseHypothesis& pose) {
  double length = 0.0;  // of the cloud
  for (const PointLattice::Point& point : lattice.points()) length += (point.p - pose.origin).norm();
  length /= std::max(1.0, static_cast<double>(lattice.points().size()));
  if (!(length > 0.0)) return;
  TableResiduals measure(lattice, pose.rings_are_columns);
  std::vector<double> residuals, trial, sorted;
  std::array<std::vector<double>, kParameters> derivatives;
  measure(pose, residuals);
  double damping = 1e-3;
  for (int k = 0; k < kMaxSteps; ++k) {
    sorted.assign(residuals.begin(), residuals.end());
    for (double& r : sorted) r = std::abs(r);
    const double limit = std::pow(std::max(kOutlierRatio * median(sorted), 1e-9), 2.0);
    const double before = cost(residuals, limit);
    for (int j = 0; j < kParameters; ++j) {
      measure(moved(pose, kStepOfDerivative * Step::Unit(j), length), derivatives[static_cast<std::size_t>(j)]);
      for (std::size_t i = 0; i < residuals.size(); ++i)
        derivatives[static_cast<std::size_t>(j)][i] =
            halfTurnAtMost(derivatives[static_cast<std::size_t>(j)][i] - residuals[i]) / kStepOfDerivative;
    }
    Eigen::Matrix<double, kParameters, kParameters> square = Eigen::Matrix<double, kParameters, kParameters>::Zero();
    Step gradient = Step::Zero();
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      if (residuals[i] * residuals[i] > limit) continue;
      Step row;
      for (int j = 0; j < kParameters; ++j) row(j) = derivatives[static_cast<std::size_t>(j)][i];
      square += row * row.transpose();
      gradient += residuals[i] * row;
    }
    bool better = false;
    double gain = 0.0;
    for (int attempt = 0; attempt < 6 && !better; ++attempt) {
      Eigen::Matrix<double, kParameters, kParameters> damped = square;
      damped.diagonal() *= 1.0 + damping;
      damped.diagonal().array() += 1e-12 * square.trace();
      const PoseHypothesis next = moved(pose, -damped.ldlt().solve(gradient), length);
      if (!next.axes.allFinite() || !next.origin.allFinite()) return;
      measure(next, trial);
      const double after = cost(trial, limit);
      better = after < before;
      gain = before > 0.0 ? 1.0 - after / before : 0.0;
      damping *= better ? 0.2 : 6.0;
      if (better) {
        pose = next;
        residuals.swap(trial);
      }
    }
    if (!better || gain < 1e-6) return;
  }
}

}  // namespace epcc
