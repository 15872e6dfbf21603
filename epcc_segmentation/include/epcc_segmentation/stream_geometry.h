// SPDX-License-Identifier: BSD-3-Clause
// How the scan lines of a stream see the world.
#pragma once

#include <string>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/projection.h"

namespace epcc {

/// The rays of a stream's scan lines.
class EPCC_CORE_EXPORT StreamGeometry {
 public:
  /// What a scan line is.
  enum class Kind {
    CameraColumns,  ///< a column of depths of a camera: ScanLineStream::addColumn()
    CameraRows,     ///< a row of depths of a camera: ScanLineStream::addRow()
    Scanner,        ///< the ranges of all rings at one azimuth: ScanLineStream::addColumnAt()
    Points          ///< a column of points: ScanLineStream::addPoints()
  };

  /// A camera read column by column. A width of 0 is not known: any index from 0 to 1 000 000 is a column.
  static StreamGeometry cameraColumns(const PinholeCamera& camera);
  /// A camera read row by row; a height of 0 is not known.
  static StreamGeometry cameraRows(const PinholeCamera& camera);
  /// A spinning scanner: the elevation of each ring above the horizon in radians, rising or falling from ring to ring,
  /// and what the azimuth changes by from column to column, radians: positive to the left, counter-clockwise seen from
  /// above, negative clockwise. `ring_azimuths`: of a scanner with staggered rings by how much each ring's ray lies to
  /// the left of the column's azimuth, radians, one a ring, within pi/4 and at most 4096 columns apart; empty, the
  /// default: all rays of a column have its azimuth. Scan lines are then made of the rings of several columns that look
  /// at one azimuth, to the nearest step (ringShift()); the rest of an offset is in the points.
  static StreamGeometry scanner(const std::vector<double>& elevations, double azimuth_step,
                                const std::vector<double>& ring_azimuths = {});
  /// Columns of an organized cloud with `height` points each. `azimuth_step` says how long a turn is, 0: there is none.
  static StreamGeometry points(int height, Projection projection, double azimuth_step = 0.0);

  /// What a scan line is.
  Kind kind() const { return kind_; }
  /// Samples of a scan line.
  int height() const { return height_; }
  /// Of a camera's scan lines: its intrinsics, as they were given.
  const PinholeCamera& camera() const { return camera_; }
  /// Of a scanner: the elevation of each ring, radians.
  const std::vector<double>& elevations() const { return elevations_; }
  /// Of a scanner with staggered rings: by how much each ring's ray lies to the left of its column's azimuth, radians.
  const std::vector<double>& ringAzimuths() const { return ring_azimuths_; }
  /// Whether rings of one column look at different azimuths: one of ringAzimuths() is not 0.
  bool isStaggered() const;
  /// Columns by which a ring lags, as ScanGrid::ring_shift: its sample in scan line i came with column
  /// i + ringShift(ring). 0 where rings are not staggered.
  int ringShift(int ring) const;
  /// From column to column, radians, positive to the left; 0: not known.
  double azimuthStep() const { return azimuth_step_; }
  /// How the scan lines' pixels see the world.
  Projection projection() const { return projection_; }
  /// Scan lines of a camera, 0: not known or no camera's.
  int lineCount() const;
  /// Columns of a turn, 0: not known.
  int columnsOfTurn() const;

  /// Empty if usable, else what is wrong in words.
  std::string validate() const;

 private:
  Kind kind_ = Kind::Points;
  int height_ = 0;
  PinholeCamera camera_;
  std::vector<double> elevations_;
  std::vector<double> ring_azimuths_;
  double azimuth_step_ = 0.0;
  Projection projection_ = Projection::Perspective;
};

}  // namespace epcc
