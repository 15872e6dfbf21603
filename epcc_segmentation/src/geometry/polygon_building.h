// SPDX-License-Identifier: BSD-3-Clause
// Rings of drawn arcs -> polygons with holes on their planes, checked and measured.
#pragma once

#include <utility>
#include <vector>

#include "epcc_segmentation/surface_polygon.h"
#include "geometry/geos_shapes.h"
#include "geometry/outline_arcs.h"
#include "geometry/outline_planes.h"
#include "geometry/pixel_rays.h"

namespace epcc {

/// Builds the polygons of all labels, again and again while arcs are drawn finer where that is needed.
class PolygonBuilder {
 public:
  PolygonBuilder(const PixelRays& rays, const PolygonOptions& options, const OutlinePlanes& planes,
                 const OutlineArcs& outlines);

  /// Builds what is not good yet or has changed. True if all are good; else the arcs that are to blame are to be drawn
  /// anew.
  bool build(OutlineArcs& outlines, const std::vector<int>& changed);
  /// What was built last; polygons that are still not valid are mended.
  std::vector<SurfacePolygon> surfaces();

 private:
  struct Ring {
    int ring = 0;       ///< in the label arcs
    double area = 0.0;  ///< of the pixels' own edges, positive for an outline
    bool is_left_out = false;
  };
  struct Region {
    std::vector<Ring> rings;  ///< by component, each with its outline first
    double turn = 1.0;        ///< -1 if the picture is a mirror image of the plane
    double area = 0.0;        ///< of all rings
    bool is_good = false;
    int flaws = 0;  ///< times that it was not valid
    SurfacePolygon polygon;
    std::vector<FlatPolygon> flat;  ///< of the polygon's pieces, in their order
  };

  void sortRings(const OutlineArcs& outlines);
  void leaveOut(const std::vector<LabelRing>& rings, Region& region) const;
  double ringArea(const OutlineArcs& outlines, int ring) const;
  bool isSimple(Region& region, OutlineArcs& outlines) const;
  void assemble(int label, Region& region, const OutlineArcs& outlines);
  SurfaceRing drawnRing(int label, int ring, double turn, const OutlineArcs& outlines) const;
  bool refineAt(int label, const Region& region, const Vector2& place, OutlineArcs& outlines) const;
  std::pair<int, std::size_t> arcAt(int label, const Region& region, const Vector2& place,
                                    const OutlineArcs& outlines) const;
  void mend(int label, Region& region);
  void measure(int label, Region& region);

  const PixelRays& rays_;
  const PolygonOptions& options_;
  const OutlinePlanes& planes_;
  GeosShapes shapes_;
  std::vector<Region> regions_;  // by label - 1
};

}  // namespace epcc
