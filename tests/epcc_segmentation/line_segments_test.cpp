// SPDX-License-Identifier: BSD-3-Clause
// The list of line segments of both modes against the label image, the samples and the geometry.
#include "epcc_segmentation/line_segment.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "inverse_depth/segment_records.h"
#include "metric/recursive_statistics.h"
#include "tests/support/rendered_room.h"

namespace {

using epcc::DepthFrame;
using epcc::LineSegment;
using epcc::Parameters;
using epcc::PlaneExtractor;
using epcc::PlaneSegmentation;
using epcc::Projection;
using epcc::ScanDirection;
using epcc::SensorModel;

const SensorModel kSensor = SensorModel::axial(0.003, 0.001, 1.0);

/// A noisy corner of a room with holes.
epcc::test::RenderedRoom noisyRoom(unsigned seed = 1, int width = 160, int height = 120) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
  epcc::test::addNoise(room, kSensor, seed);
  for (std::size_t i = 0; i < room.depth.size(); i += 37) room.depth[i] = 0.0f;
  return room;
}

/// The inside of a box of 4 x 4 x 3 m around a spherical scanner: x forward, y left, z up.
std::vector<float> sphericalScan(int width, int height) {
  std::vector<float> xyz;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double azimuth = 1.2 - 2.4 * column / width;
      const double elevation = 0.9 - 1.8 * row / height;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                std::sin(elevation));
      const double range = 1.0 / std::max({std::abs(ray.x()) / 2.0, std::abs(ray.y()) / 2.0, std::abs(ray.z()) / 1.5});
      for (int k = 0; k < 3; ++k) xyz.push_back(static_cast<float>(range * ray(k)));
    }
  return xyz;
}

Parameters withSegments(Parameters parameters, ScanDirection scan) {
  parameters.line_segments = true;
  parameters.scan = scan;
  return parameters;
}

PlaneSegmentation extract(const DepthFrame& frame, const Parameters& parameters) {
  PlaneExtractor extractor(parameters, kSensor);
  PlaneSegmentation result;
  EXPECT_TRUE(extractor.extract(frame, result)) << extractor.error();
  return result;
}

/// A point in the coordinates that line_segment.h describes.
Eigen::Vector2d inSection(const Eigen::Vector3d& p, ScanDirection scan, Projection projection) {
  if (projection == Projection::Spherical) return {std::hypot(p.x(), p.y()), -p.z()};
  if (scan == ScanDirection::Rows) return {std::hypot(p.y(), p.z()), p.x()};
  return {std::hypot(p.x(), p.z()), projection == Projection::PerspectiveBackward ? -p.y() : p.y()};
}

/// The pixels between a segment's ends that have its label; in the paper mode, if there is one, its samples.
std::vector<int> positionsWithItsLabel(const LineSegment& segment, const PlaneSegmentation& result) {
  std::vector<int> positions;
  for (int i = segment.first; i <= segment.last; ++i)
    if (result.labels[static_cast<std::size_t>(segment.row(i) * result.width + segment.column(i))] == segment.label)
      positions.push_back(i);
  return positions;
}

void expectInOrder(const std::vector<LineSegment>& segments) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    EXPECT_LE(segments[i].first, segments[i].last);
    if (i == 0) continue;
    const auto key = [](const LineSegment& s) { return std::make_tuple(static_cast<int>(s.scan), s.line); };
    EXPECT_LE(key(segments[i - 1]), key(segments[i]));
    if (key(segments[i - 1]) == key(segments[i])) {
      EXPECT_LT(segments[i - 1].last, segments[i].first);
    }
  }
}

/// The end points lie on the line through the mean along the main axis, at the feet of the first and last sample.
void expectEndsOnTheLine(const LineSegment& segment, const DepthFrame& frame) {
  const Eigen::Vector2d normal = epcc::smallestEigenvector(Eigen::Matrix2d(segment.covariance));
  const Eigen::Vector2d axis(-normal.y(), normal.x());
  const Eigen::Vector2d mean = segment.mean;
  for (const auto& [end, position] :
       {std::make_pair(segment.start, segment.first), std::make_pair(segment.end, segment.last)}) {
    const Eigen::Vector2d t = inSection(end, segment.scan, frame.projection());
    Eigen::Vector3d sample;
    ASSERT_TRUE(frame.point(segment.row(position), segment.column(position), sample));
    const Eigen::Vector2d s = inSection(sample, segment.scan, frame.projection());
    EXPECT_NEAR((t - mean).dot(normal), 0.0, 1e-9);
    EXPECT_NEAR((s - t).dot(axis), 0.0, 1e-6);
    // In the section's plane, which holds the sample and the scan axis.
    Eigen::Vector3d across = sample.cross(Eigen::Vector3d(end));
    across /= sample.norm() * end.norm();
    const int axis_index = frame.projection() == Projection::Spherical ? 2
                           : segment.scan == ScanDirection::Rows       ? 0
                                                                       : 1;
    EXPECT_NEAR(across(axis_index), 0.0, 1e-6);
  }
}

