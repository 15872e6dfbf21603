// SPDX-License-Identifier: BSD-3-Clause
// How a segmentation ended, for programs; the words for people are in error().
#pragma once

namespace epcc {

/// How the last segmentation ended.
enum class Status {
  Ok,                 ///< Done; there may be no planes.
  NoInput,            ///< PCL class: setInputCloud() was not called, or with a null pointer.
  EmptyCloud,         ///< The cloud or the frame has no points.
  SizeMismatch,       ///< The points are not width * height, or are more than an index can name.
  Unorganized,        ///< PCL class: the cloud has one row.
  InvalidIndices,     ///< PCL class: an index is negative or beyond the cloud.
  InvalidCamera,      ///< The camera is out of its range or of another size than the depth image.
  InvalidParameters,  ///< A parameter or the sensor model is out of its range.
  UnsupportedScan,    ///< Row scan of a spherical scan, whose rows are cones; a scan line of another kind than a
                      ///< stream's.
  UnknownGeometry,    ///< Neither a camera nor a scanner sees the cloud's points in the order of its pixels.
  OutOfMemory,        ///< There is not enough memory for a frame of this size.
  Failed,             ///< Anything else.
  OutOfOrder          ///< Stream: a scan line came late or twice; it was left out.
};

}  // namespace epcc
