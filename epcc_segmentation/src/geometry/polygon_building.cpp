// SPDX-License-Identifier: BSD-3-Clause
// Puts rings together, and asks GEOS whether they are valid.
#include "geometry/polygon_building.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/flat_points.h"

namespace epcc {

namespace {

constexpr double kLeastPiece = 1e-8;  // of the pixels' area: smaller ones are rounding

double perimeterOf(const FlatRing& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += (ring[i] - ring[i + 1 < ring.size() ? i + 1 : 0]).norm();
  return sum;
}

}  // namespace

PolygonBuilder::PolygonBuilder(const PixelRays& rays, const PolygonOptions& options, const OutlinePlanes& planes,
                               const OutlineArcs& outlines)
    : rays_(rays), options_(options), planes_(planes), regions_(planes.inverseDepths().size()) {
  sortRings(outlines);
}

double PolygonBuilder::ringArea(const OutlineArcs& outlines, int ring) const {
  double area = 0.0;
  for (const LabelRing::Part& part : outlines.arcs().rings[static_cast<std::size_t>(ring)].parts)
    area += part.is_reversed ? -outlines.cornersArea(part.arc, 1) : outlines.cornersArea(part.arc, 0);
  return area;
}

/// Which ring is an outline the plane tells: on the picture of a whole turn both borders of a floor go round.
void PolygonBuilder::sortRings(const OutlineArcs& outlines) {
  const std::vector<LabelRing>& rings = outlines.arcs().rings;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (!planes_.exists(rings[i].label)) continue;
    const int ring = static_cast<int>(i);
    regions_[static_cast<std::size_t>(rings[i].label - 1)].rings.push_back({ring, ringArea(outlines, ring), false});
  }
  for (Region& region : regions_) {
    std::sort(region.rings.begin(), region.rings.end(), [&](const Ring& a, const Ring& b) {
      const int of_a = rings[static_cast<std::size_t>(a.ring)].component;
      const int of_b = rings[static_cast<std::size_t>(b.ring)].component;
      if (of_a != of_b) return of_a < of_b;
      const double area_a = std::abs(a.area), area_b = std::abs(b.area);
      return area_a != area_b ? area_a > area_b : a.ring < b.ring;
    });
    double most = 0.0;
    for (const Ring& ring : region.rings)
      if (std::abs(ring.area) > std::abs(most)) most = ring.area;
    region.turn = most < 0.0 ? -1.0 : 1.0;
    for (Ring& ring : region.rings) {
      ring.area *= region.turn;
      region.area += ring.area;
    }
    leaveOut(rings, region);
  }
}

/// The smallest rings, as long as their area is not missed.
void PolygonBuilder::leaveOut(const std::vector<LabelRing>& rings, Region& region) const {
  std::vector<Ring*> small;
  const auto pixels = [&rings](const Ring* ring) { return rings[static_cast<std::size_t>(ring->ring)].pixels; };
  for (Ring& ring : region.rings)
    if (pixels(&ring) > 0 && pixels(&ring) < options_.min_ring_pixels) small.push_back(&ring);
  std::sort(small.begin(), small.end(), [&](const Ring* a, const Ring* b) {
    return pixels(a) != pixels(b) ? pixels(a) < pixels(b) : a->ring < b->ring;
  });
  double left = 0.5 * options_.max_area_change * std::abs(region.area);
  for (Ring* ring : small) {
    left -= std::abs(ring->area);
    if (left < 0.0) return;
    ring->is_left_out = true;
  }
}

bool PolygonBuilder::build(OutlineArcs& outlines, const std::vector<int>& changed) {
  for (const int label : changed) regions_[static_cast<std::size_t>(label - 1)].is_good = false;
  bool all_good = true;
  for (std::size_t k = 0; k < regions_.size(); ++k) {
    Region& region = regions_[k];
    if (region.is_good) continue;
    const int label = static_cast<int>(k) + 1;
    region.is_good = isSimple(region, outlines);
    assemble(label, region, outlines);
    if (region.is_good) {
      if (const auto flaw = shapes_.flaw(region.flat)) {
        ++region.flaws;
        region.is_good = !refineAt(label, region, *flaw, outlines);
      }
    }
    all_good = all_good && region.is_good;
  }
  return all_good;
}