/// The recursion against sums over the samples.
void expectBatchMoments(const LineSegment& segment, const std::vector<int>& positions, const DepthFrame& frame) {
  std::vector<Eigen::Vector2d> samples;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const int i : positions) {
    Eigen::Vector3d p;
    ASSERT_TRUE(frame.point(segment.row(i), segment.column(i), p));
    samples.push_back(inSection(p, segment.scan, frame.projection()));
    mean += samples.back() / static_cast<double>(positions.size());
  }
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const auto& t : samples) covariance += (t - mean) * (t - mean).transpose();
  covariance /= static_cast<double>(samples.size()) - 1.0;
  EXPECT_LT((mean - Eigen::Vector2d(segment.mean)).norm(), 1e-9);
  EXPECT_LT((covariance - Eigen::Matrix2d(segment.covariance)).norm(), 1e-9 * (1.0 + covariance.norm()));
}

/// All of the above for a frame in the paper mode; every labelled pixel lies in one segment, which has its label.
void expectPaperSegments(const DepthFrame& frame, ScanDirection scan) {
  const auto result = extract(frame, withSegments(Parameters::forPaper(), scan));
  ASSERT_GT(result.planes.size(), 1u);
  ASSERT_GT(result.segments.size(), 50u);
  expectInOrder(result.segments);
  std::vector<int> covered(result.labels.size(), 0);
  int unlabelled = 0;
  for (const LineSegment& segment : result.segments) {
    EXPECT_EQ(segment.scan, scan);
    EXPECT_GE(segment.variance, 0.0);
    expectEndsOnTheLine(segment, frame);
    const auto positions = positionsWithItsLabel(segment, result);
    if (segment.label == 0) {  // its pixels, its rejected ones and holes
      ++unlabelled;
      EXPECT_EQ(positions.size(), static_cast<std::size_t>(segment.last - segment.first + 1));
      continue;
    }
    ASSERT_EQ(positions.size(), static_cast<std::size_t>(segment.samples));
    for (const int i : positions)
      ++covered[static_cast<std::size_t>(segment.row(i) * result.width + segment.column(i))];
    expectBatchMoments(segment, positions, frame);
  }
  EXPECT_LT(unlabelled, static_cast<int>(result.segments.size()));
  for (std::size_t i = 0; i < covered.size(); ++i) EXPECT_EQ(covered[i], result.labels[i] > 0 ? 1 : 0) << i;
}

TEST(LineSegments, PaperModeByColumns) {
  const auto room = noisyRoom();
  expectPaperSegments(room.frame(), ScanDirection::Columns);
}

TEST(LineSegments, PaperModeByRows) {
  const auto room = noisyRoom();
  expectPaperSegments(room.frame(), ScanDirection::Rows);
}

TEST(LineSegments, PaperModeOnASphericalScan) {
  const auto xyz = sphericalScan(120, 90);
  expectPaperSegments(DepthFrame::fromPoints(xyz.data(), 3, 120, 90, Projection::Spherical), ScanDirection::Columns);
}

TEST(LineSegments, PaperModeOnABackwardCloud) {
  const auto room = noisyRoom();
  std::vector<float> xyz;
  for (int row = 0; row < room.camera.height; ++row)
    for (int column = 0; column < room.camera.width; ++column) {
      Eigen::Vector3d p = Eigen::Vector3d::Constant(std::nan(""));
      room.frame().point(row, column, p);
      for (const double value : {p.x(), -p.y(), -p.z()}) xyz.push_back(static_cast<float>(value));
    }
  const auto frame =
      DepthFrame::fromPoints(xyz.data(), 3, room.camera.width, room.camera.height, Projection::PerspectiveBackward);
  expectPaperSegments(frame, ScanDirection::Columns);
}

TEST(LineSegments, ATransposedViewCountsInTheCallersPixels) {
  const auto room = noisyRoom();
  const auto rows = extract(room.frame(), withSegments(Parameters::forPaper(), ScanDirection::Rows));
  const auto turned = extract(room.frame().transposed(), withSegments(Parameters::forPaper(), ScanDirection::Columns));
  ASSERT_EQ(rows.segments.size(), turned.segments.size());
  for (std::size_t i = 0; i < rows.segments.size(); ++i) {
    EXPECT_EQ(turned.segments[i].scan, ScanDirection::Rows);
    EXPECT_EQ(turned.segments[i].line, rows.segments[i].line);
    EXPECT_EQ(turned.segments[i].start, rows.segments[i].start);
  }
}

TEST(LineSegments, InverseDepthModeHasBothDirectionsAndTheLabelsOfTheEnd) {
  const auto room = noisyRoom();
  const auto result = extract(room.frame(), withSegments(Parameters(), ScanDirection::Both));
  expectInOrder(result.segments);
  std::map<ScanDirection, long> samples;
  for (const LineSegment& segment : result.segments) {
    samples[segment.scan] += segment.samples;
    expectEndsOnTheLine(segment, room.frame());
    const int pixels = segment.last - segment.first + 1;
    std::vector<int> all;
    for (int i = segment.first; i <= segment.last; ++i) all.push_back(i);
    if (segment.samples == pixels) expectBatchMoments(segment, all, room.frame());
    const auto with_its_label = static_cast<int>(positionsWithItsLabel(segment, result).size());
    EXPECT_GT(3 * with_its_label, segment.samples);  // three surfaces meet in the room's corner
  }
  for (const ScanDirection scan : {ScanDirection::Columns, ScanDirection::Rows})
    EXPECT_GT(samples[scan], static_cast<long>(room.depth.size()) * 8 / 10);
}

