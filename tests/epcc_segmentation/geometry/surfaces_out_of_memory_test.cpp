// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out at any moment of the drawing of polygons and meshes, within GEOS too: all or a status.
#include <gtest/gtest.h>

#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/surface_mesh.h"
#include "tests/support/failing_allocations.h"
#include "tests/support/rendered_room.h"

namespace {

using epcc::Status;

class SurfacesOutOfMemory : public testing::Test {
 protected:
  void SetUp() override {
    for (std::size_t i = 0; i < room_.depth.size(); ++i)  // a hole, and points that are missing
      if (i % 97 == 0 || (i / 48 > 4 && i / 48 < 9 && i % 48 > 10 && i % 48 < 17)) room_.depth[i] = 0.0f;
    ASSERT_TRUE(epcc::PlaneExtractor(epcc::Parameters(), sensor_).extract(room_.frame(), segmentation_));
    expected_ = draw();
    ASSERT_EQ(expected_.surfaces.size(), 3U);
  }
  epcc::SurfacePolygons draw() const { return epcc::surfacePolygons(room_.frame(), sensor_, segmentation_); }
  static std::vector<double> areas(const epcc::SurfacePolygons& polygons) {
    std::vector<double> result;
    for (const auto& surface : polygons.surfaces) result.push_back(surface.area);
    return result;
  }

  epcc::SensorModel sensor_ = epcc::SensorModel::axial(0.001, 0.001);
  epcc::test::RenderedRoom room_ = epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(48, 36));
  epcc::PlaneSegmentation segmentation_;
  epcc::SurfacePolygons expected_;
};

TEST_F(SurfacesOutOfMemory, PolygonsAreAllOrNone) {
  int refused = 0;
  bool ran_out = true;
  for (long allowed = 0; ran_out; allowed += allowed < 200 ? 1 : 7) {
    epcc::SurfacePolygons polygons;
    {
      const epcc::test::FailingAllocations memory(allowed);
      ASSERT_NO_THROW(polygons = draw());
      ran_out = memory.happened();
    }
    if (polygons.status == Status::Ok) {
      ASSERT_EQ(areas(polygons), areas(expected_)) << "after " << allowed << " allocations";
      ASSERT_EQ(polygons.edges.size(), expected_.edges.size());
      continue;
    }
    ++refused;
    ASSERT_TRUE(ran_out);
    ASSERT_EQ(polygons.status, Status::OutOfMemory) << polygons.problem;
    ASSERT_TRUE(polygons.surfaces.empty() && polygons.edges.empty());
  }
  EXPECT_GT(refused, 100);
}

// Without holes: where memory runs out while GEOS 3.11 joins these to their outline it does not survive it.
TEST_F(SurfacesOutOfMemory, AMeshIsWholeOrNone) {
  for (epcc::SurfacePolygon& surface : expected_.surfaces)
    for (epcc::SurfacePiece& piece : surface.pieces) piece.holes.clear();
  const epcc::SurfaceMesh whole = epcc::surfaceMesh(expected_.surfaces);
  ASSERT_EQ(whole.status, Status::Ok);
  ASSERT_GT(whole.triangles.size(), 3U);
  int refused = 0;
  bool ran_out = true;
  for (long allowed = 0; ran_out; ++allowed) {
    epcc::SurfaceMesh mesh;
    {
      const epcc::test::FailingAllocations memory(allowed);
      ASSERT_NO_THROW(mesh = epcc::surfaceMesh(expected_.surfaces));
      ran_out = memory.happened();
    }
    if (mesh.status == Status::Ok) {
      ASSERT_EQ(mesh.triangles, whole.triangles) << "after " << allowed << " allocations";
      continue;
    }
    ++refused;
    ASSERT_EQ(mesh.status, Status::OutOfMemory);
    ASSERT_TRUE(mesh.triangles.empty() && mesh.vertices.empty());
  }
  EXPECT_GT(refused, 50);
}

}  // namespace
