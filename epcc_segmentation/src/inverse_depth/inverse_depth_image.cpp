// SPDX-License-Identifier: BSD-3-Clause
// Depth frame -> inverse depths, ray tables and the noise in inverse depth.
#include "inverse_depth/inverse_depth_image.h"

#include <algorithm>
#include <cmath>

#include "inverse_depth/depth_inversion.h"
#include "parallel_for.h"
#include "thin_out.h"

namespace epcc {

namespace {

/// Rows or columns without a point have no coordinate of their own: between seen ones it is interpolated, outside it
/// goes on in their mean step, so that pixelPitch() is that of what was seen.
void fillUnseen(const std::vector<double>& count, std::vector<double>& coordinate) {
  const auto seen = [&](std::size_t i) { return count[i] > 0.0; };
  std::size_t first = 0, last = coordinate.size();
  while (first < last && !seen(first)) ++first;
  while (last > first && !seen(last - 1)) --last;
  if (first == last) return;
  --last;
  const double step = last > first ? (coordinate[last] - coordinate[first]) / static_cast<double>(last - first) : 0.0;
  for (std::size_t i = 0; i < first; ++i) coordinate[i] = coordinate[first] - step * static_cast<double>(first - i);
  for (std::size_t i = last + 1; i < coordinate.size(); ++i)
    coordinate[i] = coordinate[last] + step * static_cast<double>(i - last);
  for (std::size_t before = first, i = first + 1; i <= last; ++i) {
    if (!seen(i)) continue;
    const double between = (coordinate[i] - coordinate[before]) / static_cast<double>(i - before);
    for (std::size_t k = before + 1; k < i; ++k)
      coordinate[k] = coordinate[before] + between * static_cast<double>(k - before);
    before = i;
  }
}

}  // namespace

void InverseDepthImage::read(const DepthFrame& frame, int threads, int stride) {
  width = frame.width();
  height = frame.height();
  planar_rows = isPerspective(frame.projection());
  closes_round = frame.closesRound();
  w.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  across.assign(static_cast<std::size_t>(width), 0.0);
  forward.assign(static_cast<std::size_t>(width), planar_rows ? 1.0 : 0.0);
  along.assign(static_cast<std::size_t>(height), 0.0);
  measured_scale.assign(static_cast<std::size_t>(height), 1.0);
  keeps_depths_ = stride > 1 && frame.isPinhole();
  if (frame.isPinhole())
    readDepths(frame, threads, stride);
  else
    readPoints(frame);
}

void InverseDepthImage::readDepths(const DepthFrame& frame, int threads, int stride) {
  const auto columns = static_cast<std::size_t>(width);
  row_depths_.resize(columns * static_cast<std::size_t>(std::max(1, threads)));
  const int offset = stride / 2;
  const auto samplesAlong = [=](int size) { return std::max(0, (size - offset + stride - 1) / stride); };
  const int kept = samplesAlong(width);
  if (keeps_depths_)
    sample_depths_.resize(static_cast<std::size_t>(kept) * static_cast<std::size_t>(samplesAlong(height)) +
                          kBehindDepths);
  sharedFor(height, threads, [&](int thread, int begin, int end) {
    float* depths = row_depths_.data() + static_cast<std::size_t>(thread) * columns;
    for (int r = begin; r < end; ++r) {
      along[static_cast<std::size_t>(r)] = frame.pinholeAlong(r);
      frame.depthRow(r, depths);
      invertDepths(depths, columns, w.data() + static_cast<std::size_t>(r) * columns);
      if (keeps_depths_ && r % stride == offset)
        thinOut(depths + offset, kept, stride,
                sample_depths_.data() + static_cast<std::size_t>(r / stride) * static_cast<std::size_t>(kept));
    }
  });
  for (std::size_t c = 0; c < columns; ++c) across[c] = frame.pinholeAcross(static_cast<int>(c));
}

// The rays of a row or a column share a coordinate; for clouds it is the mean over the valid points.
void InverseDepthImage::readPoints(const DepthFrame& frame) {
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  column_count_.assign(columns, 0.0);
  row_count_.assign(rows, 0.0);
  if (planar_rows)
    points_.read(frame, columns, w.data(), across.data(), column_count_.data(), along.data(), row_count_.data());
  else
    readScan(frame);
  for (std::size_t r = 0; r < rows; ++r)
    if (row_count_[r] > 0.0) along[r] /= row_count_[r];
  for (std::size_t c = 0; c < columns; ++c) {
    const double length = planar_rows ? column_count_[c] : std::hypot(across[c], forward[c]);
    if (!(length > 0.0)) {
      if (!planar_rows) forward[c] = 0.0;
      continue;
    }
    across[c] /= length;
    if (!planar_rows) forward[c] /= length;
  }
  fillUnseen(row_count_, along);
  if (planar_rows) fillUnseen(column_count_, across);
  if (!planar_rows)
    for (std::size_t r = 0; r < rows; ++r) measured_scale[r] = 1.0 / std::sqrt(1.0 + along[r] * along[r]);
}

void InverseDepthImage::readScan(const DepthFrame& frame) {
  const auto columns = static_cast<std::size_t>(width);
  Eigen::Vector3d p;
  for (std::size_t r = 0; r < static_cast<std::size_t>(height); ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      w[r * columns + c] = 0.0f;
      if (!frame.scanPoint(static_cast<int>(r), static_cast<int>(c), p)) continue;
      const double distance = std::sqrt(p.x() * p.x() + p.z() * p.z());
      if (!(distance > 0.0 && distance <= kFarthestMeasured && std::abs(p.y()) <= kFarthestMeasured)) continue;
      const double inverse = 1.0 / distance;
      if (!(inverse <= kLargestInverse)) continue;
      w[r * columns + c] = static_cast<float>(inverse);
      across[c] += p.x() * inverse;
      forward[c] += p.z() * inverse;
      along[r] += p.y() * inverse;
      row_count_[r] += 1.0;
    }
}

double InverseDepthImage::placeVariance() const {
  if (place_of_pixel > 0.0) return place_of_pixel + place_beside;
  const double height_of_pixel = pixelPitch(along);
  const double width_of_pixel = planar_rows ? pixelPitch(across) : height_of_pixel;
  return (width_of_pixel * width_of_pixel + height_of_pixel * height_of_pixel) / 24.0;
}

int sampleCount(int count, int stride) {
  return std::max(1, (count - stride / 2 + stride - 1) / stride);
}

namespace {

std::size_t samplePlace(std::size_t sample, int stride, std::size_t count) {
  return std::min(sample * static_cast<std::size_t>(stride) + static_cast<std::size_t>(stride / 2), count - 1);
}

}  // namespace

int sampleAt(int place, int stride, int count) {
  const int sample = place / stride;
  const bool is_one = sample < sampleCount(count, stride) &&
                      samplePlace(static_cast<std::size_t>(sample), stride, static_cast<std::size_t>(count)) ==
                          static_cast<std::size_t>(place);
  return is_one ? sample : -1;
}

namespace {

void sampleCoordinates(const std::vector<double>& from, int count, int stride, std::vector<double>& to) {
  to.resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[samplePlace(i, stride, from.size())];
}

}  // namespace

void InverseDepthImage::sample(const InverseDepthImage& image, int stride, int threads) {
  width = sampleCount(image.width, stride);
  height = sampleCount(image.height, stride);
  steps = stride;
  planar_rows = image.planar_rows;
  closes_round = image.closes_round;
  sampleCoordinates(image.across, width, stride, across);
  sampleCoordinates(image.forward, width, stride, forward);
  sampleCoordinates(image.along, height, stride, along);
  sampleCoordinates(image.measured_scale, height, stride, measured_scale);
  w.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const std::size_t first = samplePlace(0, stride, static_cast<std::size_t>(image.width));
  sharedFor(height, threads, [&](int /*thread*/, int begin, int end) {
    for (int r = begin; r < end; ++r) {
      const std::size_t from = samplePlace(static_cast<std::size_t>(r), stride, static_cast<std::size_t>(image.height));
      thinOut(image.w.data() + image.index(static_cast<int>(from), 0) + first, width, stride, w.data() + index(r, 0));
    }
  });
}

void InverseDepthImage::weigh(const SensorModel& sensor, double place_variance, int threads) {
  noise = InverseDepthNoise::of(sensor);
  noise.place2 = place_variance;
  const auto columns = static_cast<std::size_t>(width);
  weight.resize(w.size());
  sharedFor(height, threads, [&](int /*thread*/, int begin, int end) {
    for (int r = begin; r < end; ++r)
      weighInverseDepths(w.data() + index(r, 0), columns, noise,
                         static_cast<float>(measured_scale[static_cast<std::size_t>(r)]), weight.data() + index(r, 0));
  });
}

double pixelPitch(const std::vector<double>& coordinate) {
  if (coordinate.size() < 2) return 0.0;
  const auto [least, greatest] = std::minmax_element(coordinate.begin(), coordinate.end());
  return (*greatest - *least) / static_cast<double>(coordinate.size() - 1);
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
