// SPDX-License-Identifier: BSD-3-Clause
// Collects what a stream hands out of one frame, and compares it with the frame segmented whole.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/scan_line_stream.h"

namespace epcc::test {

/// Labels and planes of a stream whose scan lines have the indices first, first + 1, ...; here they count from 0.
class StreamedFrame {
 public:
  StreamedFrame(ScanLineStream& stream, int lines, int height, std::int64_t first = 0)
      : height_(height), first_(first), last_line_(first - 1), labels_(static_cast<std::size_t>(lines * height), 0) {
    stream.onLine([this](const LabelledLine& line) { take(line); });
    stream.onPlane([this](const StreamPlane& plane) { take(plane); });
  }
  std::int64_t label(int line, int place) const { return labels_[static_cast<std::size_t>(line * height_ + place)]; }
  const std::map<std::int64_t, StreamPlane>& planes() const { return planes_; }
  int linesHandedOut() const { return lines_; }

 private:
  void take(const LabelledLine& line) {
    EXPECT_GT(line.index, last_line_) << "lines come in order";
    last_line_ = line.index;
    ++lines_;
    std::int32_t next = 0;
    for (const LabelRun& run : line) {
      EXPECT_LE(next, run.first);
      EXPECT_LE(run.first, run.last);
      EXPECT_LT(run.last, height_);
      EXPECT_EQ(planes_.count(run.plane), 0u) << "a plane comes behind its lines";
      next = run.last + 1;
      for (std::int32_t place = run.first; place <= run.last; ++place)
        labels_[static_cast<std::size_t>(line.index - first_) * static_cast<std::size_t>(height_) +
                static_cast<std::size_t>(place)] = run.plane;
    }
  }
  void take(const StreamPlane& plane) {
    EXPECT_LE(plane.last_line, last_line_) << "a plane comes behind its lines";
    EXPECT_TRUE(planes_.emplace(plane.id, plane).second) << "an id comes once";
  }

  int height_;
  std::int64_t first_;
  std::int64_t last_line_;
  int lines_ = 0;
  std::vector<std::int64_t> labels_;
  std::map<std::int64_t, StreamPlane> planes_;
};

template <typename Matrix>
void expectNear(const Matrix& a, const Matrix& b, double tolerance) {
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance) << a << "\n is not \n" << b;
}

inline void expectThePlane(const Plane& streamed, const Plane& whole) {
  EXPECT_EQ(streamed.pixel_count, whole.pixel_count);
  expectNear(streamed.coefficients, whole.coefficients, 1e-8);
  expectNear(streamed.centroid, whole.centroid, 1e-8);
  expectNear(streamed.points_covariance, whole.points_covariance, 1e-8);
  EXPECT_NEAR(streamed.rms, whole.rms, 1e-7);
  const double largest = whole.coefficients_covariance.cwiseAbs().maxCoeff();
  expectNear(streamed.coefficients_covariance, whole.coefficients_covariance, 1e-4 * largest + 1e-15);
}

/// The same labels, but for their numbers, and the same planes. `rows`: scan lines are rows of the frame.
inline void expectTheFrame(const StreamedFrame& streamed, const PlaneSegmentation& whole, bool rows = false) {
  std::map<std::int64_t, std::int32_t> label_of{{0, 0}};
  std::map<std::int32_t, std::int64_t> id_of{{0, 0}};
  std::size_t different = 0;
  for (int row = 0; row < whole.height; ++row)
    for (int column = 0; column < whole.width; ++column) {
      const std::int64_t id = rows ? streamed.label(row, column) : streamed.label(column, row);
      const std::int32_t label = whole.labels[static_cast<std::size_t>(row * whole.width + column)];
      if (label_of.emplace(id, label).first->second != label || id_of.emplace(label, id).first->second != id)
        ++different;
    }
  EXPECT_EQ(different, 0u) << "pixels differ";
  EXPECT_EQ(streamed.planes().size(), whole.planes.size());
  if (::testing::Test::HasFailure()) return;
  for (const auto& [id, plane] : streamed.planes()) {
    ASSERT_EQ(label_of.count(id), 1u);
    expectThePlane(plane.plane, whole.planes[static_cast<std::size_t>(label_of[id]) - 1]);
  }
}

inline Parameters wholeFrameParameters(const PaperParameters& paper, bool rows = false) {
  Parameters parameters = Parameters::forPaper();
  parameters.paper = paper;
  parameters.scan = rows ? ScanDirection::Rows : ScanDirection::Columns;
  return parameters;
}

/// Streams a depth image column by column, or row by row, and compares.
inline void expectTheWholeFrame(const DepthFrame& frame, const float* depth, const PinholeCamera& camera, bool rows,
                                StreamOptions options) {
  PlaneExtractor extractor(wholeFrameParameters(options.paper, rows), options.sensor);
  PlaneSegmentation whole;
  ASSERT_TRUE(extractor.extract(frame, whole)) << extractor.error();
  ScanLineStream stream(rows ? StreamGeometry::cameraRows(camera) : StreamGeometry::cameraColumns(camera), options);
  const int lines = rows ? camera.height : camera.width;
  StreamedFrame streamed(stream, lines, rows ? camera.width : camera.height);
  for (int i = 0; i < lines; ++i) {
    const bool taken = rows ? stream.addRow(i, depth + static_cast<std::ptrdiff_t>(i) * camera.width)
                            : stream.addColumn(i, depth + i, camera.width);
    ASSERT_TRUE(taken) << stream.error();
  }
  ASSERT_TRUE(stream.finish()) << stream.error();
  EXPECT_EQ(streamed.linesHandedOut(), lines);
  expectTheFrame(streamed, whole, rows);
}

/// The same of an organized cloud, column by column; points `stride` floats apart.
inline void expectTheWholeCloud(const float* xyz, std::size_t stride, int width, int height, Projection projection,
                                const StreamOptions& options, std::size_t fewest_planes) {
  PlaneExtractor extractor(wholeFrameParameters(options.paper), options.sensor);
  PlaneSegmentation whole;
  ASSERT_TRUE(extractor.extract(DepthFrame::fromPoints(xyz, stride, width, height, projection), whole))
      << extractor.error();
  ASSERT_GE(whole.planes.size(), fewest_planes);
  ScanLineStream stream(StreamGeometry::points(height, projection), options);
  StreamedFrame streamed(stream, width, height);
  const auto step = static_cast<std::ptrdiff_t>(stride);
  for (int c = 0; c < width; ++c) ASSERT_TRUE(stream.addPoints(c, xyz + step * c, step * width)) << stream.error();
  ASSERT_TRUE(stream.finish()) << stream.error();
  expectTheFrame(streamed, whole);
}

}  // namespace epcc::test