SurfaceRing PolygonBuilder::drawnRing(int label, int ring, double turn, const OutlineArcs& outlines) const {
  SurfaceRing drawn;
  const PlaneBasis& basis = planes_.basis(label);
  const auto add = [&](int arc, const DrawnArc::Vertex& vertex) {
    const Vector3 point = rays_.toCaller(outlines.vertexPoint(label, arc, vertex));
    const Vector2 flat = basis.flat(point);
    if (!drawn.flat.empty() && drawn.flat.back() == flat) return;
    drawn.points.push_back(point);
    drawn.flat.push_back(flat);
  };
  for (const LabelRing::Part& part : outlines.arcs().rings[static_cast<std::size_t>(ring)].parts) {
    const std::vector<DrawnArc::Vertex>& vertices = outlines.drawn(part.arc).vertices;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
      add(part.arc, vertices[part.is_reversed ? vertices.size() - 1 - i : i]);
  }
  while (drawn.flat.size() > 1 && drawn.flat.back() == drawn.flat.front()) {
    drawn.flat.pop_back();
    drawn.points.pop_back();
  }
  if (turn < 0.0) {
    std::reverse(drawn.points.begin(), drawn.points.end());
    std::reverse(drawn.flat.begin(), drawn.flat.end());
  }
  return drawn;
}

void PolygonBuilder::assemble(int label, Region& region, const OutlineArcs& outlines) {
  const std::vector<LabelRing>& rings = outlines.arcs().rings;
  region.polygon.pieces.clear();
  region.flat.clear();
  int component = -1;
  bool has_outline = false;
  for (const Ring& own : region.rings) {
    const int of_ring = rings[static_cast<std::size_t>(own.ring)].component;
    const bool is_outline = of_ring != component;  // the largest of its component
    component = of_ring;
    if (is_outline) has_outline = false;
    if (own.is_left_out || (!is_outline && !has_outline)) continue;
    SurfaceRing ring = drawnRing(label, own.ring, region.turn, outlines);
    const double area = epcc::ringArea(ring.flat);
    const double inside = is_outline ? area : -area;
    if (ring.flat.size() < 3 || !(inside > kLeastPiece * planes_.pixelArea(label))) continue;  // nothing is left
    if (is_outline) {
      has_outline = true;
      region.flat.push_back({ring.flat, {}});
      region.polygon.pieces.push_back({std::move(ring), {}});
    } else {
      region.flat.back().holes.push_back(ring.flat);
      region.polygon.pieces.back().holes.push_back(std::move(ring));
    }
  }
}

void PolygonBuilder::mend(int label, Region& region) {
  FlatPoints points;
  for (const SurfacePiece& piece : region.polygon.pieces) {
    points.add(piece.outline);
    for (const SurfaceRing& hole : piece.holes) points.add(hole);
  }
  const auto ringOf = [&](const FlatRing& flat) {
    SurfaceRing ring;
    ring.flat = flat;
    for (const Vector2& p : flat) {
      const Vector3* known = points.find(p);
      ring.points.push_back(known != nullptr ? *known : region.polygon.basis.point(p));
    }
    return ring;
  };
  region.flat = shapes_.mended(region.flat);
  region.polygon.pieces.clear();
  region.polygon.is_mended = true;
  for (const FlatPolygon& flat : region.flat) {
    if (epcc::ringArea(flat.outline) < kLeastPiece * planes_.pixelArea(label)) continue;
    SurfacePiece piece{ringOf(flat.outline), {}};
    for (const FlatRing& hole : flat.holes) piece.holes.push_back(ringOf(hole));
    region.polygon.pieces.push_back(std::move(piece));
  }
}

void PolygonBuilder::measure(int label, Region& region) {
  SurfacePolygon& polygon = region.polygon;
  std::sort(polygon.pieces.begin(), polygon.pieces.end(), [](const SurfacePiece& a, const SurfacePiece& b) {
    return epcc::ringArea(a.outline.flat) > epcc::ringArea(b.outline.flat);
  });
  polygon.label = label;
  polygon.pixel_area = planes_.pixelArea(label);
  FlatRing outlines;
  for (const SurfacePiece& piece : polygon.pieces) {
    polygon.area += epcc::ringArea(piece.outline.flat);
    polygon.perimeter += perimeterOf(piece.outline.flat);
    for (const SurfaceRing& hole : piece.holes) {
      polygon.area += epcc::ringArea(hole.flat);
      polygon.perimeter += perimeterOf(hole.flat);
    }
    outlines.insert(outlines.end(), piece.outline.flat.begin(), piece.outline.flat.end());
  }
  polygon.extent = extentOf(shapes_.hull(outlines), polygon.basis);
}

std::vector<SurfacePolygon> PolygonBuilder::surfaces() {
  std::vector<SurfacePolygon> all;
  for (std::size_t k = 0; k < regions_.size(); ++k) {
    Region& region = regions_[k];
    region.polygon.basis = planes_.basis(static_cast<int>(k) + 1);
    if (shapes_.flaw(region.flat)) mend(static_cast<int>(k) + 1, region);
    measure(static_cast<int>(k) + 1, region);
    all.push_back(std::move(region.polygon));
  }
  return all;
}

}  // namespace epcc
