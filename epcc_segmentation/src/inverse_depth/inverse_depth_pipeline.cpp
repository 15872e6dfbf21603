// SPDX-License-Identifier: BSD-3-Clause
// S1 and S2 in each scan direction, then the steps on the joint regions.
#include "inverse_depth/inverse_depth_pipeline.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "inverse_depth/boundary_refinement.h"
#include "inverse_depth/region_merging.h"
#include "inverse_depth/sample_grid.h"
#include "inverse_depth/segment_records.h"
#include "inverse_depth/thickness.h"
#include "parallel_for.h"

namespace epcc {

namespace {

// Sigma by which another plane must suit a sample better before it leaves the one that it was in earlier frames.
constexpr double kSteadyGain = 1.0;
// A sample stays with a plane that it would not join: where a surface bends, residuals are what they were.
constexpr double kSteadyResidual = 4.0 / 3.0;

constexpr double kMayWait = 0.03;  // of the samples: if so many are new they are looked at
constexpr int kCoarserToWait = 2;  // the grid of a frame in which nothing is looked for

constexpr std::int32_t kFewestNewSamples = 64;  // as many as a block of those that are looked at together

}  // namespace

InverseDepthPipeline::InverseDepthPipeline(const Parameters& parameters, const SensorModel& sensor)
    : parameters_(parameters),
      sensor_(sensor),
      grid_parameters_(parameters.inverse_depth),
      grid_sensor_(sensor),
      directions_{DirectionalPlanes(true, parameters.inverse_depth, sensor),
                  DirectionalPlanes(false, parameters.inverse_depth, sensor)} {}

void InverseDepthPipeline::configure(const Parameters& parameters, const SensorModel& sensor) {
  parameters_ = parameters;
  sensor_ = sensor;
}

int InverseDepthPipeline::gridStride(int width, int height, const KnownPlanes* known) const {
  const bool may_wait = known != nullptr && known->may_wait && !known->search;
  return (may_wait ? kCoarserToWait : 1) * strideFor(longerSide(width, height), parameters_.inverse_depth.stride);
}

void InverseDepthPipeline::begin(InverseDepthImage& image, ScatteredPixels* scattered) {
  stride_ = gridStride(image.width, image.height, nullptr);
  takeGrid(image, scattered, stride_);
}

void InverseDepthPipeline::takeGrid(InverseDepthImage& image, ScatteredPixels* scattered, int stride) {
  const bool takes_blocks = scattered != nullptr && parameters_.inverse_depth.stride == 0;
  if (!takes_blocks && stride > 1) samples_.sample(image, stride, parameters_.threads);
  InverseDepthImage& grid = takes_blocks ? scattered->blocks() : stride > 1 ? samples_ : image;
  steps_ = takes_blocks ? grid.steps : GridSteps(stride);
  scattered_ = takes_blocks ? scattered : nullptr;
  const InverseDepthImage& as_large = takes_blocks ? grid : image;
  grid_parameters_ = onGrid(parameters_.inverse_depth, longerSide(as_large.width, as_large.height), steps_);
  if (takes_blocks) {  // some are empty by chance, and end nothing
    int& gap = grid_parameters_.expert.lines.max_gap_pixels;
    gap = std::max(gap, std::min(1, parameters_.inverse_depth.expert.lines.max_gap_pixels));
  }
  grid_sensor_ = onGrid(sensor_, steps_);
  pixel_noise_ = InverseDepthNoise::of(sensor_);
  pixel_noise_.place2 = image.placeVariance();
  grid.weigh(sensor_, takes_blocks ? grid.placeVariance() : pixel_noise_.place2, parameters_.threads);
  full_image_ = &image;
  image_ = &grid;
  map_.known = 0;
  searches_ = true;
  waits_ = false;
  continuation_ = nullptr;
  for (DirectionalPlanes& direction : directions_) direction.configure(grid_parameters_, grid_sensor_);
  directions_[0].setActive(parameters_.scan != ScanDirection::Rows);
  directions_[1].setActive(parameters_.scan != ScanDirection::Columns && image.planar_rows);
}

void InverseDepthPipeline::beginKnown(InverseDepthImage& image, const KnownPlanes& known, Continuation& continuation) {
  stride_ = gridStride(image.width, image.height, nullptr);
  if (known.may_wait && !known.search) {
    takeGrid(image, nullptr, gridStride(image.width, image.height, &known));
    labelKnown(known, continuation);
    waits_ = waitForMore(known);
    if (waits_) return;
  }
  takeGrid(image, nullptr, stride_);
  labelKnown(known, continuation);
  judges_known_ = known.search;
  has_rest_ = open_blocks_.hideRest(*image_, map_);
  searches_ = has_rest_ || judges_known_;
  if (!has_rest_) segmentNothing();
}

void InverseDepthPipeline::labelKnown(const KnownPlanes& known, Continuation& continuation) {
  KnownRegions::Rule rule;
  rule.max_residual = kSteadyResidual * grid_parameters_.expert.refinement.max_residual;
  rule.pixels_per_sample = grid_sensor_.pixelsPerSample();
  map_.known = static_cast<int>(known.planes.size());
  continuation_ = &continuation;
  InverseDepthParameters::Refinement& refinement = grid_parameters_.expert.refinement;
  refinement.flip_gain = std::max(refinement.flip_gain, kSteadyGain);
  rule.error_scale = known.error_scale;
  if (steps_.across > stride_) rule.row_step /= kCoarserToWait;
  known_.label(*image_, known, rule, map_, continuation);
}

/// What is labelled is all there is.
void InverseDepthPipeline::segmentNothing() {
  map_.accumulate(*image_, parameters_.threads);
  for (DirectionalPlanes& direction : directions_) direction.setActive(false);
}

// If little is new it is noted for a later frame. Planes are what they were: S7 and S9 are for frames in which
// something may have changed.
bool InverseDepthPipeline::waitForMore(const KnownPlanes& known) {
  const auto is_new = [this](std::size_t i) { return map_.labels[i] == 0 && image_->w[i] > 0.0f; };
  std::size_t count = 0;
  for (std::size_t i = 0; i < map_.labels.size(); ++i) count += is_new(i) ? 1 : 0;
  if (static_cast<double>(count) > kMayWait * static_cast<double>(map_.labels.size())) return false;
  continuation_->waiting_side = steps_.across;
  std::size_t i = 0;
  for (int row = 0; row < image_->height; ++row)
    for (int column = 0; column < image_->width; ++column, ++i) {
      if (is_new(i)) continuation_->waiting.push_back(full_image_->width * row * steps_.along + column * steps_.across);
      map_.labels[i] = std::max(map_.labels[i], 0);
    }
  has_rest_ = judges_known_ = searches_ = false;
  map_.confidence = known.confidence;
  map_.confidence.resize(known.planes.size(), 1.0);
  map_.known_plane.resize(known.planes.size());
  std::iota(map_.known_plane.begin(), map_.known_plane.end(), 0);
  segmentNothing();
  return true;
}

// The strips of both directions know nothing of each other. Those of rows, which take longer or shorter, are spread
// evenly among those of columns.
void InverseDepthPipeline::growLines() {
  for (DirectionalPlanes& direction : directions_) direction.beginLines(*image_, grid_parameters_);
  const int rows = directions_[1].strips();
  const int all = directions_[0].strips() + rows;
  strip_memory_.resize(static_cast<std::size_t>(std::max(1, parameters_.threads)));
  for (StripMemory& memory : strip_memory_) {  // no thread is to ask for memory because it had no strip so far
    memory.growing.configure(grid_parameters_);
    for (const DirectionalPlanes& direction : directions_)
      if (direction.strips() > 0) direction.makeRoom(memory);
  }
  sharedFor(all, parameters_.threads, [&](int thread, int begin, int end) {
    StripMemory& memory = strip_memory_[static_cast<std::size_t>(thread)];
    for (int k = begin; k < end; ++k) {
      const int row_strip = k * rows / all;
      if ((k + 1) * rows / all > row_strip)
        directions_[1].growStrip(*image_, row_strip, memory);
      else
        directions_[0].growStrip(*image_, k - row_strip, memory);
    }
  });
}

// The directions know nothing of each other until S3.
void InverseDepthPipeline::growPlanes() {
  parallelFor(static_cast<int>(directions_.size()), parameters_.threads, [&](int /*thread*/, int begin, int end) {
    for (int k = begin; k < end; ++k) directions_[static_cast<std::size_t>(k)].growPlanes(*image_);
  });
}

void InverseDepthPipeline::joinDirections() {
  if (continuation_ == nullptr) {
    joining_.join(*image_, directions_, parameters_.threads, map_);
    map_.accumulate(*image_, parameters_.threads);
    return;
  }
  if (!has_rest_) return;
  joining_.join(*image_, directions_, parameters_.threads, rest_map_);
  open_blocks_.showAll(*image_);
  searches_ = takeFound() || judges_known_;
  map_.accumulate(*image_, parameters_.threads);
}

// Small ones between searches are pieces of clutter, most of them, and of what surrounds it.
bool InverseDepthPipeline::takeFound() {
  std::vector<std::int32_t>& found = found_labels_;
  found.assign(rest_map_.regions.size() + 1, 0);
  for (const std::int32_t label : rest_map_.labels) ++found[static_cast<std::size_t>(label)];
  const std::int32_t fewest = judges_known_ ? 1 : kFewestNewSamples;
  std::int32_t last = map_.known;
  found[0] = 0;
  for (std::size_t k = 1; k < found.size(); ++k) found[k] = found[k] >= fewest ? ++last : 0;
  map_.regions.resize(static_cast<std::size_t>(last));
  if (last == map_.known) return false;
  for (std::size_t i = 0; i < map_.labels.size(); ++i) {
    const std::int32_t label = found[static_cast<std::size_t>(rest_map_.labels[i])];
    map_.labels[i] = label > 0 ? label : map_.labels[i];
  }
  return true;
}

int InverseDepthPipeline::bridge() const {
  const InverseDepthParameters::Merging& merging = grid_parameters_.expert.merging;
  const double blotch = merging.bridge_samples * grid_sensor_.pixelsPerLineSample();
  return std::max(merging.min_bridge_pixels, static_cast<int>(blotch));
}

void InverseDepthPipeline::mergeRegions() {
  if (!searches_) return;
  findContacts(*image_, bridge(), grid_parameters_.expert.refinement.max_residual, map_, contact_search_, contacts_,
               parameters_.threads);
  merger_.merge(contacts_, grid_parameters_, grid_sensor_, map_, parameters_.threads);
}

void InverseDepthPipeline::refineBoundaries() {
  epcc::refineBoundaries(*image_, grid_parameters_, map_, refinement_, parameters_.threads);
  mergeRegions();  // S6
  if (continuation_ == nullptr || !searches_) return;
  for (const RegionPair& pair : merger_.alikeKnown()) continuation_->alike.emplace_back(pair.low - 1, pair.high - 1);
  for (const RegionPair& pair : merger_.apartKnown()) continuation_->apart.emplace_back(pair.low - 1, pair.high - 1);
}

void InverseDepthPipeline::rejectClutter() {
  if (waits_) return;
  rejectRegions(*image_, grid_parameters_, grid_sensor_, map_, evidence_, parameters_.threads);
}

void InverseDepthPipeline::joinOccluded() {
  if (!searches_) return;
  findOccludedContacts(*image_, bridge(), grid_parameters_.expert.merging.max_occluder,
                       grid_parameters_.expert.refinement.max_residual, map_, occlusion_, contacts_,
                       parameters_.threads);
  merger_.merge(contacts_, grid_parameters_, grid_sensor_, map_, parameters_.threads);
  if (continuation_ == nullptr) return;
  for (const RegionPair& pair : merger_.alikeKnown()) continuation_->alike.emplace_back(pair.low - 1, pair.high - 1);
}

void InverseDepthPipeline::rejectThin() {
  if (waits_) return;
  epcc::rejectThin(*image_, grid_parameters_, grid_sensor_, steps_, map_, thickness_, parameters_.threads);
}

void InverseDepthPipeline::labelPixels() {
  if (steps_.isEveryPixel()) return;
  InverseDepthParameters::Refinement refinement = parameters_.inverse_depth.expert.refinement;
  if (continuation_ != nullptr) refinement.flip_gain = std::max(refinement.flip_gain, kSteadyGain);
  full_resolution_.label(*full_image_, pixel_noise_, map_, steps_, refinement, parameters_.threads, pixel_labels_);
}

FitSamples InverseDepthPipeline::fitSamples() const {
  if (scattered_ != nullptr) return FitSamples();
  // The refinement's last moves are of a pixel or two.
  constexpr int kMargin = 2;
  FitSamples samples;
  samples.margin = kMargin;
  for (const int stride : {steps_.across, stride_}) {
    if (sensor_.correlationLength() < stride) continue;
    samples.stride = stride;
    samples.offset = stride / 2;
    samples.margin = std::max(1, kMargin / stride);
    samples.fewest *= std::pow(static_cast<double>(stride_) / stride, 2);  // they say as much as more on a finer grid
    break;
  }
  return samples;
}

void InverseDepthPipeline::listSegments(const DepthFrame& frame, const std::vector<std::int32_t>& labels,
                                        SegmentFitter& fitter, std::vector<LineSegment>& segments) const {
  const auto width = static_cast<std::size_t>(image_->width);
  const std::int32_t* pixels = scattered_ != nullptr ? scattered_->samplePixels().data() : nullptr;
  const auto numbers = [this](std::size_t direction) { return directions_[direction].lines().segmentOf().data(); };
  if (directions_[0].active())
    appendSegments(frame, sensor_, {numbers(0), 1, width, steps_, pixels, frame.width(), 1}, labels, fitter, segments);
  if (directions_[1].active())
    appendSegments(frame.transposed(), sensor_,
                   {numbers(1), width, 1, GridSteps(steps_.along, steps_.across), pixels, 1, frame.width()}, labels,
                   fitter, segments);
}

}  // namespace epcc
