// SPDX-License-Identifier: BSD-3-Clause
// GEOS' C interface behind values.
#include "geometry/geos_shapes.h"

#define GEOS_USE_ONLY_R_API
#include <geos_c.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

namespace epcc {

struct GeosShapes::Handle {
  GEOSContextHandle_t context;
  bool ran_out = false;  ///< of memory, within GEOS: what it gave back is nothing for that alone
};

namespace {

/// GEOS catches what is thrown within it and tells it here.
void noteError(const char* message, void* ran_out) {
  if (message != nullptr && std::string_view(message).find("bad_alloc") != std::string_view::npos)
    *static_cast<bool*>(ran_out) = true;
}

/// Geometries of one context that end with their scope.
class Shape {
 public:
  Shape(GEOSContextHandle_t context, GEOSGeometry* geometry) : context_(context), geometry_(geometry) {}
  Shape(Shape&& other) noexcept : context_(other.context_), geometry_(other.release()) {}
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
  ~Shape() {
    if (geometry_ != nullptr) GEOSGeom_destroy_r(context_, geometry_);
  }
  GEOSGeometry* get() const { return geometry_; }
  GEOSGeometry* release() {
    GEOSGeometry* geometry = geometry_;
    geometry_ = nullptr;
    return geometry;
  }
  explicit operator bool() const { return geometry_ != nullptr; }

