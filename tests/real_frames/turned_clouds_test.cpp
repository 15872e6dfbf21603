// SPDX-License-Identifier: BSD-3-Clause
// Real frames made into clouds of other frames and units keep their surfaces.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "datasets/sources/native_folder.h"
#include "datasets/sources/reading_options.h"
#include "tests/real_frames/scored_frames.h"
#include "tests/support/real_frames.h"

namespace epcc {
namespace {

struct Change {
  const char* name;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double unit = 1.0;
  float invalid = NAN;
};

std::vector<Change> changes() {
  Change turned{"turned by 25 degrees and shifted by 1.2 m"}, millimetres{"in millimetres"}, marked{"-1 is no point"},
      body{"x forward"};
  turned.axes = Eigen::AngleAxisd(25.0 * M_PI / 180.0, Eigen::Vector3d(0.3, 1.0, -0.2).normalized()).toRotationMatrix();
  turned.origin = Eigen::Vector3d(0.9, -0.5, 0.62);
  millimetres.unit = 1000.0;
  marked.invalid = -1.0f;
  body.axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {turned, millimetres, marked, body};
}

LabelledFrame asCloud(const LabelledFrame& frame, const Change& change) {
  LabelledFrame cloud = frame;
  const DepthFrame view = frameView(frame);
  cloud.scan.assign(3 * frame.depth.data.size(), change.invalid);
  Eigen::Vector3d p;
  for (int row = 0; row < view.height(); ++row)
    for (int column = 0; column < view.width(); ++column) {
      if (!view.point(row, column, p)) continue;
      const Eigen::Vector3d q = change.unit * (change.axes * p + change.origin);
      for (int k = 0; k < 3; ++k)
        cloud.scan[3 * view.index(row, column) + static_cast<std::size_t>(k)] = static_cast<float>(q(k));
    }
  cloud.geometry = findGeometry(cloud.scan.data(), 3, cloud.depth.width, cloud.depth.height);
  return cloud;
}

TEST(TurnedClouds, KeepTheirSurfaces) {
  EPCC_NEED_REAL_FRAMES("realsense");
  EPCC_NEED_REAL_FRAMES("kinect");
  const std::vector<Change> all = changes();
  long plain = 0;
  std::vector<long> correct(all.size(), 0);
  for (const char* set : {"realsense", "kinect"}) {
    const NativeFolder folder(test::realFolder(set));
    for (std::size_t i = 0; i < folder.size(); ++i) {
      const LabelledFrame frame = folder.read(i);
      plain += test::scoreFrame(asCloud(frame, Change{"plain"}), Parameters()).segcomp.correct;
      for (std::size_t k = 0; k < all.size(); ++k) {
        const test::FrameScore score = test::scoreFrame(asCloud(frame, all[k]), Parameters());
        EXPECT_EQ(score.problem, "") << frame.name << ", " << all[k].name;
        correct[k] += score.segcomp.correct;
      }
    }
  }
  EXPECT_GT(plain, 0);
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_GE(100 * correct[k], 97 * plain) << all[k].name;
}

}  // namespace
}  // namespace epcc
