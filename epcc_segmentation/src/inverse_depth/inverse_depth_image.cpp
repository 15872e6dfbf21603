// SPDX-License-Identifier: BSD-3-Clause
// Depth frame -> inverse depths, ray tables and the noise in inverse depth.
#include "inverse_depth/inverse_depth_image.h"

#include <algorithm>
#include <cmath>

namespace epcc {

void InverseDepthImage::read(const DepthFrame& frame, const SensorModel& sensor) {
  width = frame.width();
  height = frame.height();
  planar_rows = isPerspective(frame.projection());
  noise = InverseDepthNoise::of(sensor);
  readDepths(frame);
  transpose();
}

// The rays of a row or a column share a coordinate; for clouds it is the mean over the valid points.
void InverseDepthImage::readDepths(const DepthFrame& frame) {
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  w.assign(columns * rows, 0.0f);
  across.assign(columns, 0.0);
  forward.assign(columns, 0.0);
  along.assign(rows, 0.0);
  measured_scale.assign(rows, 1.0);
  std::vector<double> column_count(columns, 0.0);
  std::vector<double> row_count(rows, 0.0);
  Eigen::Vector3d p;
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      if (!frame.scanPoint(static_cast<int>(r), static_cast<int>(c), p)) continue;
      const double distance = planar_rows ? p.z() : std::sqrt(p.x() * p.x() + p.z() * p.z());
      if (!(distance > 0.0)) continue;
      const double inverse = 1.0 / distance;
      const auto value = static_cast<float>(inverse);
      if (!std::isfinite(value) || !(value > 0.0f)) continue;
      w[r * columns + c] = value;
      across[c] += p.x() * inverse;
      forward[c] += p.z() * inverse;
      along[r] += p.y() * inverse;
      column_count[c] += 1.0;
      row_count[r] += 1.0;
    }
  for (std::size_t c = 0; c < columns; ++c) {
    const double length = planar_rows ? column_count[c] : std::hypot(across[c], forward[c]);
    if (!(length > 0.0)) continue;
    across[c] /= length;
    forward[c] /= length;
  }
  for (std::size_t r = 0; r < rows; ++r) {
    if (row_count[r] > 0.0) along[r] /= row_count[r];
    if (!planar_rows) measured_scale[r] = 1.0 / std::sqrt(1.0 + along[r] * along[r]);
  }
}

void InverseDepthImage::transpose() {
  constexpr int kBlock = 32;  // both images stay in the cache
  w_transposed.resize(w.size());
  for (int row_block = 0; row_block < height; row_block += kBlock)
    for (int column_block = 0; column_block < width; column_block += kBlock)
      for (int row = row_block; row < std::min(row_block + kBlock, height); ++row)
        for (int column = column_block; column < std::min(column_block + kBlock, width); ++column)
          w_transposed[static_cast<std::size_t>(column) * height + row] =
              w[static_cast<std::size_t>(row) * width + column];
}

InverseDepthNoise InverseDepthNoise::of(const SensorModel& sensor) {
  const auto k = sensor.coefficients();
  InverseDepthNoise noise;
  if (sensor.isPolynomial()) {
    noise.k1 = k[0];
    noise.k2 = k[1];
    noise.k3 = k[2];
  } else {
    noise.a2 = k[0] * k[0];
    noise.b2 = k[1] * k[1];
  }
  return noise;
}

}  // namespace epcc
