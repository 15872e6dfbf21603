// SPDX-License-Identifier: BSD-3-Clause
// SynPEB scans: what becomes of points and labels, and folders that are none.
#include "datasets/synpeb.h"

#include <gtest/gtest.h>

#include "datasets/temp_folder.h"
#include "epcc_segmentation/sensor_model.h"
#include "eval/frame_source.h"

namespace epcc::test {
namespace {

const char kScan[] =
    "VERSION .7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 2\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n1 2 2 10\n3 0 0 9\nnan nan nan 12\n0 4 0 1234\n";

class Synpeb : public TempFolderTest {};

TEST_F(Synpeb, RangesLabelsAndPointsAreRead) {
  write("scan.pcd", kScan);
  const LabelledFrame frame = readSynpebScan(folder(), "scan");
  EXPECT_EQ(frame.depth.data, (std::vector<float>{3.0F, 3.0F, 0.0F, 4.0F}));
  EXPECT_EQ(frame.labels.data, (std::vector<std::uint16_t>{10, kIgnoreLabel, 12, 1234}));
  EXPECT_TRUE(SensorModel::parse(frame.camera.noise.value()).has_value());
  const DepthFrame view = frameView(frame);
  EXPECT_EQ(view.projection(), Projection::Spherical);
  Eigen::Vector3d point;
  ASSERT_TRUE(view.point(0, 0, point));
  EXPECT_EQ(point, Eigen::Vector3d(1, 2, 2));
  EXPECT_FALSE(view.point(1, 0, point));
}

TEST_F(Synpeb, FolderListsScansByName) {
  write("b.pcd", kScan);
  write("a.pcd", kScan);
  write("a.txt", "");
  const SynpebFolder scans(folder());
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans.name(0), "a");
  EXPECT_EQ(scans.read(1).name, "b");
}

TEST_F(Synpeb, FoldersWithoutScansAreErrors) {
  expectInputError([&] { SynpebFolder scans(folder()); }, folder(), "folder", "no scan");
  expectInputError([&] { SynpebFolder scans(path("none")); }, path("none"), "folder", "");
}

TEST_F(Synpeb, ScanWithoutLabelsIsAnError) {
  std::string text = kScan;
  write("scan.pcd", text.replace(text.find("intensity"), 9, "curvature"));
  EXPECT_THROW(readSynpebScan(folder(), "scan"), InputError);
}

}  // namespace
}  // namespace epcc::test
