// SPDX-License-Identifier: BSD-3-Clause
// The integrals of a Gaussian autocorrelation over pairs of places on a side, closed.
#include "correlated_error.h"

#include <algorithm>
#include <cmath>

#include "pi.h"

namespace epcc {

namespace {

constexpr double kReach = 4.0;  // lengths to where no correlation is left

/// Shares of sqrt(2 pi) l that remain of the integral of R over a side, x = side / l:
/// with weight 1 - t/x of pairs t apart for an offset, 1 - 3 t/x + 2 (t/x)^3 for a slope.
struct KeptShares {
  double offset, slope;
};

KeptShares keptShares(double x) {
  const double norm = std::sqrt(2.0 / kPi);
  if (x < 0.05) return {norm * x / 2.0, norm * x * x * x / 24.0};  // else the difference of nearly equal numbers
  const double gauss = std::exp(-0.5 * x * x);
  const double moment0 = std::erf(x / std::sqrt(2.0)) / norm;
  const double moment1 = 1.0 - gauss;
  const double moment3 = 2.0 - (x * x + 2.0) * gauss;
  return {norm * (moment0 - moment1 / x), norm * (moment0 - 3.0 * moment1 / x + 2.0 * moment3 / (x * x * x))};
}

}  // namespace

SamplesPerIndependent samplesPerIndependent(const ErrorCorrelation& error, double long_side, double short_side,
                                            int stride) {
  SamplesPerIndependent sum = {1.0, 1.0, 1.0};
  for (const CorrelatedPart& part : {error.blotches, error.bending}) {
    if (!part.exists()) continue;
    const KeptShares across_long = keptShares(long_side / part.length);
    const KeptShares across_short = keptShares(short_side / part.length);
    const double all = 2.0 * kPi * part.length * part.length / (static_cast<double>(stride) * stride);
    const auto more = [&](double kept) { return part.share * (std::max(1.0, all * kept) - 1.0); };
    sum.offset += more(across_long.offset * across_short.offset);
    sum.long_slope += more(across_long.slope * across_short.offset);
    sum.short_slope += more(across_long.offset * across_short.slope);
  }
  return sum;
}

std::vector<double> autocorrelation(const ErrorCorrelation& error, int stride) {
  std::vector<double> correlation = {1.0};
  for (const CorrelatedPart& part : {error.blotches, error.bending}) {
    if (!part.exists()) continue;
    const auto reach = static_cast<std::size_t>(kReach * part.length / stride);
    if (correlation.size() <= reach) correlation.resize(reach + 1, 0.0);
    for (std::size_t k = 1; k <= reach; ++k) {
      const double x = static_cast<double>(k) * stride / part.length;
      correlation[k] += part.share * std::exp(-0.5 * x * x);
    }
  }
  return correlation;
}

// Of two samples k places apart, n - k pairs are on the line, of which as many are there as samples are on places; for
// a slope the products of their places about the middle are summed: m (m^2 - 1)/12 - m k^2/4, m = n - k.
LineSamplesPerIndependent lineSamplesPerIndependent(const std::vector<double>& correlation, int samples, int places) {
  LineSamplesPerIndependent result = {1.0, 1.0, 1.0};
  const double n = places, taken = samples / n;
  const double of_slope = n * (n * n - 1.0);
  for (std::size_t k = 1; k < correlation.size() && k < static_cast<std::size_t>(places); ++k) {
    const auto lag = static_cast<double>(k);
    const double rest = n - lag;
    const double pairs = 2.0 * taken * correlation[k];
    result.offset += pairs * rest / n;
    result.slope += pairs * rest * (rest * rest - 1.0 - 3.0 * lag * lag) / of_slope;
    result.square += pairs * correlation[k] * rest / n;
  }
  return result;
}

}  // namespace epcc
