// SPDX-License-Identifier: BSD-3-Clause
// Moments of the labelled pixels, planes with their covariance, labels in order of size.
#include "epcc_segmentation/plane_fit.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cloud_points.h"
#include "geometry/sensor_cloud.h"
#include "label_margin.h"
#include "label_table.h"
#include "parallel_for.h"
#include "plane_fit_samples.h"
#include "point_moments.h"
#include "ray_fit.h"
#include "thin_out.h"

namespace epcc {

namespace {

// However many threads there are, the rows are summed in as many bands: one order of all sums.
constexpr int kBands = 8;

int samplesAlong(int size, const FitSamples& samples) {
  return std::max(0, (size - samples.offset + samples.stride - 1) / samples.stride);
}

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
  sharedFor(kBands, threads, [&](int, int first_band, int end_band) {
    for (int b = first_band; b < end_band; ++b)
      sumBand(image, sums, samples, labels, rows * b / kBands, rows * (b + 1) / kBands,
              bands_[static_cast<std::size_t>(b)]);
  });
}

void PlaneFitter::countPixels(const DepthFrame& image, int threads, const std::vector<std::int32_t>& labels) {
  const auto pixels = static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
  sharedFor(kBands, threads, [&](int, int first_band, int end_band) {
    for (int b = first_band; b < end_band; ++b) {
      Band& band = bands_[static_cast<std::size_t>(b)];
      const std::size_t begin = pixels * static_cast<std::size_t>(b) / kBands;
      const std::size_t end = pixels * static_cast<std::size_t>(b + 1) / kBands;
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

/// The orthogonal fits, which the sums of what the samples are off along their rays need.
void PlaneFitter::fitPoints(const SensorModel& sensor, const FitSamples& samples) {
  const auto count = static_cast<std::size_t>(plane_count_);
  const double area = static_cast<double>(samples.stride) * static_cast<double>(samples.stride);
  fits_.assign(count, Plane());
  ray_planes_.assign(count, RayPlane());
  ray_fits_.assign(count, RayFit());
  for (std::size_t i = 0; i < count; ++i) {
    PointMoments moments;
    for (const Band& band : bands_) moments.add(band.sums[i]);
    if (moments.plain.one == 0.0) continue;
    if (samples.along_rays) moments.weighted = moments.plain;
    const double per_independent = sensor.pixelsPerSample() / (is_sparse_[i] != 0 ? 1.0 : area);
    fits_[i] = planeOf(moments, static_cast<std::size_t>(pixels_[i]), std::max(1.0, per_independent));
    ray_planes_[i] = rayPlaneOf(fits_[i]);
  }
}

void PlaneFitter::fitRays(const DepthFrame& image, const FitSamples& samples) {
  RayKind rays;
  rays.is_range = !isPerspective(image.projection());
  if (image.isPinhole()) {
    rays.pixels_u = 1.0 / (image.pinholeAcross(1) - image.pinholeAcross(0));
    rays.pixels_v = 1.0 / (image.pinholeAlong(1) - image.pinholeAlong(0));
  }
  for (std::size_t i = 0; i < fits_.size(); ++i) {
    if (!hasSamples(i)) continue;
    ResidualSums sums = {};
    for (const Band& band : bands_) addResidualSums(band.residual_sums[i], sums);
    rays.stride = is_sparse_[i] != 0 ? 1 : samples.stride;
    ray_fits_[i] = fitAlongRays(sums, rays, fits_[i]);
    setCovariance(ray_fits_[i], error_, fits_[i]);
  }
}

bool PlaneFitter::fit(const DepthFrame& frame, const SensorModel& sensor, int plane_count, const FitSamples& samples,
                      int threads, PlaneSegmentation& segmentation) {
  segmentation.planes.clear();
  const double* const confidence = std::exchange(confidence_, nullptr);
  const float* const lent_depth = std::exchange(depth_, nullptr);
  const float* const lent_samples = std::exchange(sample_depth_, nullptr);
  const long* const counts = std::exchange(counts_, nullptr);
  const RowSpan* const label_rows = std::exchange(lent_rows_, nullptr);
  const std::optional<ErrorCorrelation> lent_error = std::exchange(lent_error_, std::nullopt);
  const auto size = static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height());
  if (plane_count < 0 || segmentation.labels.size() != size) return false;
  const DepthFrame image = frame.isTransposed() ? frame.transposed() : frame;
  variance_ = SensorVariance(sensor);
  error_ = lent_error.value_or(ErrorCorrelation::of(sensor));
  depth_ = lent_depth;
  sample_depth_ = lent_samples;
  confidence_ = confidence;
  const auto count = static_cast<std::size_t>(plane_count);
  plane_count_ = plane_count;
  pixels_.assign(count, 0);
  is_sparse_.assign(count, 0);
  bands_.resize(kBands);
  for (Band& band : bands_) {
    band.sums.resize(std::max(count, band.sums.size()));
    for (std::size_t i = 0; i < count; ++i) band.sums[i].started = false;
    if (samples.along_rays) band.residual_sums.assign(count, ResidualSums());
    band.has_strays = false;
  }
  if (image.isPinhole()) {
    across_.resize(static_cast<std::size_t>(image.width() + kRunLanes));
    for (int c = 0; c < image.width(); ++c) across_[static_cast<std::size_t>(c)] = image.pinholeAcross(c);
  }
  if (samples.margin > 0) {
    const auto columns = static_cast<std::size_t>(samplesAlong(image.width(), samples));
    const auto rows = static_cast<std::size_t>(samplesAlong(image.height(), samples));
    const std::size_t pitch = columns + 2 * static_cast<std::size_t>(samples.margin) + kBehindLabels;
    if (pitch != pitch_ || pitch * rows != sampled_labels_.size()) sampled_labels_.assign(pitch * rows, 0);
    pitch_ = pitch;
  }
  sumAll(image, Sums::OfPoints, samples, threads, segmentation.labels);
  has_sparse_ = false;
  if (samples.stride > 1) {
    if (counts != nullptr)
      std::copy(counts, counts + count, pixels_.begin());
    else
      countPixels(image, threads, segmentation.labels);
    findSparsePlanes(samples.fewest, image.height(), label_rows);
    sumSparsePlanes(image, Sums::OfPoints, samples, threads, segmentation.labels);
  } else {
    for (std::size_t i = 0; i < count; ++i) pixels_[i] = static_cast<long>(samplesOf(i));
  }
  fitPoints(sensor, samples);
  if (samples.along_rays) {
    sumAll(image, Sums::OfRays, samples, threads, segmentation.labels);
    sumSparsePlanes(image, Sums::OfRays, samples, threads, segmentation.labels);
    sumThinPlanes(image, samples, threads, segmentation.labels);
    fitRays(image, samples);
  }
  listPlanes(segmentation.planes);
  renumber(threads, segmentation.labels);
  depth_ = nullptr;
  sample_depth_ = nullptr;
  confidence_ = nullptr;
  return true;
}

void PlaneFitter::listPlanes(std::vector<Plane>& planes) {
  order_.resize(pixels_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::sort(order_.begin(), order_.end(), [this](std::size_t i, std::size_t j) {
    return pixels_[i] != pixels_[j] ? pixels_[i] > pixels_[j] : i < j;
  });
  new_label_.assign(pixels_.size() + 1, 0);
  for (const std::size_t i : order_) {
    if (!hasSamples(i)) continue;
    planes.push_back(fits_[i]);
    if (confidence_ != nullptr) planes.back().confidence = confidence_[i];
    new_label_[i + 1] = static_cast<std::int32_t>(planes.size());
  }
}

void PlaneFitter::correlate(const ErrorCorrelation& error, std::vector<Plane>& planes) const {
  for (std::size_t i = 0; i < ray_fits_.size(); ++i)
    if (new_label_[i + 1] > 0)
      setCovariance(ray_fits_[i], error, planes[static_cast<std::size_t>(new_label_[i + 1]) - 1]);
}

const RayFit& PlaneFitter::rayFit(std::size_t plane) const {
  const auto found = std::find(new_label_.begin(), new_label_.end(), static_cast<std::int32_t>(plane + 1));
  return ray_fits_[static_cast<std::size_t>(found - new_label_.begin()) - 1];
}

void PlaneFitter::renumber(int threads, std::vector<std::int32_t>& labels) const {
  bool changes = false;
  for (const Band& band : bands_) changes = changes || band.has_strays;
  for (std::size_t i = 0; i < new_label_.size(); ++i)
    changes = changes || new_label_[i] != static_cast<std::int32_t>(i);
  if (!changes) return;
  sharedFor(kBands, threads, [&](int, int first_band, int end_band) {
    const std::size_t begin = labels.size() * static_cast<std::size_t>(first_band) / kBands;
    const std::size_t end = labels.size() * static_cast<std::size_t>(end_band) / kBands;
    changeLabels(labels.data() + begin, end - begin, plane_count_, new_label_.data());
  });
}

bool fitPlanes(const DepthFrame& frame, const SensorModel& sensor, int plane_count, PlaneSegmentation& segmentation) {
  if (frame.geometry() != nullptr) {
    const auto size = static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height());
    segmentation.planes.clear();
    if (plane_count < 0 || segmentation.labels.size() != size) return false;
    SensorCloud cloud;
    const DepthFrame own = cloud.of(frame, 1);
    PlaneSegmentation in_sensor_frame;
    cloud.takeLabels(segmentation.labels, in_sensor_frame.labels);
    PlaneFitter().fit(own, sensor, plane_count, FitSamples(), 1, in_sensor_frame);
    cloud.giveBack(in_sensor_frame);
    segmentation.labels.swap(in_sensor_frame.labels);
    segmentation.planes.swap(in_sensor_frame.planes);
    return true;
  }
  return PlaneFitter().fit(frame, sensor, plane_count, FitSamples(), 1, segmentation);
}

}  // namespace epcc
