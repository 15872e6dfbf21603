// SPDX-License-Identifier: BSD-3-Clause
// Checks the line segments of a view and their pixels against the reference.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "metric/metric_pipeline.h"
#include "tests/epcc_segmentation/metric/line_reference.h"
#include "tests/support/vector_units.h"

namespace epcc::test {

inline std::size_t pixelOf(const DepthFrame& view, int row, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width()) + static_cast<std::size_t>(column);
}

/// The reference's segments of every column.
template <typename T>
struct Reference {
  std::vector<std::vector<ReferenceSegment<T>>> lines;

  /// Of each pixel the place of its segment in the column, from 1; 0 none.
  std::vector<int> places(const DepthFrame& view) const {
    std::vector<int> result(static_cast<std::size_t>(view.width()) * static_cast<std::size_t>(view.height()), 0);
    for (int column = 0; column < view.width(); ++column) {
      int place = 0;
      for (const auto& segment : lines[static_cast<std::size_t>(column)]) {
        ++place;
        for (const auto& member : segment.members) result[pixelOf(view, member.row, column)] = place;
      }
    }
    return result;
  }
};

inline Reference<float> referenceOf(const DepthFrame& view, const Parameters& parameters, const SensorModel& sensor) {
  const ClusteringRule rule(parameters.paper, sensor);
  ReferenceClustering<float> clustering(rule);
  Reference<float> result;
  for (int c = 0; c < view.width(); ++c) result.lines.push_back(clustering.cluster(referenceLine(view, rule, c)));
  return result;
}

inline std::vector<int> placesOf(const MetricPipeline& pipeline, const DepthFrame& view) {
  std::vector<int> result;
  for (int row = 0; row < view.height(); ++row)
    for (int column = 0; column < view.width(); ++column) {
      const auto number =
          pipeline
              .numbers()[static_cast<std::size_t>(row) * pipeline.numberStride() + static_cast<std::size_t>(column)];
      result.push_back(
          number == 0 ? 0 : (number - pipeline.numberOf(column, 0)) / static_cast<int>(pipeline.numberStride()) + 1);
    }
  return result;
}

/// The reference in double precision.
inline Reference<double> preciseReferenceOf(const DepthFrame& view, const SensorModel& sensor) {
  ReferenceClustering<double> clustering(ClusteringRule(Parameters().paper, sensor));
  Reference<double> result;
  for (int c = 0; c < view.width(); ++c) result.lines.push_back(clustering.cluster(preciseLine(view, sensor, c)));
  return result;
}

/// Equal to the last bit, whichever unit computes them.
inline void expectTheReference(const DepthFrame& view, const Parameters& parameters, const SensorModel& sensor) {
  const Reference<float> reference = referenceOf(view, parameters, sensor);
  const std::vector<int> places = reference.places(view);
  onEveryVectorUnit([&] {
    MetricPipeline pipeline(parameters, sensor);
    pipeline.configure(parameters, sensor);
    pipeline.clusterLines(view);
    ASSERT_EQ(placesOf(pipeline, view), places);
    for (int column = 0; column < view.width(); ++column) {
      const auto& expected = reference.lines[static_cast<std::size_t>(column)];
      const auto& segments = pipeline.lineSegments()[static_cast<std::size_t>(column)];
      ASSERT_EQ(segments.size(), expected.size()) << "column " << column;
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const ClusteredLine& segment = segments[k];
        const auto& p = expected[k].prototype;
        ASSERT_EQ(segment.first, expected[k].members.front().row);
        ASSERT_EQ(segment.last, expected[k].members.back().row);
        ASSERT_EQ(segment.prototype.statistics.n, static_cast<int>(p.n));
        ASSERT_EQ(segment.prototype.statistics.mean.x(), static_cast<double>(p.mean1));
        ASSERT_EQ(segment.prototype.statistics.mean.y(), static_cast<double>(p.mean2));
        const double degrees = p.n - 1.0;
        ASSERT_EQ(segment.prototype.statistics.covariance(0, 0), static_cast<double>(p.s11) / degrees);
        ASSERT_EQ(segment.prototype.statistics.covariance(0, 1), static_cast<double>(p.s12) / degrees);
        ASSERT_EQ(segment.prototype.statistics.covariance(1, 1), static_cast<double>(p.s22) / degrees);
        ASSERT_EQ(segment.prototype.variance, static_cast<double>(p.residuals) / degrees);
      }
    }
  });
}

}  // namespace epcc::test
