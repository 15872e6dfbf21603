// SPDX-License-Identifier: BSD-3-Clause
// A day of frames in one process: 2.6 million of 160x120 are 30 a second for 24 hours. Fails if memory grows, or if the
// frame that came first has another result in the end.
//   epcc_load [FRAMES]    (2600000)
#include <malloc.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "datasets/noise/sensor_noise.h"
#include "datasets/rendered/scene_sequence.h"
#include "epcc_segmentation/plane_extractor.h"

namespace epcc {
namespace {

constexpr int kWidth = 160, kHeight = 120;
constexpr std::size_t kViews = 25;  // of each scene
constexpr long kMaxGrowth = 1 << 20;

/// Views along a path through every scene, with the error of a stereo camera. Each is handed out again and again, never
/// twice with the same depths.
class EndlessFrames {
 public:
  EndlessFrames() {
    for (const char* scene : {"a", "b", "c", "d"}) {
      SequenceRecipe recipe;
      recipe.scene = scene;
      recipe.path = "sway";
      recipe.frames = kViews;
      recipe.options.camera = sceneCamera(kWidth, kHeight);
      recipe.noise = parseNoise("stereo").value();
      const SceneSequence sequence(recipe);
      for (std::size_t i = 0; i < kViews; ++i) views_.push_back(sequence.frame(i));
    }
    depth_ = views_[0].depth.data;
  }

  /// Frame `number`, the same each time; good until the next call.
  DepthFrame frame(std::uint64_t number) {
    const LabelledFrame& view = views_[number % views_.size()];
    std::uint64_t state = 0x9e3779b97f4a7c15u * (number + 1);
    for (std::size_t i = 0; i < depth_.size(); ++i) {
      state ^= state << 13;
      state ^= state >> 7;
      state ^= state << 17;
      // Evenly within 2 thousandths, and a hole where the upper bits are zero.
      const float share = static_cast<float>(state >> 40) * (1.0f / (1 << 24)) - 0.5f;
      depth_[i] = (state >> 55) == 0 ? 0.0f : view.depth.data[i] * (1.0f + 0.004f * share);
    }
    return DepthFrame::fromDepth(depth_.data(), view.camera.camera);
  }

 private:
  std::vector<LabelledFrame> views_;
  std::vector<float> depth_;
};

struct Memory {
  long resident = 0;  ///< bytes, of the process
  long in_use = 0;    ///< bytes that were allocated and not freed
};

Memory memory() {
  std::ifstream statm("/proc/self/statm");
  long all = 0, resident = 0;
  statm >> all >> resident;
  const struct mallinfo2 heap = mallinfo2();
  return {resident * ::sysconf(_SC_PAGESIZE), static_cast<long>(heap.uordblks + heap.hblkhd)};
}

std::vector<std::int32_t> labelsOf(EndlessFrames& frames, std::uint64_t number) {
  PlaneExtractor extractor;
  extractor.setSensorAuto();
  PlaneSegmentation result;
  if (!extractor.extract(frames.frame(number), result)) throw std::runtime_error(extractor.error());
  return result.labels;
}

void print(long frames, double seconds, const Memory& now, double planes) {
  std::printf("| %ld | %.0f | %.3f | %.2f | %.2f | %.1f |\n", frames, seconds,
              1e3 * seconds / static_cast<double>(frames), static_cast<double>(now.resident) / (1 << 20),
              static_cast<double>(now.in_use) / (1 << 20), planes / static_cast<double>(frames));
  std::fflush(stdout);
}

bool run(long count) {
  EndlessFrames frames;
  const std::vector<std::int32_t> first = labelsOf(frames, 0);
  PlaneExtractor extractor;
  extractor.setSensorAuto();
  PlaneSegmentation result;
  std::puts("| frames | s | ms a frame | resident MB | in use MB | planes a frame |\n|---:|---:|---:|---:|---:|---:|");
  // Every view several times: from then on nothing may be added.
  const long warm = std::max(count / 200, static_cast<long>(20 * 4 * kViews));
  Memory at_first;
  double planes = 0.0;
  const auto start = std::chrono::steady_clock::now();
  for (long i = 1; i <= count; ++i) {
    if (!extractor.extract(frames.frame(static_cast<std::uint64_t>(i)), result))
      throw std::runtime_error("frame " + std::to_string(i) + ": " + extractor.error());
    planes += static_cast<double>(result.planes.size());
    if (i != warm && i % std::max(1L, count / 20) != 0) continue;
    if (i == warm) at_first = memory();
    print(i, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), memory(), planes);
  }
  const Memory at_last = memory();
  if (at_last.resident > at_first.resident + kMaxGrowth || at_last.in_use > at_first.in_use + kMaxGrowth) {
    std::cerr << "epcc_load: memory grows\n";
    return false;
  }
  if (labelsOf(frames, 0) != first) {
    std::cerr << "epcc_load: the first frame has another result in the end\n";
    return false;
  }
  return true;
}

}  // namespace
}  // namespace epcc

int main(int argc, char** argv) try {
  constexpr long kFrames = 2600000, kLeast = 10000, kMost = 1000000000;
  long count = kFrames;
  if (argc > 1) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    const auto parsed = std::from_chars(argv[1], end, count);
    if (argc > 2 || parsed.ec != std::errc() || parsed.ptr != end || count < kLeast || count > kMost) {
      std::cerr << "epcc_load [FRAMES], from " << kLeast << " to " << kMost << '\n';
      return 2;
    }
  }
  return epcc::run(count) ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "epcc_load: " << error.what() << '\n';
  return 3;
}
