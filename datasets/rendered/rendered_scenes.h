// SPDX-License-Identifier: BSD-3-Clause
// Rendered surrogate scenes and single walls as sources of frames for experiments.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>

#include "datasets/noise/sensor_noise.h"
#include "datasets/sources/frame_source.h"

namespace epcc {

/// Frames made by a function, one a seed. A frame is made when it is first read and kept, so that several methods
/// may come for it one after the other.
class RenderedFrames : public FrameSource {
 public:
  using Make = std::function<LabelledFrame(std::uint64_t seed)>;
  RenderedFrames(const std::string& dataset, std::uint64_t first_seed, std::size_t count, const Make& make);
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return slots_.size(); }
  std::string name(std::size_t index) const override;
  LabelledFrame read(std::size_t index) const override;

 private:
  struct Slot {
    std::once_flag once;
    LabelledFrame frame;
  };
  std::string dataset_;
  std::uint64_t first_seed_;
  Make make_;
  mutable std::deque<Slot> slots_;
};

/// Scene "a" to "d" with noise; throws std::invalid_argument for another name.
RenderedFrames::Make sceneWithNoise(const std::string& scene, const NoiseOptions& noise);

/// One wall that fills the view of the scene camera, `distance` metres away on the optical axis, turned by `degrees`
/// about the camera's vertical axis, with noise.
RenderedFrames::Make wallWithNoise(double distance, double degrees, const NoiseOptions& noise);

}  // namespace epcc