 private:
  GEOSContextHandle_t context_;
  GEOSGeometry* geometry_;
};

/// For a function that takes them over.
std::vector<GEOSGeometry*> released(std::vector<Shape>& shapes) {
  std::vector<GEOSGeometry*> result;
  result.reserve(shapes.size());
  for (Shape& shape : shapes) result.push_back(shape.release());
  return result;
}

GEOSCoordSequence* sequence(GEOSContextHandle_t context, const FlatRing& ring, bool closes) {
  std::vector<double> numbers;
  numbers.reserve(2 * ring.size() + 2);
  for (const Vector2& p : ring) numbers.insert(numbers.end(), {p.x(), p.y()});
  if (closes) numbers.insert(numbers.end(), {ring.front().x(), ring.front().y()});
  return GEOSCoordSeq_copyFromBuffer_r(context, numbers.data(), static_cast<unsigned>(numbers.size() / 2), 0, 0);
}

Shape ringShape(GEOSContextHandle_t context, const FlatRing& ring) {
  if (ring.size() < 3) return {context, nullptr};
  GEOSCoordSequence* points = sequence(context, ring, true);
  return {context, points == nullptr ? nullptr : GEOSGeom_createLinearRing_r(context, points)};
}

Shape polygonShape(GEOSContextHandle_t context, const FlatPolygon& polygon) {
  Shape outline = ringShape(context, polygon.outline);
  if (!outline) return {context, nullptr};
  std::vector<Shape> holes;
  for (const FlatRing& hole : polygon.holes)
    if (Shape shape = ringShape(context, hole)) holes.push_back(std::move(shape));
  std::vector<GEOSGeometry*> given = released(holes);
  return {context,
          GEOSGeom_createPolygon_r(context, outline.release(), given.data(), static_cast<unsigned>(given.size()))};
}

Shape multiPolygon(GEOSContextHandle_t context, const std::vector<FlatPolygon>& polygons) {
  std::vector<Shape> parts;
  for (const FlatPolygon& polygon : polygons)
    if (Shape shape = polygonShape(context, polygon)) parts.push_back(std::move(shape));
  std::vector<GEOSGeometry*> given = released(parts);
  return {context,
          GEOSGeom_createCollection_r(context, GEOS_MULTIPOLYGON, given.data(), static_cast<unsigned>(given.size()))};
}

/// Of a linear ring: without the point that closes it.
FlatRing pointsOf(GEOSContextHandle_t context, const GEOSGeometry* ring) {
  FlatRing points;
  const GEOSCoordSequence* sequence = ring == nullptr ? nullptr : GEOSGeom_getCoordSeq_r(context, ring);
  unsigned size = 0;
  if (sequence == nullptr || GEOSCoordSeq_getSize_r(context, sequence, &size) == 0) return points;
  std::vector<double> numbers(2 * static_cast<std::size_t>(size));
  if (size == 0 || GEOSCoordSeq_copyToBuffer_r(context, sequence, numbers.data(), 0, 0) == 0) return points;
  for (std::size_t i = 0; i + 1 < size; ++i) points.emplace_back(numbers[2 * i], numbers[2 * i + 1]);
  return points;
}

void turn(FlatRing& ring, bool counter_clockwise) {
  if ((ringArea(ring) > 0.0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
}

/// All polygons of a geometry, whatever else is in it.
void collect(GEOSContextHandle_t context, const GEOSGeometry* geometry, std::vector<FlatPolygon>& polygons) {
  if (geometry == nullptr) return;
  const int type = GEOSGeomTypeId_r(context, geometry);
  if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION)
    for (int i = 0; i < GEOSGetNumGeometries_r(context, geometry); ++i)
      collect(context, GEOSGetGeometryN_r(context, geometry, i), polygons);
  if (type != GEOS_POLYGON) return;
  FlatPolygon polygon;
  polygon.outline = pointsOf(context, GEOSGetExteriorRing_r(context, geometry));
  if (polygon.outline.size() < 3) return;
  turn(polygon.outline, true);
  const int holes = GEOSGetNumInteriorRings_r(context, geometry);
  for (int i = 0; i < holes; ++i) {
    polygon.holes.push_back(pointsOf(context, GEOSGetInteriorRingN_r(context, geometry, i)));
    turn(polygon.holes.back(), false);
  }
  polygons.push_back(std::move(polygon));
}

}  // namespace

double ringArea(const FlatRing& ring) {
  double sum = 0.0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i - 1] - ring[0], b = ring[i] - ring[0];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * sum;
}

GeosShapes::GeosShapes() : handle_(new Handle{GEOS_init_r()}) {
  if (handle_->context == nullptr) {
    delete handle_;
    throw std::bad_alloc();
  }
  GEOSContext_setErrorMessageHandler_r(handle_->context, noteError, &handle_->ran_out);
}

void GeosShapes::throwIfRanOut() const {
  if (!handle_->ran_out) return;
  handle_->ran_out = false;
  throw std::bad_alloc();
}

GeosShapes::~GeosShapes() {
  GEOS_finish_r(handle_->context);
  delete handle_;
}

std::optional<Vector2> GeosShapes::flaw(const std::vector<FlatPolygon>& polygons) {
  GEOSContextHandle_t context = handle_->context;
  const Shape shape = multiPolygon(context, polygons);
  throwIfRanOut();
  if (!shape || polygons.empty()) return std::nullopt;
  GEOSGeometry* location = nullptr;
  const char is_valid = GEOSisValidDetail_r(context, shape.get(), 0, nullptr, &location);
  const Shape place(context, location);
  throwIfRanOut();
  if (is_valid == 1) return std::nullopt;
  double x = 0.0, y = 0.0;
  if (place) {
    GEOSGeomGetX_r(context, place.get(), &x);
    GEOSGeomGetY_r(context, place.get(), &y);
  }
  return Vector2(x, y);
}

std::vector<FlatPolygon> GeosShapes::mended(const std::vector<FlatPolygon>& polygons) {
  GEOSContextHandle_t context = handle_->context;
  std::vector<FlatPolygon> valid;
  const Shape shape = multiPolygon(context, polygons);
  throwIfRanOut();
  if (!shape) return valid;
  GEOSMakeValidParams* how = GEOSMakeValidParams_create_r(context);
  throwIfRanOut();
  if (how == nullptr) return valid;
  GEOSMakeValidParams_setMethod_r(context, how, GEOS_MAKE_VALID_STRUCTURE);
  GEOSMakeValidParams_setKeepCollapsed_r(context, how, 0);
  const Shape result(context, GEOSMakeValidWithParams_r(context, shape.get(), how));
  GEOSMakeValidParams_destroy_r(context, how);
  throwIfRanOut();
  collect(context, result.get(), valid);
  throwIfRanOut();
  return valid;
}

FlatRing GeosShapes::hull(const FlatRing& points) {
  GEOSContextHandle_t context = handle_->context;
  FlatRing ring;
  if (points.size() < 3) return ring;
  GEOSCoordSequence* all = sequence(context, points, false);
  const Shape line(context, all == nullptr ? nullptr : GEOSGeom_createLineString_r(context, all));
  const Shape shape(context, line ? GEOSConvexHull_r(context, line.get()) : nullptr);
  throwIfRanOut();
  if (!shape || GEOSGeomTypeId_r(context, shape.get()) != GEOS_POLYGON) return ring;
  ring = pointsOf(context, GEOSGetExteriorRing_r(context, shape.get()));
  throwIfRanOut();
  turn(ring, true);
  return ring;
}

std::vector<std::array<Vector2, 3>> GeosShapes::triangles(const FlatPolygon& polygon) {
  GEOSContextHandle_t context = handle_->context;
  std::vector<std::array<Vector2, 3>> all;
  const Shape shape = polygonShape(context, polygon);
  const Shape result(context, shape ? GEOSConstrainedDelaunayTriangulation_r(context, shape.get()) : nullptr);
  throwIfRanOut();
  std::vector<FlatPolygon> parts;
  collect(context, result.get(), parts);
  throwIfRanOut();
  for (const FlatPolygon& part : parts)
    if (part.outline.size() == 3) all.push_back({part.outline[0], part.outline[1], part.outline[2]});
  return all;
}

}  // namespace epcc
