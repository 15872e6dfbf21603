// SPDX-License-Identifier: BSD-3-Clause
// S4, S7 and S8: which regions are one surface, and which are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "inverse_depth/evidence.h"
#include "inverse_depth/region_contacts.h"
#include "inverse_depth/region_merging.h"
#include "inverse_depth/surface_bending.h"
#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::InverseDepthImage;
using epcc::PlaneMoments;
using epcc::RegionMap;
using epcc::RegionPair;
using epcc::SensorModel;
using epcc::test::imageOf;
using epcc::test::kWhite;
using epcc::test::regionsOf;
using epcc::test::RenderedRoom;

// ---- S4 ----

/// A wall cut into vertical strips of `strip` columns, each a region of its own.
std::vector<std::int32_t> strips(const epcc::PinholeCamera& camera, int strip) {
  std::vector<std::int32_t> labels;
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) labels.push_back(1 + column / strip);
  return labels;
}

void merge(const InverseDepthImage& image, const SensorModel& sensor, RegionMap& map) {
  std::vector<epcc::ContactSearchMemory> memory;
  epcc::RegionContacts contacts;
  epcc::findContacts(image, 25, 3.0, map, memory, contacts);
  epcc::RegionMerger().merge(contacts, epcc::InverseDepthParameters(), sensor, map);
}

TEST(RegionMerging, PiecesOfOneWallBecomeOne) {
  auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera());
  epcc::test::addNoise(room, kWhite, 3);
  const auto image = imageOf(room);
  auto map = regionsOf(image, strips(room.camera, 20), 8);
  merge(image, kWhite, map);
  EXPECT_EQ(map.regions[0].n, 160.0 * 120.0);
  for (const auto label : map.labels) ASSERT_EQ(label, 1);
}

/// Whether a strip of so many columns becomes one with the wall beside it, from which it is 2.4 sigma off.
bool joinsTheWall(int strip, const SensorModel& sensor) {
  auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(640, 480));
  std::vector<std::int32_t> labels;
  for (std::size_t i = 0; i < room.depth.size(); ++i) {
    const bool in_strip = static_cast<int>(i % 640) < strip;
    room.depth[i] = in_strip ? 2.0f + 2.4f * static_cast<float>(sensor.sigmaZ(2.0)) : 2.0f;
    labels.push_back(in_strip ? 1 : 2);
  }
  const auto image = imageOf(room, sensor);
  auto map = regionsOf(image, labels, 2);
  merge(image, sensor, map);
  return map.regions[1].n == 0.0;
}

TEST(RegionMerging, DeepRegionsMayLieFartherApartForSensorsBend) {
  EXPECT_TRUE(joinsTheWall(100, SensorModel::axial(0.002, 0.0, 2.0)));
  EXPECT_FALSE(joinsTheWall(12, SensorModel::axial(0.002, 0.0, 2.0)));   // a step in stairs
  EXPECT_FALSE(joinsTheWall(100, SensorModel::axial(0.002, 0.0, 1.0)));  // grain does not bend
}

TEST(RegionMerging, AWallOfThousandsOfSpecksBecomesOne) {
  auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(640, 480));
  epcc::test::addNoise(room, kWhite, 3);
  const SensorModel blotchy = SensorModel::axial(0.002, 0.0, 4.0);  // wide tolerance for fragments
  const auto image = imageOf(room, blotchy);
  std::vector<std::int32_t> labels;
  for (int row = 0; row < 480; ++row)
    for (int column = 0; column < 640; ++column) labels.push_back(1 + row / 4 * 160 + column / 4);
  auto map = regionsOf(image, labels, 19200);
  merge(image, blotchy, map);
  EXPECT_EQ(map.regions[0].n, 640.0 * 480.0);
}

TEST(RegionMerging, TheFacesOfARoomStayApart) {
  auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera());
  epcc::test::addNoise(room, kWhite, 3);
  const auto image = imageOf(room);
  auto map = regionsOf(image, room.labels, 3);
  merge(image, kWhite, map);
  EXPECT_EQ(map.labels, room.labels);
}

TEST(RegionMerging, ASmallStepBoxOnAWallIsKeptByItsBorder) {
  const SensorModel blotchy = SensorModel::axial(0.002, 0.0, 4.0);  // wide tolerance for fragments
  const auto camera = epcc::test::testCamera();
  for (const double step : {0.0, 0.03}) {
    epcc::test::RenderedRoom room{camera, {}, {}};
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column) {
        const bool box = row >= 40 && row < 60 && column >= 60 && column < 90;
        room.depth.push_back(static_cast<float>(box ? 1.0 - step : 1.0));
        room.labels.push_back(box ? 2 : 1);
      }
    const auto image = imageOf(room, blotchy);
    auto map = regionsOf(image, room.labels, 2);
    merge(image, blotchy, map);
    EXPECT_EQ(map.regions[1].n > 0.0, step > 0.0) << step;
  }
}

