// SPDX-License-Identifier: BSD-3-Clause
// 16-bit grey PNG: values as stored, through the writer and from files made by hand.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <numeric>

#include "datasets/files/png_io.h"
#include "tests/datasets/files/png_bytes.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

class PngTest : public test::TempFolderTest {
 protected:
  void expectRoundTrip(const Image<std::uint16_t>& image) const {
    writeGray16(path("a.png"), image);
    const auto read = readGray16(path("a.png"));
    EXPECT_EQ(read.width, image.width);
    EXPECT_EQ(read.height, image.height);
    EXPECT_EQ(read.data, image.data);
  }
  /// The values of test::grayRecipe() come out whatever else is in the file.
  void expectGrayValues(const std::string& bytes) const {
    const auto read = readGray16(write("a.png", bytes));
    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 3);
    EXPECT_EQ(read.data, test::grayValues());
  }
};

TEST_F(PngTest, SmallestAndLargestValuesSurviveTheRoundTrip) {
  Image<std::uint16_t> image(3, 1);
  image.data = {0, 1, 65535};
  expectRoundTrip(image);
}

TEST_F(PngTest, EveryValueSurvivesTheRoundTrip) {
  Image<std::uint16_t> image(256, 256);
  std::iota(image.data.begin(), image.data.end(), std::uint16_t{0});
  expectRoundTrip(image);
}

TEST_F(PngTest, OddSizesSurviveTheRoundTrip) {
  for (const auto& [width, height] :
       {std::pair{1, 1}, {1, 7}, {7, 1}, {3, 5}, {641, 3}, {17, 31}, {kMaxImageSide, 1}}) {
    Image<std::uint16_t> image(width, height);
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<std::uint16_t>(40503u * i);
    expectRoundTrip(image);
  }
}

TEST_F(PngTest, FileMadeByHandIsRead) {
  expectGrayValues(test::pngBytes(test::grayRecipe()));
}

TEST_F(PngTest, WriterMakesBigEndianSixteenBitGray) {
  Image<std::uint16_t> image(2, 1);
  image.data = {0x1234, 0xfedc};
  writeGray16(path("a.png"), image);
  const std::string bytes = test::bytesOf(path("a.png"));
  EXPECT_EQ(bytes.substr(0, 8), test::kPngSignature);
  EXPECT_EQ(bytes.substr(16, 10), std::string("\0\0\0\2\0\0\0\1\x10\0", 10));
}

TEST_F(PngTest, InterlacedFileIsReadRight) {
  test::PngRecipe recipe;
  recipe.width = 19;
  recipe.height = 13;
  recipe.interlace = 1;
  std::vector<std::uint16_t> values(19 * 13);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint16_t>(263 * i);
  recipe.scan_lines = test::adam7ScanLines(values, recipe.width);
  const auto read = readGray16(write("a.png", test::pngBytes(recipe)));
  EXPECT_EQ(read.width, 19);
  EXPECT_EQ(read.height, 13);
  EXPECT_EQ(read.data, values);
}

TEST_F(PngTest, GammaChunkDoesNotChangeValues) {
  auto recipe = test::grayRecipe();
  recipe.before_image = test::pngChunk("gAMA", test::bigEndian32(45455));
  expectGrayValues(test::pngBytes(recipe));
  recipe.before_image = test::pngChunk("gAMA", test::bigEndian32(100000));
  expectGrayValues(test::pngBytes(recipe));
}

TEST_F(PngTest, SrgbChunkDoesNotChangeValues) {
  auto recipe = test::grayRecipe();
  recipe.before_image = test::pngChunk("sRGB", std::string(1, '\0'));
  expectGrayValues(test::pngBytes(recipe));
}

TEST_F(PngTest, SignificantBitsTransparencyAndBackgroundDoNotChangeValues) {
  auto recipe = test::grayRecipe();
  recipe.before_image = test::pngChunk("sBIT", "\x0c") + test::pngChunk("tRNS", std::string("\0\1", 2)) +
                        test::pngChunk("bKGD", std::string("\3\4", 2));
  expectGrayValues(test::pngBytes(recipe));
}

