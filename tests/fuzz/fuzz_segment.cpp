// SPDX-License-Identifier: BSD-3-Clause
// Whole segmentations of any frame, with any parameters and sensor, in both modes; the same once more on the
// slowest vector unit, at times with other threads.
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/vector_unit.h"
#include "tests/fuzz/fuzz_frame.h"
#include "tests/fuzz/fuzz_settings.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/segmentation_check.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

void checkAgain(const DepthFrame& frame, const Parameters& parameters, const std::optional<SensorModel>& sensor,
                const PlaneSegmentation& first) {
  const std::string unit = vectorUnit();
  require(setVectorUnit(vectorUnits().back()), "every processor has the slowest unit");
  PlaneExtractor extractor(parameters, sensor);
  PlaneSegmentation again;
  require(extractor.extract(frame, again), "what was segmented once is segmented again");
  require(setVectorUnit(unit), "the unit is there still");
  checkSame(first, again);
}

bool runSegment(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  const Parameters parameters = takeParameters(input);
  const std::optional<SensorModel> sensor = takeSensor(input);
  const bool again = input.oneIn(4);
  Parameters other = parameters;
  if (input.oneIn(8)) other.threads = parameters.threads == 1 ? 2 : 1;
  FuzzFrame values = FuzzFrame::take(input);
  const FuzzScene scene = FuzzScene::take(input);
  values.fill(scene, Eigen::Isometry3d::Identity(), input);
  const DepthFrame frame = values.view();

  PlaneExtractor extractor(parameters, sensor);
  PlaneSegmentation result;
  if (!extractor.extract(frame, result)) {
    checkFailure(extractor.status(), extractor.error(), result);
    return false;
  }
  require(extractor.status() == Status::Ok && extractor.error().empty(), "a success says so");
  require(parameters.validate().empty() && !frame.empty(), "only what can be used is used");
  checkSegmentation(frame, result);
  if (again) checkAgain(frame, other, sensor, result);
  return true;
}

std::vector<std::string> segmentSeeds() {
  // paper mode?, scan, segments?, changes; sensor; again?; kind; size; ...
  std::vector<std::string> seeds;
  for (char mode : {'\0', '\2'})
    for (char kind = 0; kind < FuzzFrame::kKinds; ++kind) {
      std::string seed = {mode, mode == 0 ? '\2' : '\0', '\1', '\0'};
      seed += {'\2', '\2', '\1', '\x10'};                                        // axial, 2 mm, 0.001/m, a pixel
      seed += {'\3', '\0'};                                                      // once more
      seed += {kind, '\x1f', '\0', '\x17', '\0'};                                // 32x24
      seed += {'\0', '\2', '\5', '\0'};                                          // an ordinary camera, little noise
      seed += std::string(6, '\0');                                              // as it is
      if (kind == 5 || kind == 6) seed += {'\3', '\2', '\7', '\4', '\5', '\6'};  // the cloud's pose
      seed += {'\2', '\0', '\x08', '\x04', '\x10', '\xf0', '\x08', '\x18'};      // two planes
      seeds.push_back(seed);
    }
  return seeds;
}

}  // namespace

const FuzzTarget kSegment{runSegment, segmentSeeds};

}  // namespace epcc::fuzz