/// 640 pixels are wide enough for every second row and column.
TEST(LineSegments, OnAGridThoseOfItsScanLinesAreListedInPixelsOfTheImage) {
  const auto room = noisyRoom(1, 640, 480);
  const auto result = extract(room.frame(), withSegments(Parameters(), ScanDirection::Both));
  expectInOrder(result.segments);
  std::map<ScanDirection, std::set<int>> lines;
  for (const LineSegment& segment : result.segments) {
    lines[segment.scan].insert(segment.line);
    EXPECT_EQ(segment.line % 2, 1);
    EXPECT_EQ(segment.first % 2, 1);
    EXPECT_EQ(segment.last % 2, 1);
    EXPECT_LE(segment.samples, (segment.last - segment.first) / 2 + 1);
    expectEndsOnTheLine(segment, room.frame());
    std::vector<int> all;
    for (int i = segment.first; i <= segment.last; i += 2) all.push_back(i);
    if (segment.samples == static_cast<int>(all.size())) expectBatchMoments(segment, all, room.frame());
  }
  EXPECT_EQ(lines[ScanDirection::Columns].size(), 320u);
  EXPECT_EQ(lines[ScanDirection::Rows].size(), 240u);
  EXPECT_EQ(*lines[ScanDirection::Columns].rbegin(), 639);
  EXPECT_EQ(*lines[ScanDirection::Rows].rbegin(), 479);
}

TEST(LineSegments, InverseDepthModeOnASphericalScanHasColumnsOnly) {
  const auto xyz = sphericalScan(120, 90);
  const auto frame = DepthFrame::fromPoints(xyz.data(), 3, 120, 90, Projection::Spherical);
  const auto result = extract(frame, withSegments(Parameters(), ScanDirection::Both));
  ASSERT_GT(result.segments.size(), 100u);
  for (const LineSegment& segment : result.segments) {
    EXPECT_EQ(segment.scan, ScanDirection::Columns);
    expectEndsOnTheLine(segment, frame);
  }
}

TEST(LineSegments, AreNotKeptUnlessAskedFor) {
  const auto room = noisyRoom();
  for (Parameters parameters : {Parameters(), Parameters::forPaper()})
    EXPECT_EQ(extract(room.frame(), parameters).segments.capacity(), 0u);
}

TEST(LineSegments, AskingForThemChangesNothingElse) {
  const auto room = noisyRoom();
  for (const Parameters& parameters : {Parameters(), Parameters::forPaper()})
    EXPECT_EQ(extract(room.frame(), parameters).labels,
              extract(room.frame(), withSegments(parameters, parameters.scan)).labels);
}

TEST(LineSegments, AFailureLeavesNoneOfTheLastFrame) {
  const auto room = noisyRoom();
  PlaneExtractor extractor(withSegments(Parameters::forPaper(), ScanDirection::Columns), kSensor);
  PlaneSegmentation result;
  ASSERT_TRUE(extractor.extract(room.frame(), result));
  ASSERT_FALSE(result.segments.empty());
  EXPECT_FALSE(extractor.extract(DepthFrame::fromDepth(nullptr, {}), result));
  EXPECT_TRUE(result.segments.empty());
}

/// The label of a segment of six pixels of one column, the third of which was rejected.
std::int32_t labelOf(const std::vector<std::int32_t>& labels) {
  const std::vector<float> depth{2.0f, 2.001f, 2.5f, 2.0f, 2.001f, 2.0f};
  const std::vector<std::int32_t> segment_of{0, 0, -1, 0, 0, 0};
  std::vector<LineSegment> segments;
  epcc::SegmentFitter fitter(kSensor, epcc::ErrorCorrelation::of(kSensor));
  epcc::appendSegments(DepthFrame::fromDepth(depth.data(), {1, 6, 100.0, 100.0, 0.0, 2.5}), kSensor,
                       {segment_of.data(), 1, 1}, labels, fitter, segments);
  EXPECT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].samples, 5);
  EXPECT_EQ(segments[0].last, 5);
  return segments[0].label;
}

TEST(LineSegments, TheLabelThatMostSamplesHaveWins) {
  EXPECT_EQ(labelOf({2, 2, 1, 2, 1, 1}), 2);  // the rejected pixel has no say
  EXPECT_EQ(labelOf({0, 0, 3, 0, 3, 3}), 0);
  EXPECT_EQ(labelOf({0, 0, 1, 3, 3, 1}), 3);  // of equally frequent ones: a plane before none ...
  EXPECT_EQ(labelOf({2, 2, 1, 1, 1, 3}), 1);  // ... and the larger plane, which has the smaller number
}

}  // namespace
