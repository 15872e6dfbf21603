// SPDX-License-Identifier: BSD-3-Clause
// Small labelled frames of a room, in memory.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"
#include "tests/support/rendered_room.h"

namespace epcc::test {

/// A room's corner of three planes, 80x60, with mild noise; `truth` are the planes' coefficients.
inline LabelledFrame tinyFrame(const std::string& name, unsigned seed) {
  const std::vector<Eigen::Vector4d> planes = cornerPlanes();
  RenderedRoom room = renderRoom(planes, testCamera(80, 60));
  addNoise(room, SensorModel::axial(0.0005, 0.0005), seed);
  LabelledFrame frame;
  frame.name = name;
  frame.camera.camera = room.camera;
  frame.camera.depth_scale = 0.001;
  frame.camera.noise = "0.0005,0.0005,1";
  frame.depth = DepthImage(80, 60);
  frame.depth.data = room.depth;
  frame.labels = LabelImage(80, 60);
  frame.labels.data.assign(room.labels.begin(), room.labels.end());
  frame.camera.extra["planes"] = nlohmann::json::array();
  for (std::size_t i = 0; i < planes.size(); ++i)
    frame.camera.extra["planes"].push_back(
        {{"id", i + 1}, {"coefficients", {planes[i](0), planes[i](1), planes[i](2), planes[i](3)}}});
  return frame;
}

/// Frames kept in memory.
class MemorySource : public FrameSource {
 public:
  MemorySource(const std::string& dataset, std::vector<LabelledFrame> frames)
      : dataset_(dataset), frames_(std::move(frames)) {}
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return frames_.size(); }
  std::string name(std::size_t index) const override { return frames_[index].name; }
  LabelledFrame read(std::size_t index) const override { return frames_[index]; }

 private:
  std::string dataset_;
  std::vector<LabelledFrame> frames_;
};

}  // namespace epcc::test
