// SPDX-License-Identifier: BSD-3-Clause
// Folders of TUM RGB-D, ICL-NUIM and ScanNet, written here; ICL-NUIM also with a true frame.
#include <gtest/gtest.h>

#include "datasets/files/png_io.h"
#include "datasets/sources/dataset_registry.h"
#include "tests/datasets/files/npy_bytes.h"
#include "tests/support/expect_errors.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

class DepthImageFolders : public TempFolderTest {
 protected:
  /// A depth image of one value.
  void depth(const std::string& file, std::uint16_t value, int width = 640, int height = 480) const {
    fs::create_directories(fs::path(path(file)).parent_path());
    writeGray16(path(file), Image<std::uint16_t>(width, height, value));
  }
  void text(const std::string& file, const std::string& bytes) const {
    fs::create_directories(fs::path(path(file)).parent_path());
    write(file, bytes);
  }
  void scannet(const std::string& matrix) const {
    depth("scene/depth/0.png", 1500, 4, 3);
    text("scene/intrinsic/intrinsic_depth.txt", matrix);
  }
};

const char kMatrix[] = "577.5 0 319.5 0\n0 578.5 239.5 0\n0 0 1 0\n0 0 0 1\n";

TEST_F(DepthImageFolders, TumFramesComeFromTheAssociationFile) {
  const std::string root = "rgbd_dataset_freiburg1_desk/";
  depth(root + "depth/1.5.png", 5000);
  depth(root + "depth/2.5.png", 10000);
  depth(root + "depth/9.5.png", 1);
  text(root + "associations.txt",
       "# colour, depth\n1.4 rgb/1.4.png 2.5 depth/2.5.png\n\n1.5 depth/1.5.png 1.4 rgb/1.4.png\n");
  const auto frames = openDataset(path(root));
  EXPECT_EQ(frames->dataset(), "rgbd_dataset_freiburg1_desk");
  ASSERT_EQ(frames->size(), 2U);
  EXPECT_EQ(frames->name(0), "2.5");
  const LabelledFrame frame = frames->read(0);
  EXPECT_EQ(frame.depth.at(7, 9), 2.0F);
  EXPECT_TRUE(frame.labels.empty());
  EXPECT_EQ(frame.camera.camera.fx, 517.3);
  EXPECT_EQ(frame.camera.camera.cy, 255.3);
  EXPECT_EQ(frame.camera.depth_scale, 0.0002);
  EXPECT_EQ(frame.camera.noise, "kinect-v1");
  EXPECT_EQ(frames->read(1).depth.at(0, 0), 1.0F);
}

TEST_F(DepthImageFolders, OnlyLabelledImagesAreFramesWhereThereAreLabels) {
  for (const char* name : {"1", "2", "10", "11"}) depth(std::string("icl_traj0/depth/") + name + ".png", 5000);
  text("icl_traj0/depth.txt", "1 depth/1.png\n2 depth/2.png\n10 depth/10.png\n11 depth/11.png\n");
  std::vector<double> labels(640 * 480, 3.0);
  labels[641] = 0.0;
  text("icl_traj0/labels/10.npy", npyFile(npyHeader("<f8", "(307200,)"), rawBytes(labels)));
  depth("icl_traj0/labels/2.png", 4);
  const auto frames = openDataset(path("icl_traj0"));
  ASSERT_EQ(frames->size(), 2U);
  EXPECT_EQ(frames->name(0), "2");
  EXPECT_EQ(frames->read(0).labels.at(0, 0), 4);
  const LabelledFrame frame = frames->read(1);
  EXPECT_EQ(frame.name, "10");
  EXPECT_EQ(frame.labels.at(1, 1), 0);
  EXPECT_EQ(frame.labels.at(1, 2), 3);
  EXPECT_EQ(frame.camera.camera.fy, 480.0);
  EXPECT_EQ(frame.camera.noise, "rendered");
}

TEST_F(DepthImageFolders, ExtensionsMayBeInCapitals) {
  depth("a/depth/1.PNG", 5000);
  depth("a/labels/1.PNG", 4);
  const auto frames = openDataset("icl:" + path("a"));
  ASSERT_EQ(frames->size(), 1U);
  EXPECT_EQ(frames->files(0), (std::vector<std::string>{path("a/depth/1.PNG"), path("a/labels/1.PNG")}));
  EXPECT_EQ(frames->read(0).depth.at(0, 0), 1.0F);
  EXPECT_EQ(frames->read(0).labels.at(0, 0), 4);
}

TEST_F(DepthImageFolders, WithoutAListAllImagesAreFramesByNumber) {
  for (const char* name : {"10", "9", "1"}) depth(std::string("a/depth/") + name + ".png", 1);
  const auto frames = openDataset("icl:" + path("a"));
  ASSERT_EQ(frames->size(), 3U);
  EXPECT_EQ(frames->name(2), "10");
}

TEST_F(DepthImageFolders, CamerasAreNamedWhereTheFolderTellsNone) {
  depth("a/depth/1.png", 1);
  text("a/depth.txt", "1 depth/1.png\n");
  expectInputError([&] { openDataset(path("a")); }, path("a"), "name", "does not tell the camera");
  const std::pair<const char*, double> cameras[] = {
      {"tum-fr1:", 517.3}, {"tum-fr2:", 520.9}, {"tum-fr3:", 535.4}, {"icl:", 481.2}};
  for (const auto& [format, fx] : cameras) EXPECT_EQ(openDataset(format + path("a"))->read(0).camera.camera.fx, fx);
}

