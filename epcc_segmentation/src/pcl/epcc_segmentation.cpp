// SPDX-License-Identifier: BSD-3-Clause
// Instantiates the PCL class for PCL's point types with coordinates.
#include "epcc_segmentation/pcl/epcc_segmentation.h"

#include "epcc_segmentation/pcl/impl/epcc_segmentation.hpp"

#ifndef PCL_NO_PRECOMPILE
#include <pcl/point_types.h>
#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE(EPCCSegmentation, PCL_XYZ_POINT_TYPES)
#endif
