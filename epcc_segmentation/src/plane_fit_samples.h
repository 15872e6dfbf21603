// SPDX-License-Identifier: BSD-3-Clause
// The fit of planes with its memory, from every pixel or from a grid of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "correlated_error.h"
#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "label_sums.h"
#include "ray_fit.h"
#include "ray_residuals.h"

namespace epcc {

/// The pixels that planes are fitted to: rows and columns offset + stride * i.
struct FitSamples {
  int stride = 1;
  int offset = 0;
  /// After the orthogonal fit, without weights, the step of fitAlongRays(), which errors of the depths do not bias;
  /// else, the paper's way, the orthogonal fit alone, which a stream can keep.
  bool along_rays = true;
  /// Of that step: samples so near to another plane in the grid, or to what is none, are left out. Which of two planes
  /// that are alike there got them was decided by their errors, so that those of either plane are not what they are
  /// elsewhere. A plane that would lose more than half of its samples keeps them all.
  int margin = 0;
  /// A plane with fewer samples on the grid is fitted to all of its pixels.
  double fewest = 100.0;
};

/// Of so many rows or columns, those that are samples.
inline int samplesAlong(int size, const FitSamples& samples) {
  return std::max(0, (size - samples.offset + samples.stride - 1) / samples.stride);
}

/// However many threads there are, the rows are summed in as many bands: one order of all sums.
constexpr int kFitBands = 8;

/// Rows begin .. end - 1; none if there is no such row.
struct RowSpan {
  int begin = std::numeric_limits<int>::max();
  int end = 0;
  void add(int row) { add({row, row + 1}); }
  void add(const RowSpan& other) {
    begin = std::min(begin, other.begin);
    end = std::max(end, other.end);
  }
};

/// fitPlanes() for a stream of frames. The result does not depend on the number of threads.
class PlaneFitter {
 public:
  /// As fitPlanes(). With a stride the sums come from the samples alone, of a plane with too few of them from all of
  /// its pixels; every labelled pixel counts in pixel_count, where without a stride those that are not measured do not.
  bool fit(const DepthFrame& frame, const SensorModel& sensor, int plane_count, const FitSamples& samples, int threads,
           PlaneSegmentation& segmentation);
  /// For the next fit: the depths of all labelled pixels of the image, which has been read before, in rows of `stride`.
  void lendDepth(const float* depth, std::size_t stride) {
    depth_ = depth;
    depth_stride_ = stride;
  }
  /// For the next fit with a stride, of a depth image: the depths of its samples, row after row, and kRunLanes values
  /// more; null if they are not at hand.
  void lendSampleDepth(const float* depth) { sample_depth_ = depth; }
  /// For the next fit with a stride: how many pixels have the labels 1 .. plane_count, and that there is no other but
  /// 0.
  void lendCounts(const long* pixels) { counts_ = pixels; }
  /// For the next fit with a stride: rows that hold all pixels of the labels 1 .. plane_count.
  void lendRows(const RowSpan* rows) { lent_rows_ = rows; }
  /// For the next fit: Plane::confidence of the labels 1 .. plane_count.
  void lendConfidence(const double* confidence) { confidence_ = confidence; }
  /// For the next fit: how the error is correlated, where that is known better than by the sensor model.
  void lendErrorCorrelation(const ErrorCorrelation& error) { lent_error_ = error; }
  /// Of planes[plane] of the last fit.
  const RayFit& rayFit(std::size_t plane) const;
  /// Gives the planes of the last fit the covariance of an error of this correlation.
  void correlate(const ErrorCorrelation& error, std::vector<Plane>& planes) const;
  /// Of the last fit: what became of the labels 0 .. plane_count.
  const std::vector<std::int32_t>& newLabels() const { return new_label_; }

 private:
  enum class Sums { OfPoints, OfRays };
  /// Memory of one of the bands of rows that are summed on their own, then joined in order.
  struct Band {
    std::vector<LabelSums> sums;
    std::vector<ResidualSums> residual_sums;
    std::vector<long> pixels;
    bool has_strays = false;
    std::vector<float> points;  // of a row: x, y, z
    std::vector<std::int32_t> labels;
    std::vector<double> across;
  };
  void prepare(const DepthFrame& image, const SensorModel& sensor, int plane_count, const FitSamples& samples);
  bool readLabels(const std::int32_t* labels, int width, const FitSamples& samples, std::int32_t* row) const;
  /// Labels of the samples of a row of the grid that are not in the margin.
  const std::int32_t* labelsInside(const FitSamples& samples, int rows, int row, std::size_t count, Band& band) const;
  /// Adds the samples of the rows offset + stride * [begin, end), of the labels that only_ keeps if takes_only_.
  void sumBand(const DepthFrame& image, Sums sums, const FitSamples& samples, const std::vector<std::int32_t>& labels,
               int begin, int end, Band& band);
  void sumAll(const DepthFrame& image, Sums sums, const FitSamples& samples, int threads,
              const std::vector<std::int32_t>& labels);
  void countPixels(const DepthFrame& image, int threads, const std::vector<std::int32_t>& labels);
  double samplesOf(std::size_t plane) const;
  bool hasSamples(std::size_t plane) const;
  void findSparsePlanes(double fewest, int height, const RowSpan* rows);
  void sumSparsePlanes(const DepthFrame& image, Sums sums, const FitSamples& samples, int threads,
                       const std::vector<std::int32_t>& labels);
  /// Sums without the margin of the planes that it leaves too little of.
  void sumThinPlanes(const DepthFrame& image, const FitSamples& samples, int threads,
                     const std::vector<std::int32_t>& labels);
  void fitPoints(const SensorModel& sensor, const FitSamples& samples);
  void fitRays(const DepthFrame& image, const FitSamples& samples);
  void listPlanes(std::vector<Plane>& planes);
  void renumber(int threads, std::vector<std::int32_t>& labels) const;

  SensorVariance variance_;
  ErrorCorrelation error_;
  std::optional<ErrorCorrelation> lent_error_;
  std::int32_t plane_count_ = 0;
  const float* depth_ = nullptr;
  const float* sample_depth_ = nullptr;
  std::size_t depth_stride_ = 0;
  const long* counts_ = nullptr;
  const RowSpan* lent_rows_ = nullptr;
  const double* confidence_ = nullptr;
  std::vector<double> across_;  // u of the image's columns
  std::vector<Band> bands_;
  std::vector<std::int32_t> sampled_labels_;  // where there is a margin, in rows of pitch_
  std::size_t pitch_ = 0;
  std::vector<std::int32_t> only_;  // by label: itself if it is sparse, or 0
  bool takes_only_ = false;
  std::vector<char> is_sparse_;  // by plane: fitted to all of its pixels
  bool has_sparse_ = false;
  std::vector<std::uint8_t> sparse_rows_;  // whether a row may have pixels of sparse planes; empty: each may
  std::vector<Plane> fits_;                // by label
  std::vector<RayPlane> ray_planes_;
  std::vector<RayFit> ray_fits_;
  std::vector<long> pixels_;
  std::vector<std::size_t> order_;
  std::vector<std::int32_t> new_label_;
};

}  // namespace epcc
