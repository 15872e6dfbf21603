// SPDX-License-Identifier: BSD-3-Clause
// Every fuzzing target takes its seeds, and survives damaged ones, without a fuzzer. EPCC_FUZZ_ITERATIONS sets how
// many.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>

#include "tests/datasets/files/mutator.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

struct NamedTarget {
  const char* name;
  const FuzzTarget* target;
  long iterations;  // of each seed
};
void PrintTo(const NamedTarget& target, std::ostream* out) {
  *out << target.name;
}

class FuzzTargets : public ::testing::TestWithParam<NamedTarget> {
 protected:
  static bool run(const std::string& bytes) {
    return GetParam().target->run(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
};

TEST_P(FuzzTargets, TakesItsSeeds) {
  int number = 0;
  for (const std::string& seed : GetParam().target->seeds()) EXPECT_TRUE(run(seed)) << "seed " << number++;
}

TEST_P(FuzzTargets, SurvivesDamagedSeeds) {
  const char* const given = std::getenv("EPCC_FUZZ_ITERATIONS");
  const long iterations = given == nullptr ? GetParam().iterations : std::atol(given);
  std::uint64_t number = 0;
  long taken = 0;
  for (const std::string& seed : GetParam().target->seeds())
    for (long i = 0; i < iterations; ++i) {
      test::Mutator mutate(++number);
      if (run(mutate(seed))) ++taken;
    }
  EXPECT_GT(taken, 0);
}

const auto nameOf = [](const auto& one) { return one.param.name; };

INSTANTIATE_TEST_SUITE_P(
    Readers, FuzzTargets,
    ::testing::Values(NamedTarget{"CameraJson", &kCameraJson, 300}, NamedTarget{"CarmenLog", &kCarmenLog, 300},
                      NamedTarget{"DepthPng", &kDepthPng, 300}, NamedTarget{"LabelPng", &kLabelPng, 300},
                      NamedTarget{"Npy", &kNpy, 300}, NamedTarget{"Parameters", &kParameters, 100},
                      NamedTarget{"Pcd", &kPcd, 300}, NamedTarget{"ScanTable", &kScanTable, 300},
                      NamedTarget{"Segcomp", &kSegcomp, 300}, NamedTarget{"Trajectory", &kTrajectory, 300}),
    nameOf);
INSTANTIATE_TEST_SUITE_P(Library, FuzzTargets,
                         ::testing::Values(NamedTarget{"CloudGeometry", &kCloudGeometry, 20},
                                           NamedTarget{"LaserLines", &kLaserLines, 200},
                                           NamedTarget{"Segment", &kSegment, 20}, NamedTarget{"Stream", &kStream, 40},
                                           NamedTarget{"Tracker", &kTracker, 20}),
                         nameOf);
#ifdef EPCC_WITH_GEOS
INSTANTIATE_TEST_SUITE_P(Geometry, FuzzTargets, ::testing::Values(NamedTarget{"Surfaces", &kSurfaces, 20}), nameOf);
#endif

}  // namespace
}  // namespace epcc::fuzz
