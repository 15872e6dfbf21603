// SPDX-License-Identifier: BSD-3-Clause
// Whether two segmentations of the same place, seen from two known poses, agree: a measure that needs no labels.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "datasets/files/image.h"
#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "eval/measures/value_counts.h"

namespace epcc {

constexpr long kRepeatedPercent = 80;   ///< of a region's shared pixels, in both directions
constexpr long kMinSharedPixels = 200;  ///< of a region that counts

/// What a camera saw and from where. A depth that is not above 0 is none.
struct PosedView {
  PinholeCamera camera;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< camera to world
  DepthImage depth;
};

bool isMeasured(float depth);
/// Of a pixel that is measured, in the camera's frame.
Eigen::Vector3d pointOf(const PosedView& view, int row, int column);

/// A segmentation as the measure needs it.
struct SeenRegions {
  LabelImage labels;          ///< 0 none, k the plane planes[k - 1]
  std::vector<Plane> planes;  ///< in the view's camera frame
  std::vector<bool> flat;     ///< by label: whether 85 % of its pixels lie within 3 sigma of its plane
};

/// Takes labels and planes and tells which regions are flat: the distance of a pixel's point from the plane against the
/// sensor's sigma at its depth. A region that is not flat is none, so that labelling everything alike wins nothing.
/// std::invalid_argument if the sizes differ or there are more than 65534 planes.
SeenRegions seenRegions(const PosedView& view, const PlaneSegmentation& segmentation, const SensorModel& sensor);

/// For each pixel of `from` the pixel of `to` (row * width + column) that shows the same place, or -1: its point,
/// carried by the poses, falls into that pixel, and the depth there is the point's within 2 cm + 2 %.
std::vector<std::int32_t> sharedPixels(const PosedView& from, const PosedView& to);

/// Of one pair of frames or, added up, of many.
struct Repeatability {
  long pairs = 0;            ///< of frames
  long shared = 0;           ///< pixels of the first frame that the second shows too
  long labelled = 0;         ///< of these, labelled in both
  long repeated_pixels = 0;  ///< of the shared ones, in repeated regions of the first frame
  long regions = 0;          ///< flat regions of the first frame with at least 200 shared pixels
  long repeated = 0;         ///< of these, each sharing 80 % of its shared pixels with its partner and in turn
  ValueCounts millidegrees;  ///< angles between the planes of partners
  ValueCounts micrometres;   ///< distances of the first plane's centroid from the second's plane

  Repeatability& operator+=(const Repeatability& other);
};

/// One pair. `shared` is sharedPixels(); `to_from` carries the first camera's coordinates into the second's.
Repeatability repeatability(const std::vector<std::int32_t>& shared, const SeenRegions& from, const SeenRegions& to,
                            const Eigen::Isometry3d& to_from);

/// One pair, from the views.
Repeatability repeatability(const PosedView& from_view, const SeenRegions& from, const PosedView& to_view,
                            const SeenRegions& to);

}  // namespace epcc
