// SPDX-License-Identifier: BSD-3-Clause
// How clouds of any frame, unit and order were measured, and what is segmented in them.
#include <cmath>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/fuzz/fuzz_frame.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/segmentation_check.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

void checkGeometry(const CloudGeometry& geometry) {
  require(geometry.problem.empty() == (geometry.status == Status::Ok), "what is wrong is said in words");
  if (geometry.status != Status::Ok) {
    requireOneLine(geometry.problem);
    return;
  }
  const Eigen::Matrix3d axes = geometry.pose.axes;
  require(axes.allFinite() && geometry.pose.origin.allFinite(), "a pose is finite");
  require((axes * axes.transpose()).isIdentity(1e-6), "axes are orthogonal");
  require(geometry.unit > 0.0 && std::isfinite(geometry.unit), "a unit is one");
  require(geometry.residual >= 0.0, "a residual is one");
  require(geometry.min_depth >= 0.0 && geometry.max_depth > geometry.min_depth, "there are depths that count");
}

bool runCloudGeometry(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  FuzzFrame values = FuzzFrame::takeUnknownCloud(input);
  const FuzzScene scene = FuzzScene::take(input);
  values.fill(scene, Eigen::Isometry3d::Identity(), input);
  checkGeometry(values.geometry());
  const DepthFrame frame = values.view();
  PlaneExtractor extractor(Parameters(), SensorModel::axial(0.002, 0.001));
  PlaneSegmentation result;
  if (!extractor.extract(frame, result)) {
    checkFailure(extractor.status(), extractor.error(), result);
    return false;
  }
  checkSegmentation(frame, result);
  return true;
}

std::vector<std::string> cloudGeometrySeeds() {
  std::vector<std::string> seeds;
  for (char kind : {'\0', '\1'}) {
    std::string seed = {kind, '\x1f', '\0', '\x17', '\0'};                 // 32x24
    seed += {'\0', '\2', '\5', '\0'};                                      // an ordinary camera, little noise
    seed += std::string(6, '\0');                                          // as it is
    seed += {'\3', '\2', '\7', '\4', '\5', '\6'};                          // the cloud's pose
    seed += {'\2', '\0', '\x08', '\x04', '\x10', '\xf0', '\x08', '\x18'};  // two planes
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace

const FuzzTarget kCloudGeometry{runCloudGeometry, cloudGeometrySeeds};

}  // namespace epcc::fuzz
