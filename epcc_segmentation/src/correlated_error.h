// SPDX-License-Identifier: BSD-3-Clause
// How much less the samples of a patch say of its plane than as many independent ones, for their errors are alike.
#pragma once

#include <vector>

#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// A part of an error with the autocorrelation exp(-r^2 / (2 l^2)).
struct CorrelatedPart {
  double share = 0.0;   ///< in the variance, 0 to 1
  double length = 0.0;  ///< its l, pixels

  bool exists() const { return share > 0.0 && length > 0.0; }
};

/// An error in parts; what is left of the variance differs from pixel to pixel.
struct ErrorCorrelation {
  CorrelatedPart blotches;
  CorrelatedPart bending;  ///< slower than the blotches

  /// All of it correlated, unless a pixel is a sample of its own: what a given model says.
  static ErrorCorrelation of(const SensorModel& sensor) {
    const double length = sensor.correlationLength();
    return length > 0.4 ? ErrorCorrelation{{1.0, length}, {}} : ErrorCorrelation{};
  }
  double grain() const { return 1.0 - blotches.share - bending.share; }
};

/// Samples that are worth one independent one, for each of a plane's three parameters.
struct SamplesPerIndependent {
  double offset;       ///< of the patch's middle
  double long_slope;   ///< along its longer side
  double short_slope;  ///< along its shorter side
};

/// Of a rectangle of long_side times short_side pixels with a sample at every stride-th row and column, whose plane is
/// fitted by least squares.
///
/// The variance of a coefficient is sum_ij q_i q_j R(i - j) / (sum_i q_i^2)^2, where q is 1 or the place along a side.
/// Gaussian R parts into the two sides: 2 pi l^2 times the share that each side keeps of its integral. A long side
/// keeps it all; a side that is short beside l keeps little of it for its offset and less for its slope, for the error
/// is nearly the same all over it.
SamplesPerIndependent samplesPerIndependent(const ErrorCorrelation& error, double long_side, double short_side,
                                            int stride);

/// Correlation of the errors of samples 0, 1, 2, ... strides apart, as far as there is any.
std::vector<double> autocorrelation(const ErrorCorrelation& error, int stride);

/// The same for a line's two parameters, and for the mean square of its residuals.
struct LineSamplesPerIndependent {
  double offset;  ///< of the line's middle
  double slope;   ///< about it
  double square;  ///< of squared errors
};

/// Of a line with `samples` samples spread over `places` strides, the sums themselves: a line is often shorter than
/// the correlation reaches, and a slope then errs less than with as many independent samples.
LineSamplesPerIndependent lineSamplesPerIndependent(const std::vector<double>& correlation, int samples, int places);

}  // namespace epcc
