// SPDX-License-Identifier: BSD-3-Clause
// What is known before a frame is segmented, planes in a map and where the camera is, and what became of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "epcc_segmentation/vectors.h"

namespace epcc {

/// A camera in a map. An error of the pose is a turn and a shift in the camera's own frame (x right, y down, z
/// forward): true pose = camera_to_map * (turn by ω rad, then shift by v m), (ω, v) of this covariance.
struct UncertainPose {
  Isometry3 camera_to_map = Isometry3::Identity();  ///< carries points of the camera's frame into the map, metres
  Matrix6 covariance = Matrix6::Zero();             ///< of (ω, v), rad^2, rad m and m^2
};

/// A plane of a map.
struct MapPlane {
  /// (a, b, c, d), metres, in the map's frame: a x + b y + c z + d = 0, unit normal to the side that it is seen from.
  Vector4 coefficients = Vector4::Zero();
  /// Their covariance, of rank 3.
  Matrix4 covariance = Matrix4::Zero();
};

/// Instead of a plane: what is there was not looked at, Continuation::waiting.
constexpr std::int32_t kNotLookedAt = -1;

/// An earlier frame of the same camera: which plane its pixels were.
struct KnownView {
  /// Row-major, of all pixels or of a grid that covers the frame; 0 none.
  std::shared_ptr<const std::vector<std::int32_t>> labels;
  int width = 0;   ///< of labels
  int height = 0;  ///< of labels
  /// By label: 0 none, k the plane KnownPlanes::planes[k - 1], kNotLookedAt where nothing was looked for.
  std::vector<std::int32_t> plane_of_label;
  Isometry3 camera_to_map = Isometry3::Identity();  ///< where it was seen from
};

/// Planes of a map for PlaneExtractor::extract(). A pixel of the new frame is carried into the earlier ones, and what
/// it was there it is expected to be here; where its depth agrees it keeps that plane, and only what no known plane
/// explains is segmented anew. Known planes do not merge with each other and are not rejected: what they are was
/// decided when they were found.
struct KnownPlanes {
  std::vector<MapPlane> planes;  ///< in the map; more than are in sight do no harm
  /// Earlier frames; what the first one says goes before what the next ones say.
  std::vector<KnownView> views;
  UncertainPose pose;  ///< the new camera, as expected
  /// Whether all that they do not explain is segmented, or only what is new: what no view shows, and what is not where
  /// its plane is expected. Without it what was no plane in the last view is none, and known planes that touch are not
  /// compared.
  bool search = true;
  /// Whether what is new may wait for a later frame, where it is little, below a thirtieth of the frame, and not all is
  /// to be searched: then nothing is segmented and no plane is judged, and the frame is looked at on a grid of every
  /// second sample in each direction.
  bool may_wait = false;
  /// Of each plane, a surface's in frames that do not judge it, 0 to 1; empty: 1.
  std::vector<double> confidence;
  /// How many times the covariance of a frame's planes their error has been so far, at least 1.
  double error_scale = 1.0;
};

/// What became of known planes in a frame.
struct Continuation {
  /// Per plane of the segmentation: the known plane that it continues, by its place in KnownPlanes, or -1.
  std::vector<std::int32_t> continues;
  /// Pairs of known planes that touch in this frame and, as they lie here, are one surface.
  std::vector<std::pair<std::int32_t, std::int32_t>> alike;
  /// Those that are two.
  std::vector<std::pair<std::int32_t, std::int32_t>> apart;
  /// The camera by its expected pose and the planes together.
  UncertainPose pose;
  /// What the planes alone say of the pose, the inverse of a covariance; singular where they leave a direction open.
  Matrix6 pose_information = Matrix6::Zero();
  /// Per known plane: squared error of what is seen from what was expected, after the pose was found, in units of its
  /// covariance (3 on average); -1 if too little was seen.
  std::vector<double> squared_error;
  /// Squares of waiting_side pixels that are new and wait for a later frame, by their upper left pixel (row * width +
  /// column).
  std::vector<std::int32_t> waiting;
  int waiting_side = 1;             ///< of these squares, pixels
  std::size_t samples = 0;          ///< that are measured
  std::size_t from_first_view = 0;  ///< of them, those that the first view labelled
  std::size_t from_views = 0;       ///< those that all views together labelled
};

}  // namespace epcc
