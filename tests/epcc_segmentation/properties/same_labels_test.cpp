// SPDX-License-Identifier: BSD-3-Clause
// What must not change a result, to the bit: repetition, order of the settings, threads, vector units, unused numbers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/vector_unit.h"
#include "tests/epcc_segmentation/properties/random_frames.h"

namespace epcc::test {
namespace {

bool areEqual(const PlaneSegmentation& a, const PlaneSegmentation& b, bool covariances = true) {
  if (a.labels != b.labels || a.planes.size() != b.planes.size() || a.segments.size() != b.segments.size())
    return false;
  for (std::size_t k = 0; k < a.planes.size(); ++k) {
    const Plane &p = a.planes[k], &q = b.planes[k];
    if (covariances && p.coefficients_covariance != q.coefficients_covariance) return false;
    if (p.coefficients != q.coefficients || p.centroid != q.centroid || p.points_covariance != q.points_covariance ||
        p.rms != q.rms || p.confidence != q.confidence)
      return false;
  }
  return true;
}

PlaneSegmentation segmented(PlaneExtractor& extractor, const DepthFrame& frame) {
  PlaneSegmentation result;
  (void)extractor.extract(frame, result);
  RC_ASSERT(extractor.error() == "");
  return result;
}

PlaneSegmentation segmented(const RandomFrame& frame, const Way& way) {
  PlaneExtractor extractor(way.parameters(), way.sensor(frame.sensor()));
  return segmented(extractor, frame.frame());
}

struct Case {
  Case() : spec(*anyFrame()), way(*anyWay(spec.kind)), frame(spec) {}
  FrameSpec spec;
  Way way;
  RandomFrame frame;
};

RC_GTEST_PROP(SameLabels, WhenAFrameIsSegmentedAgain, ()) {
  const Case c;
  const RandomFrame other(*anyFrame());
  PlaneExtractor extractor(c.way.parameters(), c.way.sensor(c.frame.sensor()));
  const PlaneSegmentation first = segmented(extractor, c.frame.frame());
  // What is measured of the sensor settles over a stream, its slow bending from the second frame on.
  RC_ASSERT(areEqual(segmented(extractor, c.frame.frame()), first, !c.way.is_measured));
  PlaneSegmentation ignored;
  // A scanner's rows cannot be segmented: that leaves nothing behind either.
  (void)extractor.extract(other.frame(), ignored);
  if (c.way.is_measured)
    extractor.setSensorAuto();  // forgets both
  else
    extractor.setSensor(c.frame.sensor());
  RC_ASSERT(areEqual(segmented(extractor, c.frame.frame()), first));
}

RC_GTEST_PROP(SameLabels, WhateverTheOrderOfTheSettings, ()) {
  const Case c;
  const Way other = *anyWay(c.spec.kind);
  PlaneExtractor extractor(other.parameters(), other.sensor(SensorModel::axial(0.05, 0.0)));
  const auto set_sensor = [&] {
    if (c.way.is_measured)
      extractor.setSensorAuto();
    else
      extractor.setSensor(c.frame.sensor());
  };
  const bool sensor_first = *rc::gen::arbitrary<bool>();
  if (sensor_first) set_sensor();
  extractor.setParameters(c.way.parameters());
  if (!sensor_first) set_sensor();
  RC_ASSERT(areEqual(segmented(extractor, c.frame.frame()), segmented(c.frame, c.way)));
}

RC_GTEST_PROP(SameLabels, ForEveryNumberOfThreads, ()) {
  Case c;
  c.way.threads = 1;
  const PlaneSegmentation one = segmented(c.frame, c.way);
  c.way.threads = *rc::gen::element(2, 3, 4, 7, 64);
  RC_ASSERT(areEqual(segmented(c.frame, c.way), one));
}

RC_GTEST_PROP(SameLabels, OnEveryVectorUnit, ()) {
  const Case c;
  const std::string before = vectorUnit();
  std::vector<PlaneSegmentation> results;
  for (const std::string& unit : vectorUnits()) {
    setVectorUnit(unit);
    results.push_back(segmented(c.frame, c.way));
  }
  setVectorUnit(before);
  for (const PlaneSegmentation& result : results) RC_ASSERT(areEqual(result, results.front()));
}

/// Other numbers where nothing is measured or given: of a masked pixel anything, of an invalid one something as
/// invalid.
RandomFrame withOtherUnusedNumbers(RandomFrame frame, unsigned seed) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float nothing[] = {0.0f, -0.0f, -3.0f, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()};
  const auto next = [&seed] { return seed = 1664525u * seed + 1013904223u, seed >> 16; };
  const auto anything = [&] {
    return next() % 3 == 0 ? nothing[next() % 6] : 1e-3f * static_cast<float>(next() % 9000);
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(frame.spec.width * frame.spec.height); ++i) {
    if (frame.isValid(i)) continue;
    const bool is_masked = !frame.mask.empty() && frame.mask[i] == 0;
    if (frame.spec.kind == FrameKind::Depth) frame.depth[i] = is_masked ? anything() : nothing[next() % 6];
    if (frame.spec.kind == FrameKind::WholeNumbers)
      frame.units[i] = static_cast<std::uint16_t>(is_masked ? next() : next() % 2 == 0 ? 0 : 65535);
    if (!frame.isCloud()) continue;
    for (std::size_t k = 0; k < 3; ++k) frame.xyz[3 * i + k] = anything();
    if (!is_masked) frame.xyz[3 * i + next() % 3] = nothing[3 + next() % 3];  // not finite
  }
  return frame;
}

RC_GTEST_PROP(SameLabels, WhateverTheUnusedNumbersAre, ()) {
  const Case c;
  const RandomFrame other = withOtherUnusedNumbers(c.frame, *rc::gen::arbitrary<unsigned>());
  RC_ASSERT(areEqual(segmented(other, c.way), segmented(c.frame, c.way)));
}

// A mask is nothing else than pixels that are not measured.
RC_GTEST_PROP(SameLabels, WithAMaskAsWithHoles, ()) {
  Case c;
  RandomFrame holes = c.frame;
  holes.mask.clear();
  for (std::size_t i = 0; i < c.frame.mask.size(); ++i) {
    if (c.frame.mask[i] != 0) continue;
    if (!holes.depth.empty()) holes.depth[i] = 0.0f;
    if (!holes.units.empty()) holes.units[i] = 0;
    if (!holes.xyz.empty()) holes.xyz[3 * i] = NAN;
  }
  RC_ASSERT(areEqual(segmented(holes, c.way), segmented(c.frame, c.way)));
}

}  // namespace
}  // namespace epcc::test
