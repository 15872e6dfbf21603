// SPDX-License-Identifier: BSD-3-Clause
// epcc.PlaneTracker: its frames and its tracks.
#include "epcc_segmentation/plane_tracker.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <string>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "frames.h"
#include "segmentation.h"
#include "sensors.h"

namespace py = pybind11;
using namespace py::literals;

namespace epcc::python {

namespace {

using SharedParameters = std::shared_ptr<Parameters>;
using Camera = std::optional<PinholeCamera>;
using Scale = std::optional<double>;

/// Python's TrackedFrame: the library's, its segmentation apart.
struct Tracked {
  TrackedFrame data;
  std::unique_ptr<Segmentation> segmentation;
};

/// 4 x 4 numbers, or nothing.
std::optional<Isometry3> poseOf(const py::object& pose) {
  if (pose.is_none()) return std::nullopt;
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(pose);
  if (!array) {
    PyErr_Clear();
    throwTypeError("a pose is 4 x 4 numbers, camera to map");
  }
  if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4)
    throwStatus(Status::InvalidParameters, "a pose is 4 x 4 numbers, camera to map, not " + shapeText(array));
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> values(array.data());
  if (values.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
    throwStatus(Status::InvalidParameters, "the last row of a pose must be 0, 0, 0, 1");
  Isometry3 result = Isometry3::Identity();
  result.matrix() = values;
  return result;
}

/// The library's tracker, and the geometry of clouds.
class Tracker {
 public:
  Tracker(const TrackerParameters& tracker, const SharedParameters& parameters, const py::object& sensor)
      : tracker_(tracker, parameters ? *parameters : Parameters(), sensorOf(sensor)) {}

  std::unique_ptr<Tracked> track(const py::object& data, const Camera& camera, Scale depth_scale,
                                 const py::object& pose_matrix, double time) {
    const ArrayFrame frame = frameOf(data, camera, depth_scale, finder_);
    const std::optional<Isometry3> pose = poseOf(pose_matrix);
    auto tracked = std::make_unique<Tracked>();
    std::string error;
    Status status = Status::Ok;
    tracker_.run([&](PlaneTracker& tracker) {
      if (!tracker.track(frame.frame, pose, time, tracked->data)) error = tracker.error();
      status = tracker.status();
      tracked->segmentation.reset(
          new Segmentation{std::move(tracked->data.segmentation), tracker.sensor(), tracker.times(), frame.geometry});
    });
    throwProblem(status, error);
    return tracked;
  }

  std::vector<PlaneTrack> tracks() {
    return tracker_.run([](PlaneTracker& tracker) { return tracker.tracks(); });
  }
  std::optional<std::int32_t> labelOf(int track) {
    return tracker_.run([track](PlaneTracker& tracker) { return tracker.labelOf(track); });
  }
  double errorScale() {
    return tracker_.run([](PlaneTracker& tracker) { return tracker.errorScale(); });
  }

