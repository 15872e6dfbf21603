// SPDX-License-Identifier: BSD-3-Clause
// The PCL class under its former path; new programs include epcc_segmentation/pcl/epcc_segmentation.h.
#pragma once

#include "epcc_segmentation/pcl/epcc_segmentation.h"  // IWYU pragma: export
