// SPDX-License-Identifier: BSD-3-Clause
// Planes over time behind the callbacks of a robot's middleware: messages in, a message out. The structs have the
// fields of ROS's sensor_msgs/Image and sensor_msgs/CameraInfo, so that those go in as they are. Needs Eigen alone.
#pragma once

#include <epcc_segmentation/plane_tracker.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace example {

/// What the node publishes for each frame.
struct PlaneMessage {
  double seconds = 0.0;
  int width = 0, height = 0;
  std::vector<std::int32_t> labels;  ///< row-major, 0 none, else a plane's number for life
  struct Plane {
    std::int32_t label;
    epcc::Vector4 coefficients;  ///< in the camera's frame
  };
  std::vector<Plane> planes;
  epcc::Isometry3 camera_to_map;
  bool pose_jumped = false;
};

/// Takes depth images as they come; says nothing of frames that cannot be used but to the log.
class TrackingNode {
 public:
  using Publish = std::function<void(const PlaneMessage&)>;
  using Log = std::function<void(const std::string&)>;

  TrackingNode(Publish publish, Log log) : publish_(std::move(publish)), log_(std::move(log)) {}

  /// `Image` and `CameraInfo` are ROS's or have their fields. The pose is camera to map, from odometry, if there is
  /// any.
  template <typename Image, typename CameraInfo>
  void onDepth(const Image& image, const CameraInfo& info, double seconds,
               const std::optional<epcc::Isometry3>& pose = std::nullopt) {
    epcc::PinholeCamera camera;
    camera.width = static_cast<int>(info.width);
    camera.height = static_cast<int>(info.height);
    camera.fx = info.k[0];
    camera.cx = info.k[2];
    camera.fy = info.k[4];
    camera.cy = info.k[5];
    if (image.width != info.width || image.height != info.height)
      return log_("the image and its camera are not of one size");
    if (image.data.size() < static_cast<std::size_t>(image.step) * image.height)
      return log_("the image has fewer bytes than it says");
    if (image.encoding == "16UC1")
      take<std::uint16_t>(image, camera, 0.001, seconds, pose);  // millimetres
    else if (image.encoding == "32FC1")
      take<float>(image, camera, 1.0, seconds, pose);  // metres
    else
      log_("depth is 16UC1 or 32FC1, not " + image.encoding);
  }

 private:
  template <typename Value, typename Image>
  void take(const Image& image, const epcc::PinholeCamera& camera, double scale, double seconds,
            const std::optional<epcc::Isometry3>& pose) {
    if (image.step < image.width * sizeof(Value)) return log_("the image's rows are not whole");
    epcc::DepthView<Value> view;  // the message's own memory: nothing is copied
    view.data = reinterpret_cast<const Value*>(image.data.data());
    view.width = camera.width;
    view.height = camera.height;
    view.row_stride = static_cast<std::ptrdiff_t>(image.step);
    view.scale = scale;
    if (!tracker_.track(epcc::DepthFrame::fromDepth(view, camera), pose, seconds, tracked_))
      return log_(tracker_.error());
    publish_(message(seconds));
  }

  PlaneMessage message(double seconds) const {
    PlaneMessage message;
    message.seconds = seconds;
    message.width = tracked_.segmentation.width;
    message.height = tracked_.segmentation.height;
    message.labels = tracked_.labels;
    for (std::size_t k = 0; k < tracked_.label_of_plane.size(); ++k)
      if (tracked_.label_of_plane[k] > 0)  // others are too young to have one
        message.planes.push_back({tracked_.label_of_plane[k], tracked_.segmentation.planes[k].coefficients});
    message.camera_to_map = tracked_.pose.camera_to_map;
    message.pose_jumped = tracked_.pose_jumped;
    return message;
  }

  epcc::PlaneTracker tracker_;
  epcc::TrackedFrame tracked_;  // keeps its memory
  Publish publish_;
  Log log_;
};

}  // namespace example
