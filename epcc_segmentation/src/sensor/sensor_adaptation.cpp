// SPDX-License-Identifier: BSD-3-Clause
// The ratio of two models over the depths of an image.
#include "sensor/sensor_adaptation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "quantile.h"
#include "sensor/model_length.h"

namespace epcc {

namespace {

constexpr double kDeadZone = 0.2;             // of a logarithm: what an estimate from one frame may err by
constexpr std::size_t kComparedDepths = 500;  // sampled in an image, at least

/// What `given` is to be multiplied by to come to `measured`, but for the dead zone.
double pull(double measured, double given) {
  const double x = std::log(measured / given);
  return std::exp(x > 0.0 ? std::max(0.0, x - kDeadZone) : std::min(0.0, x + kDeadZone));
}

}  // namespace

SensorModel adapted(const SensorModel& given, const SensorEstimate& measured, const InverseDepthImage& image,
                    std::vector<double>& ratios) {
  if (measured.blocks == 0) return given;
  const SensorModel model = measured.model();
  const std::size_t step = std::max<std::size_t>(1, image.w.size() / kComparedDepths);
  ratios.clear();
  ratios.reserve(image.w.size() / step + 1);
  for (std::size_t i = step / 2; i < image.w.size(); i += step) {
    if (!(image.w[i] > 0.0f)) continue;
    const double z = 1.0 / static_cast<double>(image.w[i]);
    ratios.push_back(model.varianceZ(z) / given.varianceZ(z));
  }
  if (ratios.empty()) return given;
  // Curved surfaces look like bending: what is measured is an upper bound.
  const double share = std::min(given.correlatedShare(), measured.correlated_share);
  const SensorModel result = given.scaled(pull(std::sqrt(quantile(ratios, 0.5)), 1.0)).withCorrelatedShare(share);
  if (!image.planar_rows) return result;  // a scanner's length is not measured
  // From the length of the error to that of a model of it, which is longer for safety, a given one is right.
  const double length = std::max(kLengthOfGrain, given.correlationLength());
  const double shortest = measured.effective_length,
               longest = std::max(measured.correlation_length, lengthOfError(shortest));
  if (pull(std::clamp(length, shortest, longest), length) == 1.0) return result;
  return result.withCorrelationLength(length * pull(measured.correlation_length, length));
}

}  // namespace epcc
