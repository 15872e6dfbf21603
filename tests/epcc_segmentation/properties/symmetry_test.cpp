// SPDX-License-Identifier: BSD-3-Clause
// Transposed images, other units of length, clouds in other frames: what is promised of them, and no more. Mirrored
// images, images turned upside down, and in the inverse-depth mode transposed ones are segmented nearly alike, for ties
// go to what comes first.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <utility>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/epcc_segmentation/properties/random_frames.h"

namespace epcc::test {
namespace {

const std::vector<FrameKind> kPerspective{FrameKind::Depth, FrameKind::WholeNumbers, FrameKind::Cloud,
                                          FrameKind::BackwardCloud};

PlaneSegmentation segmented(const DepthFrame& frame, const Parameters& parameters, const SensorModel& sensor) {
  PlaneExtractor extractor(parameters, sensor);
  PlaneSegmentation result;
  (void)extractor.extract(frame, result);
  RC_ASSERT(extractor.error() == "");
  return result;
}

/// Pixel (row, column) of the one is pixel (column, row) of the other.
template <typename T>
std::vector<T> transposed(const std::vector<T>& values, int width, std::size_t of_pixel = 1) {
  const std::size_t columns = static_cast<std::size_t>(width) * of_pixel;
  std::vector<T> result;
  for (std::size_t c = 0; c < columns; c += of_pixel)
    for (std::size_t at = c; at < values.size(); at += columns)
      result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(at),
                    values.begin() + static_cast<std::ptrdiff_t>(at + of_pixel));
  return result;
}

RandomFrame transposed(const RandomFrame& frame) {
  RandomFrame other = frame;
  const PinholeCamera& camera = frame.camera;
  other.camera = {camera.height, camera.width, camera.fy, camera.fx, camera.cy, camera.cx};
  std::swap(other.spec.width, other.spec.height);
  other.depth = transposed(frame.depth, frame.spec.width);
  other.units = transposed(frame.units, frame.spec.width);
  other.mask = transposed(frame.mask, frame.spec.width);
  other.xyz = transposed(frame.xyz, frame.spec.width, 3);
  const float sign = frame.spec.kind == FrameKind::BackwardCloud ? -1.0f : 1.0f;  // its y is up
  for (std::size_t i = 0; i < other.xyz.size(); i += 3) {
    const float x = other.xyz[i];
    other.xyz[i] = sign * other.xyz[i + 1];
    other.xyz[i + 1] = sign * x;
  }
  return other;
}

RC_GTEST_PROP(Symmetry, RowsOfTheTransposedImageAreColumnsInThePaperMode, ()) {
  const RandomFrame frame(*anyFrame(kPerspective));
  const RandomFrame other = transposed(frame);
  Parameters columns = Parameters::forPaper();
  columns.scan = ScanDirection::Columns;
  Parameters rows = columns;
  rows.scan = ScanDirection::Rows;
  for (const auto& [a, b] : {std::pair(columns, rows), std::pair(rows, columns)}) {
    const PlaneSegmentation result = segmented(frame.frame(), a, frame.sensor());
    const PlaneSegmentation result_other = segmented(other.frame(), b, frame.sensor());
    RC_ASSERT(transposed(result.labels, frame.spec.width) == result_other.labels);
  }
}

/// Lengths in metres become lengths in parts of a metre: all that has a length is `factor` times as large.
void scale(RandomFrame& frame, float factor) {
  for (float& z : frame.depth) z *= factor;
  for (float& x : frame.xyz) x *= factor;
}

// Powers of two change no digit.
RC_GTEST_PROP(Symmetry, AnotherUnitOfLengthGivesTheSameLabels, ()) {
  const FrameSpec spec =
      *planarFrame({FrameKind::Depth, FrameKind::Cloud, FrameKind::BackwardCloud, FrameKind::Scanner});
  const RandomFrame frame(spec);
  Way way = *anyWay(spec.kind);
  const float factor = *rc::gen::element(0.25f, 0.5f, 2.0f, 8.0f);
  RandomFrame scaled = frame;
  scale(scaled, factor);
  const Parameters parameters = way.parameters();
  Parameters scaled_parameters = parameters;
  scaled_parameters.paper.max_gap *= factor;
  scaled_parameters.inverse_depth.expert.evidence.min_radius *= factor;
  const SensorModel sensor = frame.sensor();
  const auto [a, b, unused] = sensor.coefficients();
  (void)unused;
  const SensorModel scaled_sensor = SensorModel::axial(a * factor, b / factor);
  const PlaneSegmentation result = segmented(frame.frame(), parameters, sensor);
  const PlaneSegmentation scaled_result = segmented(scaled.frame(), scaled_parameters, scaled_sensor);
  RC_ASSERT(result.labels == scaled_result.labels);
}

/// Of the pixels that have a label in either, the share that has the same one in both.
double agreement(const PlaneSegmentation& a, const PlaneSegmentation& b) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> pairs;
  std::size_t labelled = 0;
  for (std::size_t i = 0; i < a.labels.size(); ++i) {
    if (a.labels[i] == 0 && b.labels[i] == 0) continue;
    ++labelled;
    if (a.labels[i] > 0 && b.labels[i] > 0) ++pairs[{a.labels[i], b.labels[i]}];
  }
  std::map<std::int32_t, std::size_t> most;
  for (const auto& [pair, count] : pairs) most[pair.first] = std::max(most[pair.first], count);
  std::size_t agree = 0;
  for (const auto& [label, count] : most) agree += count;
  return labelled > 0 ? static_cast<double>(agree) / static_cast<double>(labelled) : 1.0;
}

