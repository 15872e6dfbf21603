// SPDX-License-Identifier: BSD-3-Clause
// The frames whose instructions scripts/check_speed.sh counts. Rendering is a run of its own, for under valgrind it
// would take longer than all the rest.
//   instruction_count render FOLDER
//   instruction_count default|paper|auto FOLDER
//   instruction_count versions
#include <Eigen/Core>
#include <exception>
#include <iostream>
#include <string>

#include "datasets/files/labelled_frame.h"
#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/vector_unit.h"

#if __has_include(<hwy/highway.h>)
#include <hwy/highway.h>
#endif
#if __has_include(<gnu/libc-version.h>)
#include <gnu/libc-version.h>
#endif

// The function in which valgrind counts; not inlined, and its name is not mangled.
extern "C" __attribute__((noinline)) bool epccCountedFrame(epcc::PlaneExtractor& extractor,
                                                           const epcc::DepthFrame& frame,
                                                           epcc::PlaneSegmentation& result) {
  return extractor.extract(frame, result);
}

namespace epcc {
namespace {

const char kName[] = "b_640x480";

void render(const std::string& folder) {
  SceneOptions options;
  options.camera = sceneCamera(640, 480);
  LabelledFrame frame = renderScene("b", 1, options);
  const NoiseOptions noise = parseNoise("stereo").value();
  applyNoise(frame, noise, 1);
  frame.name = kName;
  frame.camera.noise = noise.preset;
  writeLabelledFrame(folder, frame);
}

/// The first frame allocates, the second is counted; with a sensor that is measured on it, too, for "auto".
bool segmentTwice(const std::string& which, const std::string& folder) {
  const LabelledFrame data = readLabelledFrame(folder, kName);
  const DepthFrame frame = frameView(data);
  PlaneExtractor extractor(which == "paper" ? Parameters::forPaper() : Parameters());
  if (which != "auto") extractor.setSensor(SensorModel::parse(data.camera.noise.value()).value());
  PlaneSegmentation result;
  if (!extractor.extract(frame, result)) return false;
  if (which == "auto") extractor.setSensorAuto();
  const bool done = epccCountedFrame(extractor, frame, result);
  std::cout << which << " on " << vectorUnit() << ": " << result.planes.size() << " planes " << extractor.error()
            << '\n';
  return done && !result.planes.empty();
}

void printVersions() {
#ifdef __clang__
  std::cout << "Clang " << __clang_version__;
#else
  std::cout << "GCC " << __VERSION__;
#endif
  std::cout << ", Eigen " << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION;
#ifdef HWY_MAJOR
  std::cout << ", Highway " << HWY_MAJOR << '.' << HWY_MINOR << '.' << HWY_PATCH;
#endif
#ifdef __GLIBC__
  std::cout << ", glibc " << gnu_get_libc_version();
#endif
  std::cout << '\n';
}

int run(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "versions" && argc == 2) {
    printVersions();
    return 0;
  }
  if (argc != 3 || (what != "render" && what != "default" && what != "paper" && what != "auto")) {
    std::cerr << "instruction_count render|default|paper|auto FOLDER, or versions\n";
    return 2;
  }
  if (what != "render") return segmentTwice(what, argv[2]) ? 0 : 1;
  render(argv[2]);
  return 0;
}

}  // namespace
}  // namespace epcc

int main(int argc, char** argv) try { return epcc::run(argc, argv); } catch (const std::exception& error) {
  std::cerr << "instruction_count: " << error.what() << '\n';
  return 3;
}