TEST(RegionMerging, AGrooveKeepsCoplanarSurfacesApartAHoleOrARidgeDoesNot) {
  const auto camera = epcc::test::testCamera();
  for (const float between : {1.1f, 0.9f, 0.0f}) {
    epcc::test::RenderedRoom room{camera, {}, {}};
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column) {
        const bool strip = column >= 78 && column < 82;
        room.depth.push_back(strip ? between : 1.0f);
        room.labels.push_back(strip ? 0 : column < 78 ? 1 : 2);
      }
    const auto image = imageOf(room);
    auto map = regionsOf(image, room.labels, 2);
    merge(image, kWhite, map);
    EXPECT_EQ(map.regions[1].n > 0.0, between > 1.0f) << between;
  }
}

TEST(RegionMerging, RegionsBelowTheSampleLimitAreDropped) {
  const auto room = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera());
  const SensorModel blotchy = SensorModel::axial(0.002, 0.0, 4.0);
  const auto image = imageOf(room, blotchy);
  std::vector<std::int32_t> labels(room.labels.size(), 0);
  for (int i = 0; i < 100; ++i) labels[static_cast<std::size_t>(i)] = 1;
  auto map = regionsOf(image, labels, 1);  // 100 pixels: one independent sample
  merge(image, blotchy, map);
  EXPECT_EQ(map.labels, std::vector<std::int32_t>(room.labels.size(), 0));
  EXPECT_EQ(map.regions[0].n, 0.0);
}

// ---- S7 ----

PlaneMoments flatRegion(int pixels, double residual_sigma) {
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  std::normal_distribution<double> normal(0.0, residual_sigma * 0.01);
  PlaneMoments moments;
  for (int i = 0; i < pixels; ++i) {
    const Eigen::Vector3d ray(uniform(generator), uniform(generator), 1.0);
    moments.add(ray, 0.5 + normal(generator), 1e-4);
  }
  return moments;
}

TEST(Evidence, SizeRoughnessAndIndependentSamplesDecide) {
  const epcc::InverseDepthParameters parameters;
  const SensorModel blotchy = SensorModel::axial(0.002, 0.0, 4.0);  // 100 pixels a sample
  EXPECT_TRUE(epcc::isPlane(flatRegion(100, 0.5), parameters, kWhite));
  EXPECT_FALSE(epcc::isPlane(flatRegion(59, 0.5), parameters, kWhite));
  EXPECT_FALSE(epcc::isPlane(flatRegion(2000, 2.2), parameters, kWhite));  // chi^2 4.8
  epcc::PlaneMoments without;                                              // 1e-110 m away: no plane can be computed
  for (int i = 0; i < 100; ++i) without.add({0.01 * i, 0.2, 1.0}, 1e110, 1e-220);
  ASSERT_TRUE(std::isnan(epcc::RegionPlane(without).rss));
  EXPECT_FALSE(epcc::isPlane(without, parameters, kWhite));
  EXPECT_TRUE(epcc::isPlane(flatRegion(700, 0.5), parameters, blotchy));
  EXPECT_FALSE(epcc::isPlane(flatRegion(500, 0.5), parameters, blotchy));   // 5 samples
  EXPECT_FALSE(epcc::isPlane(flatRegion(1000, 1.3), parameters, blotchy));  // 10 samples, chi^2 1.7
  EXPECT_TRUE(epcc::isPlane(flatRegion(1800, 0.9), parameters, blotchy));   // 18 samples, chi^2 0.8
  EXPECT_FALSE(epcc::isPlane(flatRegion(1800, 1.1), parameters, blotchy));  // 18 samples, chi^2 1.2
  EXPECT_TRUE(epcc::isPlane(flatRegion(2200, 1.1), parameters, blotchy));
  EXPECT_TRUE(epcc::isPlane(flatRegion(3000, 1.3), parameters, blotchy));
}

// ---- bending ----

