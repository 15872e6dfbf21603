// SPDX-License-Identifier: BSD-3-Clause
// Labelled clouds: what becomes of points and labels, and folders that are none.
#include "datasets/sources/labelled_cloud.h"

#include <gtest/gtest.h>

#include <set>

#include "epcc_segmentation/sensor_model.h"
#include "tests/support/expect_errors.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

const char kScan[] =
    "VERSION .7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 2\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n1 2 2 10\n3 0 0 9\nnan nan nan 12\n0 4 0 1234\n";

class LabelledCloud : public TempFolderTest {};

TEST_F(LabelledCloud, RangesLabelsAndPointsAreRead) {
  write("scan.pcd", kScan);
  const LabelledFrame frame = readLabelledCloud(path("scan.pcd"));
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

TEST_F(LabelledCloud, FolderListsScansByName) {
  write("b.pcd", kScan);
  write("a.pcd", kScan);
  write("a.txt", "");
  const LabelledCloudFolder scans(folder());
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans.name(0), "a");
  EXPECT_EQ(scans.read(1).name, "b");
}

TEST_F(LabelledCloud, FoldersWithoutScansAreErrors) {
  expectInputError([&] { LabelledCloudFolder scans(folder()); }, folder(), "folder", "no cloud");
  expectInputError([&] { LabelledCloudFolder scans(path("none")); }, path("none"), "folder", "");
}

TEST_F(LabelledCloud, CloudWithoutLabelsIsUnlabelled) {
  std::string text = kScan;
  write("scan.pcd", text.replace(text.find("intensity"), 9, "curvature"));
  const LabelledFrame frame = readLabelledCloud(path("scan.pcd"));
  EXPECT_TRUE(frame.labels.empty());
  EXPECT_FALSE(frame.camera.noise.has_value());
  EXPECT_EQ(frame.scan[1], 2.0F);
}

TEST_F(LabelledCloud, MeasuredIntensityIsNoLabel) {
  std::string text = kScan;
  write("scan.pcd", text.replace(text.find(" 9\n"), 3, " 9.5\n"));
  const LabelledFrame frame = readLabelledCloud(path("scan.pcd"));
  EXPECT_TRUE(frame.labels.empty());
  EXPECT_FALSE(frame.camera.noise.has_value());
}

TEST_F(LabelledCloud, LabelsThatAreNoWholeNumbersAreErrors) {
  std::string text = kScan;
  text.replace(text.find("intensity"), 9, "label");
  const std::string file = write("scan.pcd", text.replace(text.find(" 9\n"), 3, " 9.5\n"));
  expectInputError([&] { readLabelledCloud(file); }, file, "label", "of point 1 is not a whole number");
}

TEST_F(LabelledCloud, ALabelOfNoNumberIsOneOfAPointThatIsNotMeasured) {
  const auto with = [this](const std::string& third, const std::string& fourth) {
    std::string text = kScan;
    text.replace(text.find("intensity"), 9, "label");
    text.replace(text.find("nan nan nan 12"), 14, third);
    return write("scan.pcd", text.replace(text.find("0 4 0 1234"), 10, fourth));
  };
  const LabelledFrame frame = readLabelledCloud(with("nan nan nan nan", "0 0 0 nan"));
  EXPECT_EQ(frame.labels.data, (std::vector<std::uint16_t>{10, 9, 0, 0}));
  for (const char* label : {"nan", "inf"}) {
    const std::string file = with("nan nan nan 12", std::string("0 4 0 ") + label);
    expectInputError([&] { readLabelledCloud(file); }, file, "label", "of point 3 is not a whole number");
  }
}

TEST_F(LabelledCloud, ExtensionMayBeInCapitals) {
  write("scan.PCD", kScan);
  write("other.pcd", kScan);
  const LabelledCloudFolder scans(folder());
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans.name(1), "scan");
  EXPECT_EQ(scans.files(1), std::vector<std::string>{path("scan.PCD")});
  EXPECT_EQ(scans.read(1).name, "scan");
}

/// A camera's cloud of 4x3 points, all at 2 m, with the labels 0, 1, ...; the last is `last`.
std::string cameraCloud(const std::string& last) {
  std::string text =
      "VERSION .7\nFIELDS label x y z\nSIZE 4 4 4 4\nTYPE U F F F\nCOUNT 1 1 1 1\nWIDTH 4\nHEIGHT 3\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 12\nDATA ascii\n";
  for (int i = 0; i < 12; ++i)
    text += (i < 11 ? std::to_string(i) : last) + " " + std::to_string(i % 4) + " " + std::to_string(i / 4) + " 2\n";
  return text;
}

TEST_F(LabelledCloud, CamerasCloudWithLabelsIsPerspective) {
  write("cloud.pcd", cameraCloud("4294967295"));
  const LabelledFrame frame = readLabelledCloud(path("cloud.pcd"));
  EXPECT_EQ(frame.depth.data, std::vector<float>(12, 2.0F));
  EXPECT_EQ(frame.labels.data, (std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 0}));
  EXPECT_FALSE(frame.camera.noise.has_value());
  const DepthFrame view = frameView(frame);
  EXPECT_EQ(view.projection(), Projection::Perspective);
  Eigen::Vector3d point;
  ASSERT_TRUE(view.point(1, 2, point));
  EXPECT_EQ(point, Eigen::Vector3d(2, 1, 2));
}

TEST_F(LabelledCloud, Label65535IsIgnored) {
  write("cloud.pcd", cameraCloud("65535"));
  EXPECT_EQ(readLabelledCloud(path("cloud.pcd")).labels.data.back(), kIgnoreLabel);
}

TEST_F(LabelledCloud, RealSynpebScansHaveTheirPlanes) {
  EPCC_NEED_REAL_FRAMES("synpeb");
  const LabelledCloudFolder scans(realFolder("synpeb"));
  EXPECT_GE(scans.size(), 1U);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const LabelledFrame frame = scans.read(i);
    EXPECT_EQ(frame.geometry.projection, Projection::Spherical);
    EXPECT_EQ(detectProjection(frame.scan.data(), 3, frame.depth.width, frame.depth.height), Projection::Spherical);
    std::set<std::uint16_t> planes(frame.labels.data.begin(), frame.labels.data.end());
    EXPECT_GE(planes.size(), 10U) << frame.name;
  }
}

}  // namespace
}  // namespace epcc::test