 private:
  Exclusive<PlaneTracker> tracker_;
  Exclusive<GeometryFinder> finder_;
};

std::unique_ptr<Tracker> made(const SharedParameters& parameters, const py::object& sensor, double pose_offset_sigma,
                              double pose_angle_sigma, double motion_offset_sigma, double motion_angle_sigma,
                              int confirm_frames, int search_frames, int memory_frames) {
  const TrackerParameters tracker = {pose_offset_sigma, pose_angle_sigma, motion_offset_sigma, motion_angle_sigma,
                                     confirm_frames,    search_frames,    memory_frames};
  throwProblem(Status::InvalidParameters, tracker.validate());
  return std::make_unique<Tracker>(tracker, parameters, sensor);
}

py::array labels(const py::object& self) {
  const Tracked& tracked = self.cast<const Tracked&>();
  const PlaneSegmentation& data = tracked.segmentation->data;
  return viewOf(tracked.data.labels, {data.height, data.width}, self);
}

py::array labelOfPlane(const py::object& self) {
  const std::vector<std::int32_t>& labels = self.cast<const Tracked&>().data.label_of_plane;
  return viewOf(labels, {static_cast<py::ssize_t>(labels.size())}, self);
}

void bindTrack(py::module_& module) {
  py::class_<PlaneTrack>(module, "PlaneTrack", "A plane of a PlaneTracker's map.")
      .def_readonly("label", &PlaneTrack::label, "From 1, for life.")
      .def_property_readonly(
          "coefficients", [](const PlaneTrack& t) -> const Vector4& { return t.plane.coefficients; },
          "(a, b, c, d), metres, map: a x + b y + c z + d = 0, unit normal to the side that it is seen from.")
      .def_property_readonly(
          "coefficients_covariance", [](const PlaneTrack& t) -> const Matrix4& { return t.plane.covariance; },
          "Their covariance, 4 x 4, of rank 3.")
      .def_readonly("centroid", &PlaneTrack::centroid, "Of what was seen of it, metres, map.")
      .def_readonly("first_frame", &PlaneTrack::first_frame, "Frames are counted from 0.")
      .def_readonly("last_frame", &PlaneTrack::last_frame, "The last frame that it was seen in.")
      .def_readonly("first_time", &PlaneTrack::first_time, "Seconds, as given.")
      .def_readonly("last_time", &PlaneTrack::last_time, "Of last_frame.")
      .def_readonly("frames", &PlaneTrack::frames, "How many frames it was seen in.")
      .def_readonly("confidence", &PlaneTrack::confidence, "That it is a surface, 0 to 1, mean over its pixels.")
      .def_property_readonly(
          "end", [](const PlaneTrack& t) { return inWords(t.end); },
          "\"none\": it goes on; \"merged\": it is part of merged_into; \"clutter\": it was no plane most of the time.")
      .def_readonly("merged_into", &PlaneTrack::merged_into, "Label of the other; 0 if it was not merged.")
      .def("__repr__", [](const PlaneTrack& t) {
        const Vector4& p = t.plane.coefficients;
        return py::str("<epcc.PlaneTrack {}, {:.4f} x + {:.4f} y + {:.4f} z + {:.4f} = 0, frames {} to {}>")
            .format(t.label, p(0), p(1), p(2), p(3), t.first_frame, t.last_frame);
      });
}

void bindTracked(py::module_& module) {
  py::class_<Tracked>(module, "TrackedFrame", "A frame, seen from the map of a PlaneTracker.")
      .def_property_readonly("labels", &labels, R"(H x W int32, labels that last: 0 for none.

A view on the result's memory, without a copy.)")
      .def_property_readonly("label_of_plane", &labelOfPlane,
                             "Of each of segmentation.planes the label that lasts, int32, 0 if it has none yet.")
      .def_property_readonly(
          "track_of_plane", [](const Tracked& t) { return t.data.track_of_plane; },
          "Number of the track of each of segmentation.planes: PlaneTracker.label_of tells its label later.")
      .def_property_readonly(
          "segmentation", [](Tracked& t) -> Segmentation& { return *t.segmentation; },
          "The PlaneSegmentation of this frame alone, in the camera's frame.")
      .def_property_readonly(
          "pose", [](const Tracked& t) -> const Isometry3::MatrixType& { return t.data.pose.camera_to_map.matrix(); },
          "4 x 4, camera to map, by the given or expected pose and the planes together.")
      .def_property_readonly(
          "pose_covariance", [](const Tracked& t) -> const Matrix6& { return t.data.pose.covariance; },
          "6 x 6, of a turn (rad) and then a shift (metres) in the camera's frame.")
      .def_property_readonly(
          "pose_information", [](const Tracked& t) -> const Matrix6& { return t.data.pose_information; },
          "What the planes alone say of the pose, the inverse of such a covariance; singular where they leave a "
          "direction open.")
      .def(
          "open_directions",
          [](const Tracked& t, double sigma) { return openDirections(t.data.pose_information, sigma); },
          "sigma"_a = 0.02, R"(Directions in which the planes leave the camera's place open, a list of unit vectors.

In the camera's frame; along each the planes alone allow a standard deviation of more than sigma metres. None where three
independent planes are seen, one in a corridor whose ends are not, two before a single wall.)")
      .def_property_readonly(
          "pose_jumped", [](const Tracked& t) { return t.data.pose_jumped; },
          "The planes say that the given pose jumped here; the map goes on without the jump.")
      .def_property_readonly(
          "squared_error", [](const Tracked& t) { return t.data.squared_error; },
          "Normalised squared error of each plane that was expected and seen, 3 on average.");
}

}  // namespace

void bindPlaneTracker(py::module_& module) {
  bindTrack(module);
  bindTracked(module);
  py::class_<Tracker>(module, "PlaneTracker", R"(Follows planes through the frames of a moving camera.

Each plane has a label for life and a place in a map, the camera a pose by the planes. Frames of one camera, in their
order.

parameters: Parameters, as they are now; None: the defaults. sensor: as segment(); measured over the frames if it is None.
pose_offset_sigma, pose_angle_sigma: standard deviation of given poses, metres and rad: raise it if the trajectory is
  rough, lower it if the planes are not to correct it.
motion_offset_sigma, motion_angle_sigma: what the camera does from frame to frame beyond going on as it did.
confirm_frames: a plane gets its label when it was seen in so many.
search_frames: what was no plane is looked at again in every so many frames.
memory_frames: that a decision remembers, whether a track is clutter and whether two are one.

Other Python threads go on while it works; threads that share a tracker take turns.)")
      .def(py::init(&made), "parameters"_a = py::none(), "sensor"_a = py::none(), py::kw_only(),
           "pose_offset_sigma"_a = 0.01, "pose_angle_sigma"_a = 0.005, "motion_offset_sigma"_a = 0.02,
           "motion_angle_sigma"_a = 0.02, "confirm_frames"_a = 3, "search_frames"_a = 10, "memory_frames"_a = 15)
      .def("track", &Tracker::track, "frame"_a, "camera"_a = py::none(), "depth_scale"_a = py::none(), py::kw_only(),
           "pose"_a = py::none(), "time"_a = 0.0, R"(Takes the next frame; a new TrackedFrame.

frame, camera, depth_scale: as segment().
pose: 4 x 4, camera to map, if it is known; None: the camera goes on as it did, and the planes say the rest. Without poses
  the first camera is the map's frame.
time: seconds, not before that of the last frame.

InputError, and it is as if the frame had not been there, for what cannot be used.)")
      .def_property_readonly("tracks", &Tracker::tracks,
                             "All tracks that had a label, a list of PlaneTrack by label, ended ones included.")
      .def("label_of", &Tracker::labelOf, "track"_a, R"(Label that a track has by now, by its number.

That of another where it turned out to be part of one, 0 if it ended without any, None while it is not confirmed.)")
      .def_property_readonly("error_scale", &Tracker::errorScale,
                             "How many times the covariance of planes their error has been so far, at least 1.");
}

}  // namespace epcc::python
