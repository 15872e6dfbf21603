// SPDX-License-Identifier: BSD-3-Clause
// Scans of floor plans: the truth is that of the beams, and their errors have the size that was asked for.
#include "datasets/rendered/floor_plan.h"

#include <gtest/gtest.h>

#include <cmath>

namespace epcc {
namespace {

TEST(FloorPlan, BeamsEndOnTheFacesTheyAreSaidToHit) {
  LaserSensor sensor;
  sensor.noise_a = sensor.noise_b = 0.0;
  for (const FloorScan& scan : scanOffice(sensor, 10, 3)) {
    EXPECT_GT(scan.faces.size(), 8U);
    for (std::size_t k = 0; k < scan.faces.size(); ++k) {
      const SeenFace& face = scan.faces[k];
      for (const int beam : face.beams) {
        const auto at = static_cast<std::size_t>(beam);
        EXPECT_EQ(scan.labels[at], static_cast<int>(k + 1));
        EXPECT_NEAR(scan.record.scan.ranges[at] * std::cos(scan.record.scan.angle(at) - face.alpha), face.rho, 1e-9);
      }
      for (const Vector2& end : {face.start, face.end})
        EXPECT_NEAR(std::cos(face.alpha) * end.x() + std::sin(face.alpha) * end.y(), face.rho, 1e-9);
      EXPECT_GT(face.rho, 0.0);
    }
  }
}

TEST(FloorPlan, ErrorsHaveTheirSize) {
  LaserSensor exact;
  exact.noise_a = exact.noise_b = 0.0;
  const LaserSensor noisy;
  const std::vector<FloorScan> truth = scanOffice(exact, 10, 0), scans = scanOffice(noisy, 10, 0);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < scans.size(); ++i)
    for (std::size_t beam = 0; beam < 720; ++beam) {
      const double range = truth[i].record.scan.ranges[beam];
      const double error = (scans[i].record.scan.ranges[beam] - range) / (0.01 + 0.001 * range);
      sum += error * error;
      ++count;
    }
  EXPECT_NEAR(sum / count, 1.0, 0.05);
}

TEST(FloorPlan, SeedsPutTheBoxesElsewhereAndNothingInThePath) {
  const FloorPlan a = officeFloor(1), b = officeFloor(2), again = officeFloor(1);
  ASSERT_EQ(a.faces.size(), b.faces.size());
  EXPECT_EQ(a.faces.back().from, again.faces.back().from);
  EXPECT_NE(a.faces.back().from, b.faces.back().from);
  for (const FloorScan& scan : scanOffice(LaserSensor::halfCircle(), 40, 1))
    for (const double range : scan.record.scan.ranges) EXPECT_GT(range, 0.2);
}

}  // namespace
}  // namespace epcc
