// SPDX-License-Identifier: BSD-3-Clause
// Sun raster files and ABW folders, by hand and against the same frames in native form.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>

#include "datasets/files/sun_raster.h"
#include "datasets/sources/abw_folder.h"
#include "datasets/sources/dataset_registry.h"
#include "tests/datasets/files/segcomp_files.h"
#include "tests/support/expect_errors.h"
#include "tests/support/real_frames.h"

namespace epcc::test {
namespace {

class Abw : public TempFolderTest {
 protected:
  void refused(const SunRecipe& recipe, const std::string& field, const std::string& part,
               std::size_t bytes = 512 * 512) const {
    const std::string file = write("bad", sunHeader(recipe) + std::string(bytes, '\1'));
    expectInputError([&] { readSunRaster(file); }, file, field, part);
  }
  LabelledFrame only() const {
    const AbwFolder frames(folder());
    EXPECT_EQ(frames.size(), 1U);
    return frames.read(0);
  }
};

TEST_F(Abw, RasterRowsArePaddedAndColourMapsSkipped) {
  SunRecipe recipe;
  recipe.width = 3;
  recipe.height = 2;
  recipe.type = 1;
  recipe.map_type = 1;
  recipe.map_length = 6;
  const auto image = readSunRaster(write("a", sunHeader(recipe) + "RRGGBB" + "abc_def_"));
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.data, (std::vector<std::uint8_t>{'a', 'b', 'c', 'd', 'e', 'f'}));
}

TEST_F(Abw, BadRastersAreErrors) {
  refused({1}, "signature", "not a Sun raster");
  refused({0x59a66a95, 0}, "width", "0 is not from 1");
  refused({0x59a66a95, 512, 0xffffffff}, "height", "4294967295 is not");
  refused({0x59a66a95, 16384, 16384}, "size", "more than");
  refused({0x59a66a95, 512, 512, 24}, "depth", "24 bits");
  refused({0x59a66a95, 512, 512, 8, 0, 2}, "type", "2 is not uncompressed");
  refused({0x59a66a95, 512, 512, 8, 0, 1, 1, 0xffffffff}, "data", "shorter");
  refused({}, "data", "shorter", 512 * 512 - 1);
  expectInputError([&] { readSunRaster(write("short", sunHeader({}).substr(0, 31))); }, path("short"), "header", "cut");
}

TEST_F(Abw, GreyBecomesDepthByTheImagesCalibration) {
  write("abw.test.19.range", sunRaster([](int row, int) { return row == 0 ? 0 : 100; }));
  write("abw.test.19.gt-seg", sunRaster([](int row, int column) { return row < 2 ? 12 : column < 9 ? 9 : 10; }));
  const LabelledFrame some = only();
  EXPECT_EQ(some.depth.at(0, 5), 0.0F);
  EXPECT_NEAR(some.depth.at(1, 5), 0.001 * (100 / 0.773545 + 785.410786), 1e-6);
  EXPECT_EQ(some.labels.at(0, 5), 0) << "not measured";
  EXPECT_EQ(some.labels.at(1, 5), 12);
  EXPECT_EQ(some.labels.at(2, 8), 0) << "below 10 is no plane";
  EXPECT_EQ(some.labels.at(2, 9), 10);
  EXPECT_EQ(some.camera.camera.fx, 1610.981722);
  EXPECT_EQ(some.camera.noise, "structured-light");
  EXPECT_EQ(some.camera.camera.validate(), "");

  std::filesystem::rename(path("abw.test.19.range"), path("abw.train.19.range"));
  const LabelledFrame most = only();
  EXPECT_NEAR(most.depth.at(1, 5), 0.001 * (100 / 0.791686 + 771.016866), 1e-6);
  EXPECT_EQ(most.camera.camera.fx, 1586.072821);
  EXPECT_TRUE(most.labels.empty());
}

TEST_F(Abw, FramesAreInTheOrderOfTheirNumbers) {
  for (const char* name : {"abw.test.10.range", "abw.test.9.range", "abw.test.0.range"}) write(name, sunHeader({}));
  ASSERT_TRUE(isAbwFolder(folder()));
  const AbwFolder frames(folder());
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames.name(1), "abw.test.9");
  EXPECT_EQ(frames.name(2), "abw.test.10");
}

TEST_F(Abw, UnknownCalibrationIsAnError) {
  const std::string file = write("other.range", sunRaster([](int, int) { return 1; }));
  expectInputError([&] { AbwFolder(folder()).read(0); }, file, "name", "is not abw.test.N");
}

TEST_F(Abw, OtherSizesAreErrors) {
  SunRecipe recipe;
  recipe.width = 2;
  recipe.height = 2;
  const std::string file = write("abw.test.1.range", sunHeader(recipe) + "abcd");
  expectInputError([&] { AbwFolder(folder()).read(0); }, file, "size", "512x512");
}

/// Labels differ in their numbers alone.
void expectSameRegions(const LabelImage& a, const LabelImage& b) {
  std::map<std::uint16_t, std::uint16_t> there, back;
  for (std::size_t i = 0; i < a.data.size(); ++i) {
    ASSERT_EQ(there.emplace(a.data[i], b.data[i]).first->second, b.data[i]) << "pixel " << i;
    ASSERT_EQ(back.emplace(b.data[i], a.data[i]).first->second, a.data[i]) << "pixel " << i;
  }
  EXPECT_EQ(there.at(0), 0);
}

TEST_F(Abw, OriginalFilesAgreeWithTheNativeFrames) {
  EPCC_NEED_REAL_FRAMES("abw_original");
  EPCC_NEED_REAL_FRAMES("abw");
  const auto frames = openDataset(realFolder("abw_original"));
  ASSERT_EQ(frames->size(), 2U);
  for (std::size_t i = 0; i < frames->size(); ++i) {
    const LabelledFrame frame = frames->read(i);
    const LabelledFrame native = readLabelledFrame(realFolder("abw"), i == 0 ? "abw_test_00" : "abw_test_03");
    EXPECT_EQ(frame.name, i == 0 ? "abw.test.0" : "abw.test.3");
    EXPECT_NEAR(frame.camera.camera.fx, native.camera.camera.fx, 1e-6);
    EXPECT_NEAR(frame.camera.camera.fy, native.camera.camera.fy, 1e-6);
    EXPECT_EQ(frame.camera.camera.cx, native.camera.camera.cx);
    EXPECT_EQ(frame.camera.camera.cy, native.camera.camera.cy);
    EXPECT_EQ(frame.camera.noise, native.camera.noise);
    for (std::size_t pixel = 0; pixel < frame.depth.data.size(); ++pixel)
      ASSERT_NEAR(frame.depth.data[pixel], native.depth.data[pixel], 1.1e-5) << "pixel " << pixel;
    expectSameRegions(frame.labels, native.labels);
  }
}

}  // namespace
}  // namespace epcc::test