/// A sphere, or an upright cylinder, 1.5 m from the camera, seen at `column`, `row`; label 1 on a disk of 20 pixels.
RenderedRoom roundThing(double radius, bool sphere, double column, double row) {
  const auto camera = epcc::test::testCamera(320, 240);
  RenderedRoom room{camera, {}, {}};
  const Eigen::Vector3d middle =
      1.5 * Eigen::Vector3d((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy, 1.0);
  const Eigen::Vector3d mask = sphere ? Eigen::Vector3d(1, 1, 1) : Eigen::Vector3d(1, 0, 1);
  const Eigen::Vector3d centre = middle + radius * middle.cwiseProduct(mask).normalized();
  for (int r = 0; r < camera.height; ++r)
    for (int c = 0; c < camera.width; ++c) {
      const Eigen::Vector3d ray((c - camera.cx) / camera.fx, (r - camera.cy) / camera.fy, 1.0);
      const Eigen::Vector3d across = ray.cwiseProduct(mask), to_centre = centre.cwiseProduct(mask);
      const double b = across.dot(to_centre), a = across.squaredNorm();
      const double discriminant = b * b - a * (to_centre.squaredNorm() - radius * radius);
      room.depth.push_back(discriminant > 0.0 ? static_cast<float>((b - std::sqrt(discriminant)) / a) : 0.0f);
      room.labels.push_back(std::hypot(c - column, r - row) < 20.0 ? 1 : 0);
    }
  return room;
}

std::vector<epcc::Bending> bendingOf(const InverseDepthImage& image, const RegionMap& map,
                                     const std::vector<std::uint8_t>& wanted) {
  epcc::BendingMemory memory;
  epcc::measureBending(image, map, wanted, memory);
  return memory.bending;
}

TEST(SurfaceBending, MeasuresTheRadiusOfRoundThingsAnywhereInTheImage) {
  for (const bool sphere : {true, false})
    for (const double column : {160.0, 40.0, 290.0})
      for (const double row : {120.0, 30.0}) {
        const auto room = roundThing(0.5, sphere, column, row);
        const auto image = imageOf(room);
        const auto map = regionsOf(image, room.labels, 1);
        const auto bending = bendingOf(image, map, {1}).front();
        EXPECT_NEAR(bending.curvature, 2.0, 0.2) << sphere << " " << column << " " << row;
        EXPECT_GT(bending.gain, 0.95 * bending.rss);
        EXPECT_LE(bending.gain, bending.rss);
      }
}

TEST(SurfaceBending, IsMeasuredOnScansToo) {
  const auto room = roundThing(0.5, true, 200.0, 100.0);
  auto image = imageOf(room);
  const auto map = regionsOf(image, room.labels, 1);
  const auto planar = bendingOf(image, map, {1}).front();
  image.planar_rows = false;  // the same rays, taken one by one in a turned view
  const auto turned = bendingOf(image, map, {1}).front();
  EXPECT_NEAR(turned.curvature, planar.curvature, 0.1);
  EXPECT_NEAR(turned.rss, planar.rss, 1e-9 * planar.rss);
}

TEST(SurfaceBending, IsZeroOnASlantedPlaneAndForRegionsNotAskedFor) {
  const auto room = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(320, 240));
  const auto image = imageOf(room);
  const auto map = regionsOf(image, room.labels, 3);
  const auto bending = bendingOf(image, map, {1, 0, 1});
  for (const auto& b : bending) EXPECT_LT(b.gain, 1.0);  // float rounding, in sigma^2
  EXPECT_EQ(bending[1].rss, 0.0);
  EXPECT_LT(bending[0].curvature, 1e-2);
  EXPECT_LT(bending[2].curvature, 1e-2);
}

/// The others would be planes by their size and roughness: only their bending can tell.
TEST(Evidence, BendingIsAskedForItsRadiusItsShareAndItsWorth) {
  const auto isKept = [](double radius, double sigma, double noise) {
    const SensorModel sensor = SensorModel::axial(sigma, 0.0, 1.0);
    RenderedRoom room = roundThing(radius, true, 160.0, 120.0);
    if (noise > 0.0) epcc::test::addNoise(room, SensorModel::axial(noise, 0.0, 1.0), 7);
    const auto image = imageOf(room, sensor);
    auto map = regionsOf(image, room.labels, 1);
    EXPECT_TRUE(epcc::isPlane(map.regions[0], epcc::InverseDepthParameters(), sensor)) << radius << " " << sigma;
    epcc::EvidenceMemory memory;
    epcc::rejectRegions(image, epcc::InverseDepthParameters(), sensor, map, memory);
    return map.regions[0].n > 0.0;
  };
  EXPECT_FALSE(isKept(0.3, 0.01, 0.0));
  EXPECT_TRUE(isKept(0.5, 0.01, 0.0)) << "the radius is larger than min_radius";
  EXPECT_TRUE(isKept(0.3, 0.01, 0.015)) << "most of the residuals are no bending";
  EXPECT_TRUE(isKept(0.3, 0.5, 0.0)) << "next to the error of the sensor it is nothing";
}

