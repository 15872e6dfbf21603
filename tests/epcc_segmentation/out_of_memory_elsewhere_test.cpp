// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out at any moment of a call of the tracker, of a search for a cloud's geometry, of the lines of a
// laser scan: a status and words, and the next call is fine.
#include <gtest/gtest.h>

#include <functional>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/laser_line_extractor.h"
#include "epcc_segmentation/plane_tracker.h"
#include "tests/epcc_segmentation/laser/laser_scans.h"
#include "tests/support/failing_allocations.h"
#include "tests/support/posed_clouds.h"
#include "tests/support/rendered_room.h"

namespace {

using epcc::Status;
using epcc::test::FailingAllocations;

const epcc::SensorModel kSmallError = epcc::SensorModel::axial(0.001, 0.001);

epcc::test::RenderedRoom cornerOfARoom() {
  return epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(48, 36));
}

/// Calls `attempt` with one allocation more each time until none is refused. It returns whether it was done; `refused`
/// looks at what a refused one left. How many there were.
int untilItIsDone(const std::function<bool()>& attempt, const std::function<void()>& refused) {
  int failures = 0;
  for (long allowed = 0;; ++allowed) {
    bool done = false, ran_out = false;
    {
      const FailingAllocations memory(allowed);
      EXPECT_NO_THROW(done = attempt());
      ran_out = memory.happened();
    }
    if (done && !ran_out) return failures;
    if (testing::Test::HasFailure()) return failures;
    if (done) continue;  // it could do without
    EXPECT_TRUE(ran_out);
    ++failures;
    refused();
  }
}

TEST(OutOfMemoryInTheTracker, IsAStatusAndWhatComesNextIsTracked) {
  const auto room = cornerOfARoom();
  epcc::TrackerParameters at_once;
  at_once.confirm_frames = 1;
  const auto tracker = [&] { return epcc::PlaneTracker(at_once, epcc::Parameters(), kSmallError); };
  std::optional<epcc::PlaneTracker> fresh;
  int begun_anew = 0;
  epcc::TrackedFrame result;
  const auto prepare = [&] {
    fresh.emplace(tracker());
    ASSERT_TRUE(fresh->track(room.frame(), std::nullopt, 0.0, result));
    ASSERT_EQ(fresh->tracks().size(), 3U);
  };
  prepare();
  const int failures = untilItIsDone([&] { return fresh->track(room.frame(), std::nullopt, 0.1, result); },
                                     [&] {
                                       ASSERT_EQ(fresh->status(), Status::OutOfMemory);
                                       ASSERT_EQ(fresh->error(), "out of memory");
                                       const std::size_t kept = fresh->tracks().size();
                                       ASSERT_TRUE(kept == 3U || kept == 0U) << kept;
                                       begun_anew += kept == 0U ? 1 : 0;
                                       ASSERT_TRUE(fresh->track(room.frame(), std::nullopt, 0.2, result));
                                       EXPECT_EQ(fresh->status(), Status::Ok);
                                       EXPECT_EQ(fresh->tracks().size(), 3U);
                                       prepare();
                                     });
  EXPECT_GT(failures, 20);
  EXPECT_GT(begun_anew, 0);
  EXPECT_LT(begun_anew, failures) << "in the segmentation nothing is lost";
}

TEST(OutOfMemoryInTheSearchForAGeometry, IsAStatusAndTheNextCloudIsFound) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.6, 0.0, 0.8)).toRotationMatrix();
  for (const auto& plain : {epcc::test::cameraCloud(cornerOfARoom()), epcc::test::scannerCloud(120, 12)}) {
    const auto cloud = moved(plain, turn, Eigen::Vector3d(1.0, -2.0, 0.5));
    const auto find = [&](epcc::GeometryFinder& finder) -> const epcc::CloudGeometry& {
      return finder.find(cloud.xyz.data(), 3, cloud.width, cloud.height);
    };
    epcc::GeometryFinder first;
    const epcc::CloudGeometry expected = find(first);
    ASSERT_EQ(expected.status, Status::Ok) << expected.problem;
    epcc::GeometryFinder finder;
    const int failures = untilItIsDone([&] { return find(finder).status == Status::Ok; },
                                       [&] {
                                         const epcc::CloudGeometry again = find(finder);
                                         ASSERT_EQ(again.status, Status::Ok);
                                         ASSERT_EQ(again.pose.axes, expected.pose.axes);
                                         finder = epcc::GeometryFinder();
                                       });
    EXPECT_GT(failures, 10);
    bool is_status = false;
    {
      const FailingAllocations memory(failures / 2);
      is_status = epcc::findGeometry(cloud.xyz.data(), 3, cloud.width, cloud.height).status == Status::OutOfMemory;
    }
    EXPECT_TRUE(is_status);
  }
}

TEST(OutOfMemoryInALaserScan, IsAStatusWithoutLines) {
  const auto scan = epcc::test::scanOf(epcc::test::room(-3.0, 4.0, -2.0, 3.0), 180, -M_PI, 2.0 * M_PI / 180, 0.005);
  epcc::LaserLineExtractor extractor(epcc::SensorModel::axial(0.005, 0.0));
  epcc::LaserLines lines;
  const int failures = untilItIsDone([&] { return extractor.extract(scan, lines); },
                                     [&] {
                                       ASSERT_EQ(extractor.status(), Status::OutOfMemory);
                                       ASSERT_EQ(extractor.error(), "out of memory");
                                       ASSERT_TRUE(lines.lines.empty() && lines.labels.empty());
                                       lines = epcc::LaserLines();
                                     });
  EXPECT_GT(failures, 10);
  EXPECT_EQ(lines.lines.size(), 4U);
}

}  // namespace
