// SPDX-License-Identifier: BSD-3-Clause
// Samples find the pixel of an earlier frame that showed the same place, alike on every vector unit.
#include "inverse_depth/carried_labels.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/rendered_room.h"
#include "tests/support/vector_units.h"

namespace epcc {
namespace {

/// Pixels of an earlier frame, with numbers as labels.
KnownView numberedView(const PinholeCamera& camera) {
  auto labels = std::make_shared<std::vector<std::int32_t>>();
  KnownView view;
  view.width = camera.width;
  view.height = camera.height;
  view.plane_of_label.push_back(0);
  for (int i = 0; i < camera.width * camera.height; ++i) {
    labels->push_back(i + 1);
    view.plane_of_label.push_back(i + 1);
  }
  view.labels = labels;
  return view;
}

TEST(CarriedLabels, ASampleIsWhereItsPointIsSeen) {
  const PinholeCamera camera = test::testCamera(61, 45);  // no multiple of any vector's lanes
  const test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), camera);
  InverseDepthImage image;
  image.read(room.frame());
  const KnownView view = numberedView(camera);
  Eigen::Isometry3d now = Eigen::Isometry3d::Identity();
  now.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d(0.3, 1.0, 0.2).normalized()).toRotationMatrix();
  now.translation() << 0.1, -0.05, 0.08;
  test::onEveryVectorUnit([&] {
    CarriedLabels carried;
    carried.begin(image, view);
    carried.carryFrom(Isometry3(now), view.camera_to_map);
    int inside = 0;
    for (int row = 0; row < image.height; ++row) {
      const std::int32_t* planes = carried.planes(image, row, 0, image.width);
      for (int column = 0; column < image.width; ++column) {
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        const bool measured = room.frame().point(row, column, point);
        point = now * point;
        const double x = camera.fx * point.x() / point.z() + camera.cx + 0.5;
        const double y = camera.fy * point.y() / point.z() + camera.cy + 0.5;
        const bool seen = measured && point.z() > 0.0 && x >= 0.0 && x < camera.width && y >= 0.0 && y < camera.height;
        if (std::min(std::abs(x - std::round(x)), std::abs(y - std::round(y))) < 1e-3) continue;  // rounding decides
        const std::int32_t expected =
            seen ? static_cast<std::int32_t>(y) * camera.width + static_cast<std::int32_t>(x) + 1 : kUnseen;
        ASSERT_EQ(planes[column], expected) << row << ' ' << column;
        inside += seen ? 1 : 0;
      }
    }
    EXPECT_GT(inside, image.width * image.height / 2);
  });
}

TEST(CarriedLabels, AViewOfFewerPixelsCoversTheSameFrame) {
  const PinholeCamera camera = test::testCamera(64, 48);
  const test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), camera);
  InverseDepthImage image;
  image.read(room.frame());
  KnownView view = numberedView(test::testCamera(32, 24));
  CarriedLabels carried;
  carried.begin(image, view);
  carried.carryFrom(Isometry3::Identity(), view.camera_to_map);
  for (const int row : {0, 1, 17, 47}) {
    const std::int32_t* planes = carried.planes(image, row, 0, image.width);
    for (const int column : {0, 1, 30, 63})
      EXPECT_EQ(planes[column], row / 2 * 32 + column / 2 + 1) << row << ' ' << column;
  }
}

TEST(CarriedLabels, APartOfARowIsThatPart) {
  const PinholeCamera camera = test::testCamera(61, 45);
  const test::RenderedRoom room = test::renderRoom(test::cornerPlanes(), camera);
  InverseDepthImage image;
  image.read(room.frame());
  CarriedLabels carried;
  const KnownView view = numberedView(camera);
  carried.begin(image, view);
  carried.carryFrom(Isometry3::Identity(), view.camera_to_map);
  const std::int32_t* row = carried.planes(image, 20, 0, image.width);
  const std::vector<std::int32_t> whole(row, row + image.width);
  const std::int32_t* part = carried.planes(image, 20, 17, 40);
  EXPECT_TRUE(std::equal(part, part + 23, whole.begin() + 17));
}

}  // namespace
}  // namespace epcc
