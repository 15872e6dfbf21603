// SPDX-License-Identifier: BSD-3-Clause
// Renders, fits or segments, compares with the truth.
#include "eval/consistency/consistency.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "datasets/rendered/scene.h"
#include "epcc_segmentation/line_fit.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_fit.h"
#include "eval/consistency/rendered_errors.h"

namespace epcc {

namespace {

constexpr double kSameSurface = 0.8;
constexpr int kEveryLine = 4;  // scan lines side by side err alike where the error is correlated

/// The true labels, of measured pixels of planes.
std::vector<std::int32_t> trueLabels(const LabelledFrame& frame, const std::map<int, Vector4>& planes) {
  std::vector<std::int32_t> labels;
  for (std::size_t i = 0; i < frame.labels.data.size(); ++i) {
    const int label = frame.labels.data[i];
    labels.push_back(frame.depth.data[i] > 0.0f && planes.count(label) > 0 ? label : 0);
  }
  return labels;
}

/// The section of a plane: theta of the line that a segment's scan line sees of it.
Vector2 sectionOf(const Vector4& plane, const LineSegment& segment, const PinholeCamera& camera) {
  const bool is_row = segment.scan == ScanDirection::Rows;
  const double across = is_row ? (segment.line - camera.cy) / camera.fy : (segment.line - camera.cx) / camera.fx;
  const double forward = ((is_row ? plane(1) : plane(0)) * across + plane(2)) / std::hypot(1.0, across);
  return Vector2(forward, is_row ? plane(0) : plane(1)) / -plane(3);
}

void add(const std::string& what, double square, ConsistencyRow& row) {
  row.what.push_back(what);
  row.by_what.push_back(square);
}

/// The planes of a result on the surfaces that they have most of.
void addPlanes(const std::string& scene, const PlaneSegmentation& result, const std::vector<std::int32_t>& labels,
               const std::map<int, Vector4>& planes, ConsistencyRow& row) {
  for (const auto& [surface, truth] : planes) {
    std::vector<std::size_t> pixels(result.planes.size() + 1, 0);
    std::size_t all = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] != surface) continue;
      ++all;
      ++pixels[static_cast<std::size_t>(result.labels[i])];
    }
    const auto best = std::max_element(pixels.begin() + 1, pixels.end());
    if (best == pixels.end() || *best == 0) continue;
    const Plane& plane = result.planes[static_cast<std::size_t>(best - pixels.begin()) - 1];
    const auto shared = static_cast<double>(*best);
    if (shared < kSameSurface * static_cast<double>(all)) continue;
    if (shared < kSameSurface * static_cast<double>(plane.pixel_count)) continue;
    add(scene + std::to_string(surface), normalisedSquaredError(plane, truth), row);
  }
}

void addLines(const LabelledFrame& frame, const PlaneSegmentation& result, const std::map<int, Vector4>& planes,
              ConsistencyRow& row) {
  for (const LineSegment& segment : result.segments) {
    if (segment.line % kEveryLine != 0 || !(segment.theta_covariance.trace() > 0.0)) continue;
    row.squares.push_back(
        normalisedSquaredError(segment, sectionOf(planes.at(segment.label), segment, frame.camera.camera)));
  }
}

/// The ways of one error: rows for exact labels, lines, model given, sensor measured.
class OneError {
 public:
  explicit OneError(const RenderedError& error) : error_(error) {
    for (const char* labels : {"exact", "segmented", "auto"}) rows_.push_back({error.name, labels, 3, {}, {}, {}});
    rows_.push_back({error.name, "exact", 2, {}, {}, {}});
  }

  void addScene(const std::string& name, const KnownScene& scene, int runs, const std::function<void()>& ran) {
    PlaneExtractor with_model(Parameters(), error_.sensor), measuring;
    for (int run = 0; run < runs; ++run) {
      const LabelledFrame frame = scene.rendering(error_, run);
      const auto labels = trueLabels(frame, scene.planes);
      PlaneSegmentation result;
      if (!error_.is_stereo) addExact(name, frame, scene, labels);
      segment(with_model, frame, result);
      addPlanes(name, result, labels, scene.planes, rows_[1]);
      segment(measuring, frame, result);
      addPlanes(name, result, labels, scene.planes, rows_[2]);
      ran();
    }
  }

  std::vector<ConsistencyRow> rows() {
    for (ConsistencyRow& row : rows_) {
      if (row.parameters == 3) row.squares = row.by_what;
      std::sort(row.squares.begin(), row.squares.end());
    }
    return rows_;
  }

 private:
  /// True labels of stereo depth hold wrong matches and pixels that fly between two surfaces: there are no exact ones.
  void addExact(const std::string& name, const LabelledFrame& frame, const KnownScene& scene,
                const std::vector<std::int32_t>& labels) {
    PlaneSegmentation result;
    result.labels = labels;
    fitPlanes(frameView(frame), error_.sensor, scene.planes.rbegin()->first, result);
    addPlanes(name, result, labels, scene.planes, rows_[0]);
    result.labels = labels;
    fitLines(frameView(frame), error_.sensor, ScanDirection::Both, result);
    addLines(frame, result, scene.planes, rows_[3]);
  }

  static void segment(PlaneExtractor& extractor, const LabelledFrame& frame, PlaneSegmentation& result) {
    if (!extractor.extract(frameView(frame), result)) throw std::runtime_error(extractor.error());
  }

  RenderedError error_;
  std::vector<ConsistencyRow> rows_;
};

}  // namespace

double normalisedSquaredError(const Plane& plane, const Vector4& truth) {
  const Eigen::Vector4d facing = truth.head<3>().dot(plane.coefficients.head<3>()) < 0.0 ? -truth : Vector4(truth);
  const Eigen::Vector4d error = plane.coefficients - facing;
  const Eigen::Matrix4d covariance = plane.coefficients_covariance;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(covariance);
  double sum = 0.0;
  for (int k = 1; k < 4; ++k) sum += std::pow(solver.eigenvectors().col(k).dot(error), 2) / solver.eigenvalues()(k);
  return sum;
}

double normalisedSquaredError(const LineSegment& segment, const Vector2& truth) {
  const Eigen::Vector2d error = segment.theta - truth;
  const Eigen::Matrix2d covariance = segment.theta_covariance;
  return error.dot(covariance.inverse() * error);
}

double ConsistencyRow::mean() const {
  return std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(squares.size());
}

double ConsistencyRow::quantile(double share) const {
  return squares.at(static_cast<std::size_t>(share * static_cast<double>(squares.size() - 1)));
}

std::vector<ConsistencyRow> runConsistency(int runs, const std::function<void(std::size_t, std::size_t)>& progress) {
  const auto errors = renderedErrors();
  const auto names = sceneNames();
  const std::size_t total = errors.size() * names.size() * static_cast<std::size_t>(runs);
  std::size_t done = 0;
  std::vector<ConsistencyRow> rows;
  std::vector<KnownScene> scenes;
  for (const std::string& name : names) scenes.emplace_back(name);
  for (const RenderedError& error : errors) {
    OneError one(error);
    for (std::size_t k = 0; k < names.size(); ++k)
      one.addScene(names[k], scenes[k], runs, [&] { progress(++done, total); });
    for (const ConsistencyRow& row : one.rows()) rows.push_back(row);
  }
  return rows;
}

}  // namespace epcc
