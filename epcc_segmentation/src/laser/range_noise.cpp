// SPDX-License-Identifier: BSD-3-Clause
// Residuals of short windows by range, and the straight line of sigma through them.
#include "epcc_segmentation/range_noise.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "laser/laser_samples.h"
#include "quantile.h"

namespace epcc {
namespace {

constexpr int kWindow = 9;           // beams
constexpr double kShare = 0.3;       // the quantile of the windows' mean squares
constexpr double kOfNoise = 0.6673;  // that quantile of noise alone: chi squared with 7 degrees of freedom over 7
constexpr int kBinsPerOctave = 3;
constexpr std::size_t kFewestWindows = 20;  // of a bin
constexpr double kFewestCosine = 0.3;  // squared, of a window's beams and its line's normal: grazing beams are worse
constexpr double kSmallest = 1e-4;     // metres

struct Bin {
  double range, sigma;
  std::size_t windows;
};

/// Squared errors of every window of consecutive beams, by the bin of its range.
void addWindows(const LaserScan& scan, std::map<int, std::vector<double>>& bins) {
  const std::vector<LaserSample> samples = readSamples(scan, SensorModel::polynomial(0.0, 0.0, 0.01), false);
  for (std::size_t i = 0; i + kWindow <= samples.size(); i += kWindow / 2) {
    if (samples[i + kWindow - 1].beam - samples[i].beam != kWindow - 1) continue;
    RangeLineSums sums;
    for (std::size_t k = i; k < i + kWindow; ++k) sums.add(samples[k]);
    RangeLine line;
    if (!sums.solve(line)) continue;
    double squares = 0.0;
    bool seen = true;
    for (std::size_t k = i; k < i + kWindow && seen; ++k) {
      RangeError error;
      seen = rangeError(line, samples[k], error) && line.squaredCosine(samples[k].direction) > kFewestCosine;
      if (seen) squares += error.squared;
    }
    if (!seen) continue;
    const double range = samples[i + kWindow / 2].range;
    bins[static_cast<int>(std::floor(kBinsPerOctave * std::log2(range)))].push_back(squares / (kWindow - 2));
  }
}

/// a + b r by least squares of the relative error, weighted by windows; neither is below zero.
void fitSigma(const std::vector<Bin>& bins, RangeNoiseEstimate& estimate) {
  double s11 = 0.0, s12 = 0.0, s22 = 0.0, t1 = 0.0, t2 = 0.0;
  for (const Bin& bin : bins) {
    const double weight = static_cast<double>(std::min<std::size_t>(bin.windows, 500)) / (bin.sigma * bin.sigma);
    s11 += weight;
    s12 += weight * bin.range;
    s22 += weight * bin.range * bin.range;
    t1 += weight * bin.sigma;
    t2 += weight * bin.range * bin.sigma;
  }
  const double determinant = s11 * s22 - s12 * s12;
  double a = t1 / s11, b = 0.0;
  if (bins.size() > 1 && determinant > 1e-9 * s11 * s22) {
    const double free_a = (s22 * t1 - s12 * t2) / determinant, free_b = (s11 * t2 - s12 * t1) / determinant;
    if (free_a >= 0.0 && free_b >= 0.0) {
      a = free_a;
      b = free_b;
    } else if (free_a < 0.0) {
      a = 0.0;
      b = t2 / s22;
    }
  }
  estimate.a = std::max(a, kSmallest);
  estimate.b = b;
}

}  // namespace

RangeNoiseEstimate estimateRangeNoise(const std::vector<LaserScan>& scans) {
  std::map<int, std::vector<double>> windows;
  for (const LaserScan& scan : scans)
    if (scan.angles.empty() || scan.angles.size() == scan.ranges.size()) addWindows(scan, windows);
  RangeNoiseEstimate estimate;
  std::vector<Bin> bins;
  for (auto& [number, squares] : windows) {
    if (squares.size() < kFewestWindows) continue;
    const double sigma = std::max(kSmallest, std::sqrt(quantile(squares, kShare) / kOfNoise));
    bins.push_back({std::exp2((number + 0.5) / kBinsPerOctave), sigma, squares.size()});
    estimate.windows += squares.size();
  }
  if (!bins.empty()) fitSigma(bins, estimate);
  return estimate;
}

}  // namespace epcc
