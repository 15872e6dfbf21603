// SPDX-License-Identifier: BSD-3-Clause
// Trajectories of the TUM benchmark, packed or not; what is read can be asked for any time, and written.
#include <cmath>

#include "datasets/files/trajectory_file.h"
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/targets.h"
#include "tests/support/gzip_bytes.h"

namespace epcc::fuzz {
namespace {

void checkPose(const Eigen::Isometry3d& pose) {
  require(pose.matrix().allFinite(), "a pose is finite");
  require((pose.linear() * pose.linear().transpose()).isIdentity(1e-6), "a pose has a rotation");
}

void checkTimes(const Trajectory& trajectory, double time) {
  const auto nearest = nearestInTime(trajectory, time);
  require(nearest && *nearest < trajectory.size(), "there is a nearest pose");
  checkPose(poseBetween(trajectory, time));
  if (const auto pose = poseAt(trajectory, time)) checkPose(*pose);
}

bool runTrajectory(const std::uint8_t* data, std::size_t size) {
  return takesFile(data, size, [](const std::string& path) {
    const Trajectory trajectory = readTrajectory(path);
    require(!trajectory.empty(), "a trajectory has poses");
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
      checkPose(trajectory[i].pose);
      checkTimes(trajectory, trajectory[i].time);
      const std::string line = trajectoryLine(trajectory[i]);
      require(line.back() == '\n', "a line is written whole");
      if (i == 0) continue;
      require(trajectory[i - 1].time < trajectory[i].time, "times rise");
      checkTimes(trajectory, 0.5 * trajectory[i - 1].time + 0.5 * trajectory[i].time);
    }
  });
}

std::vector<std::string> trajectorySeeds() {
  const std::string text =
      "# ground truth trajectory\n# timestamp tx ty tz qx qy qz qw\n\n"
      "1305031098.6659 1.3563 0.6305 1.6380 0.6132 0.5962 -0.3311 -0.3986\r\n"
      "  1305031098.6758\t1.3543 0.6306 1.6360 0 0 0.7071 0.7071\n1305031099 0 0 0 1 0 0 0\n";
  return {text, test::packed(text), "-1e3 1 2 3 0 0 0 1\n+2.5 1 2 3 0 0 0 -1"};
}

}  // namespace

const FuzzTarget kTrajectory{runTrajectory, trajectorySeeds};

}  // namespace epcc::fuzz
