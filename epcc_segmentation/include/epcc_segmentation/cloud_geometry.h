// SPDX-License-Identifier: BSD-3-Clause
// How an organized cloud was measured: by a camera or a scanner, from where, in which unit and order of pixels.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/projection.h"
#include "epcc_segmentation/status.h"
#include "epcc_segmentation/vectors.h"

namespace epcc {

/// Where a sensor is: p = axes * s + origin for a point s of its own frame.
struct SensorPose {
  Matrix3 axes = Matrix3::Identity();  ///< columns: the sensor's axes in the cloud's frame; orthogonal, maybe mirrored
  Vector3 origin = Vector3::Zero();    ///< where the sensor is in the cloud's frame, in the cloud's unit or metres
};

/// What a caller knows of a cloud. Nothing of it need be said.
struct CloudOptions {
  /// What may have measured a cloud.
  enum class Sensor {
    Any,     ///< both are tried
    Camera,  ///< a camera alone: rows and columns are planar sections
    Scanner  ///< a spinning scanner alone: a column has one azimuth, a row one elevation
  };
  /// What is looked for. Default Any; choose one if the other is found where it cannot be.
  Sensor sensor = Sensor::Any;
  /// The cloud is in the frame that DepthFrame expects of this projection: nothing is searched.
  std::optional<Projection> projection;
  double unit = 0.0;       ///< metres per unit of the coordinates; 0: 1, or 0.001 where metres are impossible
  double min_depth = 0.0;  ///< nearer points are invalid: depth of a camera, range of a scanner; metres, at least 0
  double max_depth = std::numeric_limits<double>::infinity();  ///< farther points are invalid; metres, above min_depth
  std::optional<float> invalid;  ///< a point all of whose coordinates are this is none, as is NaN
  /// Where the sensor may have been, VIEWPOINT of a PCD file, in units of the cloud: tried like other poses.
  std::optional<SensorPose> viewpoint;

  /// Empty if usable, else what is wrong in words.
  EPCC_CORE_EXPORT std::string validate() const;
};

/// The rings of a scanner in the cloud: ring and column of the scan -> row and column of the cloud.
struct ScanGrid {
  bool rings_are_columns = false;  ///< rows and columns are exchanged: a ring is a column of the cloud
  std::vector<int> ring_order;     ///< the cloud's ring of each ring of the scan; empty: as in the cloud
  std::vector<int> ring_shift;     ///< columns by which a ring of the scan lags in the cloud; empty: none
  int margin = 0;             ///< columns that the scan has more than the cloud, whose shifts have no round to close
  bool closes_round = false;  ///< the last column adjoins the first
};

/// What was found out about a cloud.
struct CloudGeometry {
  /// UnknownGeometry: neither a camera nor a scanner sees the points so; OutOfMemory: nothing was found out.
  Status status = Status::EmptyCloud;
  std::string problem;  ///< the same in words; empty if nothing is wrong
  /// The frame and order of pixels of the cloud are those that DepthFrame expects of the projection, its unit is the
  /// metre, and what is invalid is seen from each point: nothing need be converted.
  bool is_plain = true;
  Projection projection = Projection::Perspective;  ///< what the sensor's own frame is
  SensorPose pose;                                  ///< metres
  double unit = 1.0;                                ///< metres per unit of the coordinates
  bool unit_is_guessed = false;                     ///< nobody said that it is not the metre
  ScanGrid grid;                                    ///< of a scanner
  /// How far the points are off the rays of their pixels: the 80 % quantile, in deviations of all rays. Infinite of a
  /// cloud with too few points to tell.
  double residual = 0.0;
  std::vector<Vector3f> invalid_points;                        ///< what stands for no point, in units of the cloud
  double min_depth = 0.0;                                      ///< nearer points are invalid, metres
  double max_depth = std::numeric_limits<double>::infinity();  ///< farther points are invalid, metres
};

/// Finds the geometry of clouds. Keeps its memory, and tries what it found last before it searches.
class EPCC_CORE_EXPORT GeometryFinder {
 public:
  /// A finder that has seen no cloud.
  GeometryFinder();
  ~GeometryFinder();
  /// Takes over memory and what was found last; the other begins anew.
  GeometryFinder(GeometryFinder&&) noexcept;
  /// Takes over memory and what was found last; the other begins anew.
  GeometryFinder& operator=(GeometryFinder&&) noexcept;

  /// x, y, z at `xyz + stride * (row * width + column)`, stride in floats. A few hundred points are looked at: a camera
  /// is known by the 3x4 matrix that takes points to their pixels, a scanner by the tables of azimuth and elevation,
  /// both in any frame and with rows and columns exchanged. A cloud with too few points counts as a camera's. The
  /// result is the finder's until the next call. Nothing is thrown, but std::bad_alloc by a finder that was moved away.
  const CloudGeometry& find(const float* xyz, std::size_t stride, int width, int height,
                            const CloudOptions& options = CloudOptions());

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// The same as GeometryFinder::find() for a single cloud: x, y, z at `xyz + stride * (row * width + column)`, stride in
/// floats.
EPCC_CORE_EXPORT CloudGeometry findGeometry(const float* xyz, std::size_t stride, int width, int height,
                                            const CloudOptions& options = CloudOptions());

}  // namespace epcc