/// The cloud moved: p -> axes p + origin, and the geometry that says so.
CloudGeometry moved(RandomFrame& frame, const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin) {
  for (std::size_t i = 0; i < frame.xyz.size(); i += 3) {
    Eigen::Map<Eigen::Vector3f> point(&frame.xyz[i]);
    point = (axes * point.cast<double>() + origin).cast<float>();
  }
  CloudGeometry geometry;
  geometry.status = Status::Ok;
  geometry.is_plain = false;
  geometry.projection = frame.projection;
  geometry.pose.axes = axes;
  geometry.pose.origin = origin;
  return geometry;
}

const std::vector<FrameKind> kClouds{FrameKind::Cloud, FrameKind::BackwardCloud, FrameKind::Scanner};

RC_GTEST_PROP(Symmetry, AxesThatChangePlacesGiveTheSameLabelsToTheBit, ()) {
  const FrameSpec spec = *planarFrame(kClouds);
  const Way way = *anyWay(spec.kind);
  RandomFrame frame(spec);
  frame.closes_round = false;
  const PlaneSegmentation result = segmented(frame.frame(), way.parameters(), frame.sensor());
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  const int first = *rc::gen::inRange(0, 3), second = (first + *rc::gen::inRange(1, 3)) % 3;
  axes(first, 0) = *rc::gen::element(-1.0, 1.0);
  axes(second, 1) = *rc::gen::element(-1.0, 1.0);
  axes(3 - first - second, 2) = *rc::gen::element(-1.0, 1.0);
  const CloudGeometry geometry = moved(frame, axes, Eigen::Vector3d::Zero());
  const DepthFrame other = DepthFrame::fromPoints(frame.xyz.data(), 3, spec.width, spec.height, geometry);
  const PlaneSegmentation turned = segmented(other, way.parameters(), frame.sensor());
  RC_ASSERT(turned.labels == result.labels);
  for (std::size_t k = 0; k < result.planes.size(); ++k) {
    const Eigen::Vector4d plane = result.planes[k].coefficients, in_cloud = turned.planes[k].coefficients;
    RC_ASSERT((axes * plane.head<3>() - in_cloud.head<3>()).norm() < 1e-12);
    RC_ASSERT(std::abs(plane(3) - in_cloud(3)) < 1e-12 * std::max(1.0, plane(3)));
  }
}

// Coordinates are rounded anew, so that a few pixels at the limits of the gates may change sides.
RC_GTEST_PROP(Symmetry, ACloudThatIsMovedHasTheSamePlanesMoved, ()) {
  const FrameSpec spec = *planarFrame(kClouds);
  const Way way = *anyWay(spec.kind);
  RandomFrame frame(spec);
  frame.closes_round = false;
  const PlaneSegmentation result = segmented(frame.frame(), way.parameters(), frame.sensor());
  const auto angle = [] { return 0.01 * *rc::gen::inRange(-314, 315); };
  const auto metres = [] { return 0.1 * *rc::gen::inRange(-50, 51); };
  const Eigen::Matrix3d axes =
      (Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  const Eigen::Vector3d origin(metres(), metres(), metres());
  const CloudGeometry geometry = moved(frame, axes, origin);
  const DepthFrame other = DepthFrame::fromPoints(frame.xyz.data(), 3, spec.width, spec.height, geometry);
  const PlaneSegmentation there = segmented(other, way.parameters(), frame.sensor());
  RC_ASSERT(agreement(result, there) > 0.9);
  if (result.labels != there.labels) return;
  for (std::size_t k = 0; k < result.planes.size(); ++k) {
    const Eigen::Vector4d plane = result.planes[k].coefficients, in_cloud = there.planes[k].coefficients;
    RC_ASSERT((axes * plane.head<3>() - in_cloud.head<3>()).norm() < 1e-4);
    RC_ASSERT(std::abs(in_cloud(3) - (plane(3) - in_cloud.head<3>().dot(origin))) < 1e-3);
  }
}

}  // namespace
}  // namespace epcc::test
