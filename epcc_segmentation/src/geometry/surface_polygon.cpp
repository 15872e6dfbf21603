// SPDX-License-Identifier: BSD-3-Clause
// Label image -> arcs -> rings on planes -> valid polygons.
#include "epcc_segmentation/surface_polygon.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>

#include "geometry/crease_edges.h"
#include "geometry/geos_shapes.h"
#include "geometry/outline_arcs.h"
#include "geometry/outline_planes.h"
#include "geometry/plane_crease.h"
#include "geometry/polygon_building.h"

namespace epcc {

namespace {

constexpr int kMostPasses = 100;

bool isIn(double value, double least, double most) {
  return value >= least && value <= most;
}

SurfacePolygons failed(Status status, const char* problem) {
  SurfacePolygons result;
  result.status = status;
  result.problem = problem;
  return result;
}

std::string problemOf(const DepthFrame& frame, const PlaneSegmentation& segmentation) {
  if (frame.empty()) return frame.problem();
  const std::size_t pixels = static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height());
  const auto isSize = [&](int width, int height) {
    return segmentation.width == width && segmentation.height == height;
  };
  // Of a transposed view PlaneExtractor says the view's own size, others that of the arrays.
  const bool fits =
      isSize(frame.width(), frame.height()) || (frame.isTransposed() && isSize(frame.height(), frame.width()));
  if (!fits || segmentation.labels.size() != pixels) return "the segmentation is not of the frame's size";
  if (pixels > static_cast<std::size_t>(std::numeric_limits<int>::max() / 8)) return "the frame has too many pixels";
  return {};
}

SurfacePolygons draw(const DepthFrame& frame, const SensorModel& sensor, const PlaneSegmentation& segmentation,
                     const PolygonOptions& options) {
  const PixelRays rays(frame);
  std::vector<std::int32_t> labels = rays.scanLabels(segmentation.labels, static_cast<int>(segmentation.planes.size()));
  const OutlinePlanes planes(rays, frame, segmentation, labels, options.placement);
  PlaneCreases creases(rays, sensor, options.edges, planes.inverseDepths());
  bridgeGaps(rays, sensor, options.edges, planes.inverseDepths(), creases, labels);

  const LabelArcs arcs = findLabelArcs(labels, rays.width(), rays.height(), rays.closesRound());
  OutlineArcs outlines(rays, sensor, options, planes, arcs, creases);
  PolygonBuilder builder(rays, options, planes, outlines);
  bool is_done = false;
  for (int pass = 0; pass < kMostPasses && !is_done; ++pass) {
    is_done = builder.build(outlines, outlines.draw());
  }
  SurfacePolygons result;
  result.surfaces = builder.surfaces();
  result.edges = creaseEdges(rays, options.edges, outlines, creases);
  return result;
}

}  // namespace

std::string PolygonOptions::validate() const {
  if (!isIn(tolerance_pixels, 0.0, 100.0)) return "tolerance_pixels must be in [0, 100]";
  if (!isIn(tolerance_sigma, 0.0, 100.0)) return "tolerance_sigma must be in [0, 100]";
  if (!isIn(max_area_change, 0.0, 1.0)) return "max_area_change must be in [0, 1]";
  if (!isIn(min_ring_pixels, 0, 1e9)) return "min_ring_pixels must be in [0, 1e9]";
  if (!isIn(edges.max_gap, 0, 100)) return "edges.max_gap must be in [0, 100]";
  if (!isIn(edges.max_step, 0.0, 100.0)) return "edges.max_step must be in [0, 100]";
  if (!isIn(edges.place_pixels, 0.0, 100.0)) return "edges.place_pixels must be in [0, 100]";
  if (!isIn(edges.max_offset, 0.0, 100.0)) return "edges.max_offset must be in [0, 100]";
  if (!isIn(edges.min_angle, 0.0, M_PI_2)) return "edges.min_angle must be in [0, pi/2]";
  if (!isIn(edges.min_pixels, 1, 1e9)) return "edges.min_pixels must be in [1, 1e9]";
  return {};
}

SurfacePolygons surfacePolygons(const DepthFrame& frame, const SensorModel& sensor,
                                const PlaneSegmentation& segmentation, const PolygonOptions& options) try {
  std::string problem = options.validate();
  if (problem.empty()) problem = sensor.validate();
  if (!problem.empty()) return failed(Status::InvalidParameters, problem.c_str());
  problem = problemOf(frame, segmentation);
  if (!problem.empty()) return failed(frame.empty() ? frame.status() : Status::SizeMismatch, problem.c_str());
  return draw(frame, sensor, segmentation, options);
} catch (const std::bad_alloc&) {
  return failed(Status::OutOfMemory, "out of memory");
} catch (const std::exception& error) {
  return failed(Status::Failed, error.what());
}

std::vector<PlaneEdge> planeEdges(const DepthFrame& frame, const SensorModel& sensor,
                                  const PlaneSegmentation& segmentation, const EdgeOptions& options) {
  PolygonOptions all;
  all.edges = options;
  return surfacePolygons(frame, sensor, segmentation, all).edges;
}

}  // namespace epcc
