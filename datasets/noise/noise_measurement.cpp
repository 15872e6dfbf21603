// SPDX-License-Identifier: BSD-3-Clause
// Planes are fitted as w = q . (u, v, 1) with w = 1/z; residuals are divided by the slant factor to be comparable.
#include "datasets/noise/noise_measurement.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "datasets/support/quantile.h"

namespace epcc {
namespace {

constexpr std::size_t kMinPixels = 1000;
constexpr int kPasses = 6;
constexpr double kGate = 3.0;  // times the 68 % quantile of the residuals
constexpr double kMaxSlant2 = 25.0;

struct Sample {
  int row, column;
  Eigen::Vector3d ray;  // (u, v, 1)
  double w;             // measured inverse depth, 1/m
};

struct PlaneFit {
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  std::vector<double> residuals;  // of w over the slant factor
  double gate = std::numeric_limits<double>::infinity();
};

std::vector<Sample> samplesOf(const LabelledFrame& frame, int label) {
  const PinholeCamera& camera = frame.camera.camera;
  std::vector<Sample> samples;
  for (int row = 0; row < frame.depth.height; ++row) {
    for (int column = 0; column < frame.depth.width; ++column) {
      const double z = static_cast<double>(frame.depth.at(row, column));
      if (frame.labels.at(row, column) != label || !(z > 0.0)) continue;
      const Eigen::Vector3d ray((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
      samples.push_back({row, column, ray, 1.0 / z});
    }
  }
  return samples;
}

double slantOf(const Eigen::Vector3d& q, double w) {
  return std::sqrt(1.0 + std::min(kMaxSlant2, q.head<2>().squaredNorm() / (w * w)));
}

double quantile68(std::vector<double> values) {
  for (double& value : values) value = std::fabs(value);
  return quantile(std::move(values), 0.68);
}

PlaneFit fitPlane(const std::vector<Sample>& samples) {
  PlaneFit fit;
  fit.residuals.assign(samples.size(), 0.0);
  for (int pass = 0; pass < kPasses; ++pass) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (std::fabs(fit.residuals[i]) > fit.gate) continue;
      a += samples[i].ray * samples[i].ray.transpose();
      b += samples[i].ray * samples[i].w;
    }
    fit.q = a.ldlt().solve(b);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double w = fit.q.dot(samples[i].ray);
      fit.residuals[i] = (samples[i].w - w) / slantOf(fit.q, w);
    }
    fit.gate = kGate * quantile68(fit.residuals);
  }
  return fit;
}

std::set<int> planeLabels(const LabelledFrame& frame) {
  std::set<int> labels(frame.labels.data.begin(), frame.labels.data.end());
  labels.erase(0);
  labels.erase(kIgnoreLabel);
  return labels;
}

// Running sums over the planes.
struct Sums {
  NoiseFigures figures;
  std::array<double, kNoiseLags.size()> row_pairs{}, column_pairs{};
  double outliers = 0.0, samples = 0.0;
};

void addAmplitudes(const std::vector<Sample>& samples, const PlaneFit& fit, Sums& sums) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sums.samples += 1.0;
    if (std::fabs(fit.residuals[i]) > fit.gate) {
      sums.outliers += 1.0;
      continue;
    }
    const double z = 1.0 / fit.q.dot(samples[i].ray);
    const auto above = std::upper_bound(kNoiseDepths.begin(), kNoiseDepths.end(), z);
    if (above == kNoiseDepths.begin() || above == kNoiseDepths.end()) continue;
    const auto bin = static_cast<std::size_t>(above - kNoiseDepths.begin()) - 1;
    const double axial = fit.residuals[i] * z * z;
    sums.figures.rms[bin] += axial * axial;
    ++sums.figures.pixels[bin];
  }
}

// Mean product of residuals `down` rows and `right` columns apart over the variance, weighted by the pairs.
void addCorrelation(const Image<double>& residual, double variance, int down, int right, double& sum, double& pairs) {
  double product = 0.0, count = 0.0;
  for (int row = 0; row + down < residual.height; ++row) {
    for (int column = 0; column + right < residual.width; ++column) {
      const double both = residual.at(row, column) * residual.at(row + down, column + right);
      if (std::isnan(both)) continue;
      product += both;
      count += 1.0;
    }
  }
  sum += product / variance;
  pairs += count;
}

void addCorrelations(const LabelledFrame& frame, const std::vector<Sample>& samples, const PlaneFit& fit, Sums& sums) {
  Image<double> residual(frame.depth.width, frame.depth.height, std::numeric_limits<double>::quiet_NaN());
  double variance = 0.0, count = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (std::fabs(fit.residuals[i]) > fit.gate) continue;
    residual.at(samples[i].row, samples[i].column) = fit.residuals[i];
    variance += fit.residuals[i] * fit.residuals[i];
    count += 1.0;
  }
  variance /= count;
  for (std::size_t k = 0; k < kNoiseLags.size(); ++k) {
    addCorrelation(residual, variance, 0, kNoiseLags[k], sums.figures.along_rows[k], sums.row_pairs[k]);
    addCorrelation(residual, variance, kNoiseLags[k], 0, sums.figures.along_columns[k], sums.column_pairs[k]);
  }
}

NoiseFigures finished(Sums sums) {
  NoiseFigures figures = sums.figures;
  for (std::size_t bin = 0; bin < figures.rms.size(); ++bin)
    if (figures.pixels[bin] > 0)
      figures.rms[bin] = std::sqrt(figures.rms[bin] / static_cast<double>(figures.pixels[bin]));
  for (std::size_t k = 0; k < kNoiseLags.size(); ++k) {
    figures.along_rows[k] /= std::max(1.0, sums.row_pairs[k]);
    figures.along_columns[k] /= std::max(1.0, sums.column_pairs[k]);
  }
  figures.outlier_share = sums.outliers / std::max(1.0, sums.samples);
  return figures;
}

}  // namespace

NoiseFigures measureNoise(const std::vector<LabelledFrame>& frames) {
  Sums sums;
  for (const LabelledFrame& frame : frames) {
    for (const int label : planeLabels(frame)) {
      const std::vector<Sample> samples = samplesOf(frame, label);
      if (samples.size() < kMinPixels) continue;
      const PlaneFit fit = fitPlane(samples);
      ++sums.figures.planes;
      addAmplitudes(samples, fit, sums);
      addCorrelations(frame, samples, fit, sums);
    }
  }
  return finished(sums);
}

LabelledFrame flattened(const LabelledFrame& frame) {
  LabelledFrame flat = frame;
  std::fill(flat.depth.data.begin(), flat.depth.data.end(), 0.0F);
  for (const int label : planeLabels(frame)) {
    const std::vector<Sample> samples = samplesOf(frame, label);
    if (samples.size() < kMinPixels) continue;
    const PlaneFit fit = fitPlane(samples);
    for (const Sample& sample : samples) {
      const double w = fit.q.dot(sample.ray);
      if (w > 0.0) flat.depth.at(sample.row, sample.column) = static_cast<float>(1.0 / w);
    }
  }
  return flat;
}

}  // namespace epcc
