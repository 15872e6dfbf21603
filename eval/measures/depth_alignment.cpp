// SPDX-License-Identifier: BSD-3-Clause
// Samples of one image are carried into the other, and the pose is moved until their depths agree.
#include "eval/measures/depth_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace epcc {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double kSamples = 1e4;
constexpr double kCauchySigmas = 2.385;  // 95 % as good as least squares where errors are normal
constexpr double kUnseenSigmas = 5.0;    // what a sample costs that has nothing to be compared with
constexpr double kSigmaTimes[] = {4.0, 1.0};
constexpr int kMostSteps = 30;
constexpr double kSmallestStep = 1e-7;  // m, rad

/// A measured pixel of the first image.
struct Sample {
  Eigen::Vector3d point;
  double sigma;  ///< of the difference of two inverse depths, 1/m
};

std::vector<Sample> samplesOf(const PosedView& view, const SensorModel& sensor) {
  const int step =
      std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(view.depth.data.size()) / kSamples))));
  std::vector<Sample> samples;
  for (int row = step / 2; row < view.depth.height; row += step)
    for (int column = step / 2; column < view.depth.width; column += step) {
      const float z = view.depth.at(row, column);
      if (isMeasured(z)) samples.push_back({pointOf(view, row, column), M_SQRT2 * sensor.sigmaInverseDepth(z)});
    }
  return samples;
}

/// Inverse depth at a place between four pixels, and how it changes along rows and columns.
struct SeenThere {
  bool is_seen = false;
  double w = 0.0, by_column = 0.0, by_row = 0.0;
};

SeenThere inverseDepthAt(const DepthImage& depth, double column, double row) {
  SeenThere result;
  if (!(column >= 0.0 && row >= 0.0 && column < depth.width - 1 && row < depth.height - 1)) return result;
  const int c = static_cast<int>(column), r = static_cast<int>(row);
  double w[4];
  for (int k = 0; k < 4; ++k) {
    const float z = depth.at(r + k / 2, c + k % 2);
    if (!isMeasured(z)) return result;
    w[k] = 1.0 / static_cast<double>(z);
  }
  const double x = column - c, y = row - r;
  const double above = w[0] + x * (w[1] - w[0]), below = w[2] + x * (w[3] - w[2]);
  result.is_seen = true;
  result.w = above + y * (below - above);
  result.by_row = below - above;
  result.by_column = (1.0 - y) * (w[1] - w[0]) + y * (w[3] - w[2]);
  return result;
}

/// Normal equations of a small turn and shift of the second camera's coordinates, with the robust cost.
struct Fit {
  double cost = 0.0;
  Matrix6d information = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
};

double cauchy(double square) {
  return kCauchySigmas * kCauchySigmas * std::log1p(square / (kCauchySigmas * kCauchySigmas));
}

Fit fitAt(const std::vector<Sample>& samples, const PosedView& to, const Eigen::Isometry3d& to_from,
          double sigma_times) {
  Fit fit;
  const PinholeCamera& camera = to.camera;
  for (const Sample& sample : samples) {
    const Eigen::Vector3d p = to_from * sample.point;
    const double z = p.z();
    SeenThere seen;
    if (z > 0.0) seen = inverseDepthAt(to.depth, camera.fx * p.x() / z + camera.cx, camera.fy * p.y() / z + camera.cy);
    if (!seen.is_seen) {
      fit.cost += cauchy(kUnseenSigmas * kUnseenSigmas);
      continue;
    }
    const double sigma = sigma_times * sample.sigma;
    const double error = (seen.w - 1.0 / z) / sigma;
    fit.cost += std::min(cauchy(error * error), cauchy(kUnseenSigmas * kUnseenSigmas));
    // d(error)/d(point), then of the point by a turn (omega x p) and a shift.
    const double by_x = seen.by_column * camera.fx / z, by_y = seen.by_row * camera.fy / z;
    const Eigen::Vector3d by_point = Eigen::Vector3d(by_x, by_y, (1.0 / z - by_x * p.x() - by_y * p.y()) / z) / sigma;
    Vector6d j;
    j << p.cross(by_point), by_point;
    const double weight = 1.0 / (1.0 + error * error / (kCauchySigmas * kCauchySigmas));
    fit.information += weight * j * j.transpose();
    fit.gradient -= weight * error * j;
  }
  return fit;
}

Eigen::Isometry3d stepped(const Eigen::Isometry3d& pose, const Vector6d& step) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  const double angle = step.head<3>().norm();
  if (angle > 0.0) motion.linear() = Eigen::AngleAxisd(angle, step.head<3>() / angle).toRotationMatrix();
  motion.translation() = step.tail<3>();
  return motion * pose;
}

double misfitOf(const Fit& fit, const std::vector<Sample>& samples) {
  return fit.cost / std::max(1.0, static_cast<double>(samples.size()));
}

DepthAlignment alignFrom(const std::vector<Sample>& samples, const PosedView& to, const Eigen::Isometry3d& start) {
  Eigen::Isometry3d pose = start;
  Fit fit;
  for (const double times : kSigmaTimes) {
    fit = fitAt(samples, to, pose, times);
    double damping = 1e-3;
    for (int i = 0; i < kMostSteps && damping < 1e6; ++i) {
      Matrix6d damped = fit.information;
      damped.diagonal() *= 1.0 + damping;
      damped.diagonal().array() += 1e-9;  // what no sample says anything of stays
      const Vector6d step = damped.ldlt().solve(fit.gradient);
      const Eigen::Isometry3d there = stepped(pose, step);
      const Fit next = fitAt(samples, to, there, times);
      if (next.cost < fit.cost) {
        pose = there;
        fit = next;
        damping = std::max(1e-9, 0.2 * damping);
      } else {
        damping *= 5.0;
      }
      if (step.norm() < kSmallestStep) break;
    }
  }
  return {pose, misfitOf(fit, samples)};
}

}  // namespace

double depthMisfit(const PosedView& from, const PosedView& to, const SensorModel& sensor,
                   const Eigen::Isometry3d& to_from) {
  const std::vector<Sample> samples = samplesOf(from, sensor);
  return misfitOf(fitAt(samples, to, to_from, 1.0), samples);
}

DepthAlignment alignDepth(const PosedView& from, const PosedView& to, const SensorModel& sensor,
                          const std::vector<Eigen::Isometry3d>& starts) {
  if (starts.empty()) throw std::invalid_argument("no pose to start from");
  const std::vector<Sample> samples = samplesOf(from, sensor);
  DepthAlignment best = alignFrom(samples, to, starts.front());
  for (std::size_t k = 1; k < starts.size(); ++k) {
    const DepthAlignment other = alignFrom(samples, to, starts[k]);
    if (other.misfit < best.misfit) best = other;
  }
  return best;
}

}  // namespace epcc
