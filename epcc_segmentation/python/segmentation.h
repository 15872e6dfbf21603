// SPDX-License-Identifier: BSD-3-Clause
// Python's PlaneSegmentation: the library's, with what the frame was segmented with.
#pragma once

#include <memory>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/plane_extractor.h"

namespace epcc::python {

struct Segmentation {
  PlaneSegmentation data;
  SensorModel sensor;
  StageTimes times;
  std::shared_ptr<CloudGeometry> geometry;  // of a cloud
};

}  // namespace epcc::python