TEST_F(DepthImageFolders, BadTumFoldersAreErrors) {
  depth("fr1/depth/1.png", 1);
  const auto open = [&] { openDataset("tum:" + path("fr1")); };
  text("fr1/depth.txt", "# nothing\n");
  expectInputError(open, path("fr1/depth.txt"), "file", "names no depth image");
  text("fr1/depth.txt", "1 depth/1.png\n2 rgb/2.png\n");
  expectInputError(open, path("fr1/depth.txt"), "line 2", "names no file depth/");
  text("fr1/depth.txt", "1 depth/../../secret.png\n");
  expectInputError(open, path("fr1/depth.txt"), "line 1", "names no file depth/");
  text("fr1/depth.txt", "1 depth/1.png\n2 depth/2.png\n");
  const auto frames = openDataset(path("fr1"));
  expectInputError([&] { frames->read(1); }, path("fr1/depth/2.png"), "file", "does not exist");
  depth("fr1/depth/2.png", 1, 4, 4);
  expectInputError([&] { frames->read(1); }, path("fr1/depth/2.png"), "size", "4x4, but the camera has 640x480");
  fs::create_directory(path("fr1/labels"));
  expectInputError(open, path("fr1/labels"), "folder", "has no PNG or .npy");
  fs::remove_all(path("fr1/depth"));
  fs::remove(path("fr1/depth.txt"));
  expectInputError(open, path("fr1/depth"), "folder", "");
}

TEST_F(DepthImageFolders, TrueIclFrameAndEvopsLabelsAgreeWithTheNativeFrame) {
  EPCC_NEED_REAL_FRAMES("icl");
  const fs::path from(realFolder("icl"));
  fs::create_directories(path("living_room_traj0/depth"));
  fs::create_directories(path("living_room_traj0/rgb"));
  fs::create_directories(path("living_room_traj0/labels"));
  fs::copy_file(from / "icl_living_room_0_depth.png", path("living_room_traj0/depth/0.png"));
  fs::copy_file(from / "icl_living_room_0_gt.npy", path("living_room_traj0/labels/0.npy"));
  const auto frames = openDataset(path("living_room_traj0"));
  ASSERT_EQ(frames->size(), 1U);
  const LabelledFrame frame = frames->read(0), native = readLabelledFrame(realFolder("icl"), "icl_living_room_0");
  EXPECT_EQ(frame.depth.data, native.depth.data);
  EXPECT_EQ(frame.labels.data, native.labels.data);
  EXPECT_EQ(frame.camera.camera.fx, native.camera.camera.fx);
  EXPECT_EQ(frame.camera.camera.fy, native.camera.camera.fy);
  EXPECT_EQ(frame.camera.noise, native.camera.noise);
}

TEST_F(DepthImageFolders, ScannetSceneWithItsCameraAndPlanes) {
  scannet(kMatrix);
  depth("scene/depth/10.png", 2500, 4, 3);
  depth("scene/depth/9.png", 2000, 4, 3);
  depth("scene/planes/9.png", 7, 4, 3);
  depth("scene/planes/10.png", 8, 4, 3);
  depth("scene/labels/0.png", 1, 4, 3);
  const auto frames = openDataset(path("scene"));
  ASSERT_EQ(frames->size(), 2U);
  const LabelledFrame frame = frames->read(1);
  EXPECT_EQ(frame.name, "10");
  EXPECT_EQ(frame.depth.data, std::vector<float>(12, 2.5F));
  EXPECT_EQ(frame.labels.data, std::vector<std::uint16_t>(12, 8));
  EXPECT_EQ(frame.camera.camera.width, 4);
  EXPECT_EQ(frame.camera.camera.fx, 577.5);
  EXPECT_EQ(frame.camera.camera.fy, 578.5);
  EXPECT_EQ(frame.camera.camera.cx, 319.5);
  EXPECT_EQ(frame.camera.camera.cy, 239.5);
  EXPECT_EQ(frame.camera.noise, "structure-sensor");
}

TEST_F(DepthImageFolders, BadScannetScenesAreErrors) {
  const std::pair<const char*, const char*> wrong[] = {{"1 0 2 0", "fewer than 16"},
                                                       {"1 0 2 0 0 1 2 0 0 0 1 0 0 0 0 1 5", "more than 16"},
                                                       {"x 0 2 0 0 1 2 0 0 0 1 0 0 0 0 1", "'x' is not a number"},
                                                       {"nan 0 2 0 0 1 2 0 0 0 1 0 0 0 0 1", "'nan' is not a number"},
                                                       {"-1 0 2 0 0 1 2 0 0 0 1 0 0 0 0 1", "not positive"},
                                                       {"1 0.5 2 0 0 1 2 0 0 0 1 0 0 0 0 1", "without skew"},
                                                       {"1 0 2 0 0 1 2 0 0 0 2 0 0 0 0 1", "third"}};
  for (const auto& [matrix, part] : wrong) {
    scannet(matrix);
    expectInputError([&] { openDataset(path("scene")); }, path("scene/intrinsic/intrinsic_depth.txt"), "matrix", part);
  }
  scannet(kMatrix);
  depth("scene/labels/0.png", 1, 4, 4);
  const auto frames = openDataset(path("scene"));
  expectInputError([&] { frames->read(0); }, path("scene/labels/0.png"), "size", "4x4");
}

}  // namespace
}  // namespace epcc::test
