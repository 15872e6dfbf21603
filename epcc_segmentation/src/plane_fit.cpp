// SPDX-License-Identifier: BSD-3-Clause
// Planes with their covariance from sums over the labelled pixels, labels in order of size.
#include "epcc_segmentation/plane_fit.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "close_labels.h"
#include "geometry/sensor_cloud.h"
#include "label_margin.h"
#include "label_table.h"
#include "parallel_for.h"
#include "plane_fit_samples.h"
#include "point_moments.h"
#include "ray_fit.h"

namespace epcc {

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

/// Memory for the sums, without any.
void PlaneFitter::prepare(const DepthFrame& image, const SensorModel& sensor, int plane_count,
                          const FitSamples& samples) {
  variance_ = SensorVariance(sensor);
  const auto count = static_cast<std::size_t>(plane_count);
  plane_count_ = plane_count;
  pixels_.assign(count, 0);
  is_sparse_.assign(count, 0);
  bands_.resize(kFitBands);
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
  error_ = lent_error.value_or(ErrorCorrelation::of(sensor));
  depth_ = lent_depth;
  sample_depth_ = lent_samples;
  confidence_ = confidence;
  const auto count = static_cast<std::size_t>(plane_count);
  prepare(image, sensor, plane_count, samples);
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
  sharedFor(kFitBands, threads, [&](int, int first_band, int end_band) {
    const std::size_t begin = labels.size() * static_cast<std::size_t>(first_band) / kFitBands;
    const std::size_t end = labels.size() * static_cast<std::size_t>(end_band) / kFitBands;
    changeLabels(labels.data() + begin, end - begin, plane_count_, new_label_.data());
  });
}

bool fitPlanes(const DepthFrame& frame, const SensorModel& sensor, int plane_count, PlaneSegmentation& segmentation) {
  const auto size = static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height());
  segmentation.planes.clear();
  if (plane_count < 0 || segmentation.labels.size() != size) return false;
  const int count = closeLabels(plane_count, segmentation.labels);  // each takes kilobytes for its sums
  if (frame.geometry() == nullptr) return PlaneFitter().fit(frame, sensor, count, FitSamples(), 1, segmentation);
  SensorCloud cloud;
  const DepthFrame own = cloud.of(frame, 1);
  PlaneSegmentation in_sensor_frame;
  cloud.takeLabels(segmentation.labels, in_sensor_frame.labels);
  PlaneFitter().fit(own, sensor, count, FitSamples(), 1, in_sensor_frame);
  cloud.giveBack(in_sensor_frame);
  segmentation.labels.swap(in_sensor_frame.labels);
  segmentation.planes.swap(in_sensor_frame.planes);
  return true;
}

}  // namespace epcc
