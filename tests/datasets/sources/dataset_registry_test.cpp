// SPDX-License-Identifier: BSD-3-Clause
// Formats found out and formats named.
#include "datasets/sources/dataset_registry.h"

#include <gtest/gtest.h>

#include <set>

#include "datasets/sources/native_folder.h"
#include "datasets/support/folder_listing.h"
#include "tests/support/expect_errors.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

class DatasetRegistry : public TempFolderTest {
 protected:
  /// A native frame of 2x1 pixels without labels.
  void native(const std::string& sub_folder) const {
    std::filesystem::create_directories(path(sub_folder));
    LabelledFrame frame;
    frame.name = "a";
    frame.camera.camera = {2, 1, 1.0, 1.0, 0.0, 0.0};
    frame.depth = DepthImage(2, 1, 1.0F);
    writeLabelledFrame(path(sub_folder), frame);
  }
};

TEST_F(DatasetRegistry, FormatsHaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const DatasetFormat& format : datasetFormats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_FALSE(format.summary.empty());
  }
}

TEST_F(DatasetRegistry, NativeFoldersAreFoundOutAndNamed) {
  native("x");
  EXPECT_EQ(openDataset(path("x"))->name(0), "a");
  const auto named = openDataset("native:" + path("x"));
  EXPECT_EQ(named->dataset(), "x");
  EXPECT_EQ(named->read(0).depth.at(0, 1), 1.0F);
}

TEST_F(DatasetRegistry, CloudsWithAJsonAreNativeFramesAndBareOnesArePcd) {
  const std::string cloud =
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 2\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 2\n3 0 4\n";
  write("scans/a.pcd", cloud);
  write("scans/a.json", R"({"noise": "0.02,0,1"})");
  write("bare/a.pcd", cloud);
  write("bare/other.json", "{}");
  const auto scans = openDataset(path("scans"));
  EXPECT_EQ(scans->read(0).camera.noise, "0.02,0,1");
  EXPECT_EQ(scans->files(0).front(), path("scans/a.pcd"));
  EXPECT_FALSE(openDataset(path("bare"))->read(0).camera.noise.has_value());
}

TEST_F(DatasetRegistry, RealFolderHoldsDepthImagesAndLidarScans) {
  EPCC_NEED_REAL_FRAMES("sensors");
  const auto frames = openDataset(realFolder("sensors"));
  std::size_t scans = 0;
  for (std::size_t i = 0; i < frames->size(); ++i) {
    const LabelledFrame frame = frames->read(i);
    EXPECT_EQ(frame.labels.data.size(), frame.depth.data.size()) << frame.name;
    EXPECT_EQ(frame.scan.empty(), frame.camera.extra.count("cloud") == 0) << frame.name;
    if (frame.scan.empty()) continue;
    ++scans;
    EXPECT_EQ(frame.geometry.projection, Projection::Spherical) << frame.name;
  }
  EXPECT_EQ(scans, 2U);
}

TEST_F(DatasetRegistry, FolderWithAColonIsAFolder) {
  native("abw:x");
  const std::string here = std::filesystem::current_path().string();
  std::filesystem::current_path(folder());
  const auto frames = openDataset("abw:x");
  std::filesystem::current_path(here);
  EXPECT_EQ(frames->dataset(), "abw:x");
}

TEST_F(DatasetRegistry, FormatsAreToldFromPaths) {
  EXPECT_TRUE(namesFormat("abw:/data/images"));
  EXPECT_TRUE(namesFormat("nothing:/data/images"));
  EXPECT_FALSE(namesFormat("/data/images"));
  EXPECT_FALSE(namesFormat("/data/what:ever"));
  std::filesystem::create_directory(path("abw:x"));
  EXPECT_FALSE(namesFormat(path("abw:x")));
}

TEST_F(DatasetRegistry, UnknownThingsAreErrors) {
  native("x");
  expectInputError([&] { openDataset("nothing:" + path("x")); }, "nothing:" + path("x"), "format",
                   "there is none called 'nothing', only native, abw");
  expectInputError([&] { openDataset(path("none")); }, path("none"), "folder", "does not exist");
  expectInputError([&] { openDataset("abw:" + path("none")); }, path("none"), "folder", "");
  std::filesystem::create_directory(path("empty"));
  expectInputError([&] { openDataset(path("empty")); }, path("empty"), "folder", "none of the known data sets");
  const std::string file = write("file", "text");
  expectInputError([&] { openDataset(file); }, file, "folder", "none of the known data sets");
}

TEST_F(DatasetRegistry, EveryFormatRefusesWhatItIsNot) {
  std::filesystem::create_directory(path("empty"));
  const std::string file = write("file", "text");
  for (const DatasetFormat& format : datasetFormats())
    for (const std::string& what : {path("empty"), file, path("none")}) {
      EXPECT_FALSE(format.recognises(what)) << format.name;
      EXPECT_THROW(openDataset(format.name + ":" + what), InputError) << format.name;
    }
}

TEST_F(DatasetRegistry, NamesOfDataSetsAreThoseOfTheirFolders) {
  EXPECT_EQ(datasetName("abw:/data/images/"), "images");
  EXPECT_EQ(datasetName("/data/images/."), "images");
  EXPECT_EQ(datasetName("/data/what:ever"), "what:ever");
  EXPECT_EQ(datasetName("/"), "root");
}

TEST(FolderListing, NumbersAreInNumericOrder) {
  EXPECT_TRUE(naturallyBefore("a2", "a10"));
  EXPECT_FALSE(naturallyBefore("a10", "a2"));
  EXPECT_TRUE(naturallyBefore("a", "a1"));
  EXPECT_TRUE(naturallyBefore("a1b3", "a01b10"));
  EXPECT_TRUE(naturallyBefore("01", "1"));
  EXPECT_FALSE(naturallyBefore("1", "01"));
  EXPECT_FALSE(naturallyBefore("a", "a"));
  EXPECT_TRUE(naturallyBefore("99999999999999999999998", "99999999999999999999999"));
}

}  // namespace
}  // namespace epcc::test