TEST_F(PngTest, DamagedUnimportantChunkIsPassedOver) {
  auto recipe = test::grayRecipe();
  recipe.before_image = test::pngChunk("tEXt", "Title");
  recipe.before_image.back() ^= 1;
  expectGrayValues(test::pngBytes(recipe));
}

/// The most address space that this process has had, in KiB.
long peakAddressSpace() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmPeak:", 0) == 0) return std::atol(line.c_str() + 7);
  return 0;
}

TEST_F(PngTest, ChunkLongerThanTheFileTakesNoMemory) {
  auto recipe = test::grayRecipe();
  recipe.before_image = test::pngChunk("tEXt", "Title");
  recipe.before_image.replace(0, 4, test::bigEndian32(0x54000003));
  const std::string file = write("a.png", test::pngBytes(recipe));
  const long before = peakAddressSpace();
  ASSERT_GT(before, 0);
  test::expectInputError([&] { readGray16(file); }, file, "PNG header", "");
  test::expectInputError([&] { readLabelPng(file); }, file, "PNG header", "");
  EXPECT_LT(peakAddressSpace() - before, 64 * 1024);
}

TEST_F(PngTest, BytesBehindTheEndArePassedOver) {
  expectGrayValues(test::pngBytes(test::grayRecipe()) + "more");
}

TEST_F(PngTest, RgbIsWrittenAsEightBitColor) {
  ColorImage image(3, 2);
  image.at(1, 2) = {1, 2, 255};
  writeRgb(path("a.png"), image);
  const std::string bytes = test::bytesOf(path("a.png"));
  EXPECT_EQ(bytes.substr(16, 10), std::string("\0\0\0\3\0\0\0\2\x08\2", 10));
  test::expectInputError([&] { readGray16(path("a.png")); }, path("a.png"), "color type", "greyscale");
}

TEST_F(PngTest, WritingTwiceReplacesTheFile) {
  writeGray16(path("a.png"), Image<std::uint16_t>(4, 4, 7));
  expectRoundTrip(Image<std::uint16_t>(2, 3, 9));
  EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
}

// ---- bad input ----

struct BadPng {
  const char* name;
  std::string bytes;
  const char* field;
  const char* part;
};
void PrintTo(const BadPng& bad, std::ostream* stream) {
  *stream << bad.name;
}

class BadPngTest : public PngTest, public ::testing::WithParamInterface<BadPng> {};

TEST_P(BadPngTest, IsAnInputError) {
  const std::string file = write("bad.png", GetParam().bytes);
  test::expectInputError([&] { readGray16(file); }, file, GetParam().field, GetParam().part);
}

std::string recipeWith(int bit_depth, int color_type, std::size_t bytes_a_row, const std::string& before = "") {
  test::PngRecipe recipe;
  recipe.bit_depth = bit_depth;
  recipe.color_type = color_type;
  recipe.before_image = before;
  recipe.scan_lines.assign(recipe.height * (1 + bytes_a_row), '\0');
  return test::pngBytes(recipe);
}

std::string sized(std::uint32_t width, std::uint32_t height) {
  auto recipe = test::grayRecipe();
  recipe.width = width;
  recipe.height = height;
  return test::pngBytes(recipe);
}

/// The good file with one byte changed, counted from the start of `mark`.
std::string damaged(const std::string& mark, int offset) {
  std::string bytes = test::pngBytes(test::grayRecipe());
  bytes[bytes.find(mark) + static_cast<std::size_t>(offset)] ^= 0x40;
  return bytes;
}

std::string cut(std::size_t size) {
  return test::pngBytes(test::grayRecipe()).substr(0, size);
}

std::string withoutImage() {
  return cut(8 + 25) + test::pngChunk("IEND", "");
}

std::string shortImage() {
  auto recipe = test::grayRecipe();
  recipe.scan_lines.resize(12);
  return test::pngBytes(recipe);
}

const std::size_t kWhole = test::pngBytes(test::grayRecipe()).size();

