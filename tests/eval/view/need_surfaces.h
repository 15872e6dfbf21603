// SPDX-License-Identifier: BSD-3-Clause
// Tests of what only a build with polygons and meshes shows, and of what the others say.
#pragma once

#include <gtest/gtest.h>

#include "eval/segment/frame_surfaces.h"

#define EPCC_NEED_SURFACES() \
  if (!surfacesMissing().empty()) GTEST_SKIP() << "no polygons, no mesh: " << surfacesMissing()

#define EPCC_NEED_NO_SURFACES() \
  if (surfacesMissing().empty()) GTEST_SKIP() << "this build has polygons and meshes (GEOS)"
