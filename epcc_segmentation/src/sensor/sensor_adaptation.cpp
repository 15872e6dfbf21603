// SPDX-License-Identifier: BSD-3-Clause
// The ratio of two models over the depths of an image.
#include "sensor/sensor_adaptation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "quantile.h"

namespace epcc {

namespace {

constexpr double kDeadZone = 0.2;             // of ln(rho): what an estimate from one frame may err by
constexpr std::size_t kComparedDepths = 500;  // sampled in an image, at least

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
  const double x = 0.5 * std::log(quantile(ratios, 0.5));
  return given.scaled(std::exp(x > 0.0 ? std::max(0.0, x - kDeadZone) : std::min(0.0, x + kDeadZone)));
}

}  // namespace epcc
