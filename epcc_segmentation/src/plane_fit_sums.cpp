// SPDX-License-Identifier: BSD-3-Clause
// What is summed for the planes: samples of the grid, of small planes all pixels, of all but thin ones those inside.
#include <algorithm>

#include "cloud_points.h"
#include "label_margin.h"
#include "label_table.h"
#include "parallel_for.h"
#include "plane_fit_samples.h"
#include "thin_out.h"

namespace epcc {

namespace {

/// Those of a row's values that are samples.
template <typename T>
void takeSamples(const T* from, int width, const FitSamples& samples, T* to) {
  thinOut(from + samples.offset, samplesAlong(width, samples), samples.stride, to);
}

}  // namespace

/// The samples' labels, of sparse planes alone while these are summed. False if there is none.
bool PlaneFitter::readLabels(const std::int32_t* labels, int width, const FitSamples& samples,
                             std::int32_t* row) const {
  if (samples.stride == 1)
    std::copy(labels, labels + width, row);
  else
    takeSamples(labels, width, samples, row);
  const auto count = static_cast<std::size_t>(samplesAlong(width, samples));
  if (takes_only_) changeLabels(row, count, plane_count_, only_.data());
  std::int32_t any = 0;
  for (std::size_t i = 0; i < count; ++i) any |= row[i];
  return any != 0;
}

const std::int32_t* PlaneFitter::labelsInside(const FitSamples& samples, int rows, int row, std::size_t count,
                                              Band& band) const {
  const auto at = [&](int i) {
    const auto place = static_cast<std::size_t>(std::clamp(i, 0, rows - 1)) * pitch_;
    return sampled_labels_.data() + place + static_cast<std::size_t>(samples.margin);
  };
  keepInside(at(row), at(row - samples.margin), at(row + samples.margin), count,
             static_cast<std::size_t>(samples.margin), band.labels.data());
  return band.labels.data();
}

void PlaneFitter::sumBand(const DepthFrame& image, Sums sums, const FitSamples& samples,
                          const std::vector<std::int32_t>& labels, int begin, int end, Band& band) {
  const auto width = static_cast<std::size_t>(image.width());
  const bool is_whole = samples.stride == 1 && samples.offset == 0;
  const std::size_t padded = width + kRunLanes;
  band.points.resize(4 * padded);
  band.labels.resize(2 * width + kBehindLabels);
  float* x = band.points.data();
  float* y = x + padded;
  float* z = y + padded;
  SampleRow row;
  if (!samples.along_rays) row.weight = z + padded;
  row.measured = band.labels.data() + width;
  row.count = static_cast<std::size_t>(samplesAlong(image.width(), samples));
  row.z = z;
  if (image.isPinhole()) {
    row.across = across_.data();
    if (!is_whole) {
      band.across.resize(padded);
      takeSamples(across_.data(), image.width(), samples, band.across.data());
      row.across = band.across.data();
    }
  } else {
    row.x = x;
    row.y = y;
    row.depth_is_range = !isPerspective(image.projection());
  }
  const bool skips_rows = is_whole && takes_only_ && !sparse_rows_.empty();
  for (int i = begin; i < end; ++i) {
    const int r = samples.offset + i * samples.stride;
    if (skips_rows && sparse_rows_[static_cast<std::size_t>(r)] == 0) continue;
    row.labels = labels.data() + image.index(r, 0);
    if (sums == Sums::OfRays && samples.margin > 0) {
      row.labels = labelsInside(samples, samplesAlong(image.height(), samples), i, row.count, band);
    } else if (samples.margin > 0) {
      const std::size_t place = static_cast<std::size_t>(i) * pitch_ + static_cast<std::size_t>(samples.margin);
      std::int32_t* const kept = sampled_labels_.data() + place;
      if (!readLabels(row.labels, image.width(), samples, kept)) continue;
      std::fill_n(kept - samples.margin, samples.margin, kept[0]);  // beyond the image is no other label
      std::fill_n(kept + row.count, samples.margin, kept[row.count - 1]);
      row.labels = kept;
    } else if (!is_whole || takes_only_) {
      if (!readLabels(row.labels, image.width(), samples, band.labels.data())) continue;
      row.labels = band.labels.data();
    }
    if (!is_whole && sample_depth_ != nullptr) {
      row.z = sample_depth_ + static_cast<std::size_t>(i) * row.count;
      row.along = image.pinholeAlong(r);
    } else if (image.isPinhole()) {
      const bool in_place = is_whole && (depth_ == nullptr || r + 1 < image.height());  // what is behind the last row?
      const float* depth = is_whole ? z : x;
      if (depth_ != nullptr)
        depth = depth_ + static_cast<std::size_t>(r) * depth_stride_;
      else
        image.depthRow(r, is_whole ? z : x);
      if (!in_place) takeSamples(depth, image.width(), samples, z);
      row.z = in_place ? depth : z;
      row.along = image.pinholeAlong(r);
    } else {
      readPoints(image, {r, 1, samples.offset, static_cast<int>(row.count), samples.stride}, {x, y, z, padded});
    }
    if (sums == Sums::OfPoints)
      band.has_strays = addToLabelSums(row, variance_, plane_count_, band.sums.data()) || band.has_strays;
    else
      addToResidualSums(row, variance_, plane_count_, ray_planes_.data(), band.residual_sums.data());
  }
}

void PlaneFitter::sumAll(const DepthFrame& image, Sums sums, const FitSamples& samples, int threads,
                         const std::vector<std::int32_t>& labels) {
  const int rows = samplesAlong(image.height(), samples);
  sharedFor(kFitBands, threads, [&](int, int first_band, int end_band) {
    for (int b = first_band; b < end_band; ++b)
      sumBand(image, sums, samples, labels, rows * b / kFitBands, rows * (b + 1) / kFitBands,
              bands_[static_cast<std::size_t>(b)]);
  });
}

void PlaneFitter::countPixels(const DepthFrame& image, int threads, const std::vector<std::int32_t>& labels) {
  const auto pixels = static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
  sharedFor(kFitBands, threads, [&](int, int first_band, int end_band) {
    for (int b = first_band; b < end_band; ++b) {
      Band& band = bands_[static_cast<std::size_t>(b)];
      const std::size_t begin = pixels * static_cast<std::size_t>(b) / kFitBands;
      const std::size_t end = pixels * static_cast<std::size_t>(b + 1) / kFitBands;
      band.pixels.assign(static_cast<std::size_t>(plane_count_), 0);
      band.has_strays = countLabels(labels.data() + begin, end - begin, plane_count_, band.pixels.data());
    }
  });
  for (const Band& band : bands_)
    for (std::size_t i = 0; i < pixels_.size(); ++i) pixels_[i] += band.pixels[i];
}

double PlaneFitter::samplesOf(std::size_t plane) const {
  double n = 0.0;
  for (const Band& band : bands_)
    if (band.sums[plane].started)
      for (const double lane : band.sums[plane].lanes[0]) n += lane;
  return n;
}

bool PlaneFitter::hasSamples(std::size_t plane) const {
  return std::any_of(bands_.begin(), bands_.end(), [plane](const Band& band) { return band.sums[plane].started; });
}

// Thin or small planes may have missed the grid.
void PlaneFitter::findSparsePlanes(double fewest, int height, const RowSpan* rows) {
  only_.assign(is_sparse_.size() + 1, 0);
  has_sparse_ = false;
  sparse_rows_.assign(rows != nullptr ? static_cast<std::size_t>(height) : 0, 0);
  for (std::size_t i = 0; i < is_sparse_.size(); ++i) {
    is_sparse_[i] = pixels_[i] > 0 && samplesOf(i) < fewest ? 1 : 0;
    if (is_sparse_[i] == 0) continue;
    only_[i + 1] = static_cast<std::int32_t>(i + 1);
    has_sparse_ = true;
    if (rows != nullptr && rows[i].begin < rows[i].end)
      std::fill(sparse_rows_.begin() + rows[i].begin, sparse_rows_.begin() + rows[i].end, std::uint8_t{1});
  }
}

/// Of all of a sparse plane's pixels instead of its samples.
void PlaneFitter::sumSparsePlanes(const DepthFrame& image, Sums sums, const FitSamples& samples, int threads,
                                  const std::vector<std::int32_t>& labels) {
  if (!has_sparse_) return;
  for (Band& band : bands_)
    for (std::size_t i = 0; i < is_sparse_.size(); ++i) {
      if (is_sparse_[i] == 0) continue;
      if (sums == Sums::OfPoints) band.sums[i].started = false;
      if (sums == Sums::OfRays) band.residual_sums[i] = ResidualSums();
    }
  takes_only_ = true;
  sumAll(image, sums, {1, 0, samples.along_rays}, threads, labels);
  takes_only_ = false;
}

void PlaneFitter::sumThinPlanes(const DepthFrame& image, const FitSamples& samples, int threads,
                                const std::vector<std::int32_t>& labels) {
  constexpr double kFewestInside = 0.5;  // of a plane's samples
  if (samples.margin == 0) return;
  bool has_thin = false;
  only_.assign(pixels_.size() + 1, 0);
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    if (is_sparse_[i] != 0 || !hasSamples(i)) continue;
    double inside = 0.0;
    for (const Band& band : bands_)
      for (const double lane : band.residual_sums[i].lanes[kResidualSums - 1]) inside += lane;
    if (inside >= kFewestInside * samplesOf(i)) continue;
    has_thin = true;
    only_[i + 1] = static_cast<std::int32_t>(i + 1);
    for (Band& band : bands_) band.residual_sums[i] = ResidualSums();
  }
  if (!has_thin) return;
  takes_only_ = true;
  sumAll(image, Sums::OfRays, {samples.stride, samples.offset, true, 0}, threads, labels);
  takes_only_ = false;
}

}  // namespace epcc
