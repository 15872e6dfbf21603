// SPDX-License-Identifier: BSD-3-Clause
// Random frames and random ways to segment them, for properties: rapidcheck draws, prints and shrinks what they are
// made of.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc::test {

enum class FrameKind { Depth, WholeNumbers, Cloud, BackwardCloud, Scanner };

enum class Scene {
  Planes,  ///< with edges, holes and noise
  Rough,   ///< hills, steps or nothing but noise
  Wild     ///< planes sprinkled with NaN, Inf, denormals, huge and negative numbers
};

/// All that a random frame is made of.
struct FrameSpec {
  FrameKind kind = FrameKind::Depth;
  Scene scene = Scene::Planes;
  int width = 1;
  int height = 1;
  unsigned seed = 0;    ///< of the planes, the noise, the holes
  int planes = 1;       ///< besides the one behind all of them
  int noise = 0;        ///< tenths of a millimetre at a metre
  int holes = 0;        ///< percent of the pixels
  bool masked = false;  ///< some pixels are not given
};
std::ostream& operator<<(std::ostream& out, const FrameSpec& spec);

/// A frame with the memory it looks at.
struct RandomFrame {
  explicit RandomFrame(const FrameSpec& spec);
  RandomFrame(const RandomFrame&) = default;

  DepthFrame frame() const;
  /// The model of the noise that was added.
  SensorModel sensor() const;
  bool isCloud() const { return spec.kind != FrameKind::Depth && spec.kind != FrameKind::WholeNumbers; }
  /// Whether the pixel is measured and given, by what the headers say.
  bool isValid(std::size_t pixel) const;

  FrameSpec spec;
  PinholeCamera camera;
  std::vector<float> depth;          ///< of Depth, metres
  std::vector<std::uint16_t> units;  ///< of WholeNumbers, millimetres
  std::vector<float> xyz;            ///< of clouds
  std::vector<std::uint8_t> mask;    ///< empty if all pixels are given
  Projection projection = Projection::Perspective;
  bool closes_round = false;
};

/// How to segment it.
struct Way {
  Mode mode = Mode::InverseDepth;
  bool is_measured = false;  ///< the sensor is `auto`
  ScanDirection scan = ScanDirection::Both;
  int stride = 0;
  int threads = 1;
  bool adapts = true;

  Parameters parameters() const;
  std::optional<SensorModel> sensor(const SensorModel& model) const {
    return is_measured ? std::nullopt : std::optional<SensorModel>(model);
  }
};
std::ostream& operator<<(std::ostream& out, const Way& way);

/// Frames of these kinds, of any scene.
rc::Gen<FrameSpec> anyFrame(std::vector<FrameKind> kinds = {FrameKind::Depth, FrameKind::WholeNumbers, FrameKind::Cloud,
                                                            FrameKind::BackwardCloud, FrameKind::Scanner});
/// Frames that are large and calm enough to have planes.
rc::Gen<FrameSpec> planarFrame(std::vector<FrameKind> kinds);
/// Ways that the kind allows.
rc::Gen<Way> anyWay(FrameKind kind);

}  // namespace epcc::test