INSTANTIATE_TEST_SUITE_P(
    Png, BadPngTest,
    ::testing::Values(
        BadPng{"Empty", "", "file", "is empty"}, BadPng{"OneByte", "\x89", "signature", "not a PNG"},
        BadPng{"CutInTheSignature", cut(7), "signature", "not a PNG"},
        BadPng{"SignatureAlone", cut(8), "PNG header", ""}, BadPng{"CutInTheHeader", cut(20), "PNG header", ""},
        BadPng{"CutBehindTheHeader", cut(33), "PNG header", ""}, BadPng{"CutInTheImage", cut(50), "PNG data", ""},
        BadPng{"CutBeforeTheEnd", cut(kWhole - 12), "PNG data", ""},
        BadPng{"CutByOneByte", cut(kWhole - 1), "PNG data", ""},
        BadPng{"Jpeg", "\xff\xd8\xff\xe0 and so on", "signature", "not a PNG"},
        BadPng{"Text", "no picture at all\n", "signature", "not a PNG"},
        BadPng{"LineEndsConverted", "\x89PNG\n\x1a\n and so on", "signature", "not a PNG"},
        BadPng{"EightBitGray", recipeWith(8, 0, 5), "bit depth", "is 8, not 16"},
        BadPng{"OneBitGray", recipeWith(1, 0, 1), "bit depth", "is 1, not 16"},
        BadPng{"Rgb8", recipeWith(8, 2, 15), "color type", "greyscale"},
        BadPng{"Rgb16", recipeWith(16, 2, 30), "color type", "greyscale"},
        BadPng{"Palette", recipeWith(8, 3, 5, test::pngChunk("PLTE", "abcdef")), "color type", "greyscale"},
        BadPng{"GrayAlpha", recipeWith(16, 4, 20), "color type", "greyscale"},
        BadPng{"Rgba", recipeWith(16, 6, 40), "color type", "greyscale"},
        BadPng{"ZeroWidth", sized(0, 3), "PNG header", ""}, BadPng{"ZeroHeight", sized(5, 0), "PNG header", ""},
        BadPng{"NegativeWidth", sized(0xffffffffu, 3), "PNG header", ""},
        BadPng{"HundredThousandASide", sized(100000, 100000), "PNG header", ""},
        BadPng{"TooManyPixels", sized(16384, 16384), "size", "more than 64000000 pixels"},
        BadPng{"OnePixelTooWide", sized(16385, 1), "PNG header", ""},
        BadPng{"FarMorePixelsThanBytes", sized(8000, 8000), "size", "too short"},
        BadPng{"MoreRowsThanData", sized(5, 40), "PNG data", ""},
        BadPng{"DamagedHeaderChecksum", damaged("IHDR", 18), "PNG header", ""},
        BadPng{"DamagedImageChecksum", damaged("IEND", -5), "PNG data", ""},
        BadPng{"DamagedImageData", damaged("IDAT", 9), "PNG data", ""},
        BadPng{"NoImageChunk", withoutImage(), "PNG header", ""}, BadPng{"TooFewRows", shortImage(), "PNG data", ""},
        BadPng{"BadBitDepth", recipeWith(5, 0, 10), "PNG header", ""}),
    [](const auto& case_info) { return std::string(case_info.param.name); });

TEST_F(PngTest, MissingFile) {
  test::expectInputError([&] { readGray16(path("none.png")); }, path("none.png"), "file", "does not exist");
}

TEST_F(PngTest, FolderInsteadOfFile) {
  test::expectInputError([&] { readGray16(folder()); }, folder(), "file", "is a folder");
}

TEST_F(PngTest, FileAsFolder) {
  const std::string file = write("a.png", "x") + "/b.png";
  test::expectInputError([&] { readGray16(file); }, file, "file", "");
}

TEST_F(PngTest, DeviceInsteadOfFile) {
  test::expectInputError([] { readGray16("/dev/zero"); }, "/dev/zero", "file", "regular");
}

}  // namespace
}  // namespace epcc