TEST(Evidence, FacetsOfRoundThingsAreNoPlanesBoxesAndSlowBendsAre) {
  const SensorModel sensor = SensorModel::axial(0.002, 0.0, 1.0);
  const auto isKept = [&](RenderedRoom room) {
    epcc::test::addNoise(room, sensor, 7);
    const auto image = imageOf(room, sensor);
    auto map = regionsOf(image, room.labels, 1);
    epcc::EvidenceMemory memory;
    epcc::rejectRegions(image, epcc::InverseDepthParameters(), sensor, map, memory);
    return map.regions[0].n > 0.0;
  };
  EXPECT_FALSE(isKept(roundThing(0.3, true, 100.0, 100.0)));
  EXPECT_FALSE(isKept(roundThing(0.3, false, 100.0, 100.0)));
  EXPECT_TRUE(isKept(roundThing(3.0, true, 100.0, 100.0)));
  auto wall = epcc::test::renderRoom({epcc::test::cornerPlanes()[1]}, epcc::test::testCamera(320, 240));
  for (std::size_t i = 0; i < wall.labels.size(); ++i) wall.labels[i] = i % 320 < 40 && i / 320 < 40 ? 1 : 0;
  EXPECT_TRUE(isKept(wall));
}

// ---- S8 ----

/// A wall at 2 m, label 1 left and 2 right of columns [60, 60 + width), which are at `depth`, unlabelled.
RenderedRoom wallBehindAPole(int width, float depth, float right_wall = 2.0f) {
  const auto camera = epcc::test::testCamera();
  RenderedRoom room{camera, {}, {}};
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const bool left = column < 60, pole = !left && column < 60 + width;
      room.depth.push_back(left ? 2.0f : pole ? depth : right_wall);
      room.labels.push_back(left ? 1 : pole ? 0 : 2);
    }
  return room;
}

int occludedContacts(const RenderedRoom& room) {
  const auto image = imageOf(room);
  const auto map = regionsOf(image, room.labels, 2);
  epcc::OcclusionMemory memory;
  epcc::RegionContacts contacts;
  epcc::findOccludedContacts(image, 5, 0.5, 3.0, map, memory, contacts);
  const epcc::Contact* found = contacts.find(RegionPair(2, 1));
  return found == nullptr ? 0 : found->count;
}

TEST(OccludedContacts, AreFoundBehindWhatIsNearerOnly) {
  EXPECT_EQ(occludedContacts(wallBehindAPole(20, 1.0f)), 60);       // every other row
  EXPECT_EQ(occludedContacts(wallBehindAPole(20, 3.0f)), 0);        // one looks through between two walls
  EXPECT_EQ(occludedContacts(wallBehindAPole(20, 0.0f)), 0);        // nothing is known
  EXPECT_EQ(occludedContacts(wallBehindAPole(20, 1.0f, 2.5f)), 0);  // another wall farther back
  EXPECT_EQ(occludedContacts(wallBehindAPole(20, 1.0f, 1.5f)), 0);  // and nearer
  EXPECT_EQ(occludedContacts(wallBehindAPole(52, 1.0f)), 60);       // 52 of 60 + 48 columns: just less than half
  EXPECT_EQ(occludedContacts(wallBehindAPole(56, 1.0f)), 0);
  EXPECT_EQ(occludedContacts(wallBehindAPole(20, 2.0f)), 0);  // unlabelled, but nothing in front
}

TEST(OccludedContacts, AreTheSameWhicheverSideIsLonger) {
  auto room = wallBehindAPole(20, 1.0f);  // 60 columns on the left, 80 on the right
  EXPECT_EQ(occludedContacts(room), 60);
  for (int row = 0; row < 120; ++row) {
    const auto start = static_cast<std::size_t>(row) * 160;
    std::reverse(room.depth.begin() + start, room.depth.begin() + start + 160);
    std::reverse(room.labels.begin() + start, room.labels.begin() + start + 160);
  }
  EXPECT_EQ(occludedContacts(room), 60);
}

TEST(OccludedContacts, TwoPartsOfAWallBecomeOne) {
  auto room = wallBehindAPole(20, 1.0f);
  epcc::test::addNoise(room, kWhite, 8);
  const auto image = imageOf(room);
  auto map = regionsOf(image, room.labels, 2);
  epcc::OcclusionMemory memory;
  epcc::RegionContacts contacts;
  epcc::findOccludedContacts(image, 5, 0.5, 3.0, map, memory, contacts);
  epcc::RegionMerger().merge(contacts, epcc::InverseDepthParameters(), kWhite, map);
  EXPECT_EQ(map.regions[0].n, 140.0 * 120.0);
  EXPECT_EQ(map.regions[1].n, 0.0);
}

}  // namespace
