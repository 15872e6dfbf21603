// SPDX-License-Identifier: BSD-3-Clause
// Labels of other programs: NumPy arrays and pictures.
#include <gtest/gtest.h>

#include "datasets/files/npy_labels.h"
#include "datasets/files/png_io.h"
#include "datasets/sources/depth_image_folder.h"
#include "tests/datasets/files/npy_bytes.h"
#include "tests/datasets/files/png_bytes.h"
#include "tests/support/expect_errors.h"

namespace epcc::test {
namespace {

using Labels = std::vector<std::uint16_t>;

class LabelFiles : public TempFolderTest {
 protected:
  Labels npy(const std::string& type, const std::string& shape, const std::string& data) const {
    return readNpyLabels(write("a.npy", npyFile(npyHeader(type, shape), data)), 3, 2).data;
  }
  void refused(const std::string& bytes, const std::string& field, const std::string& part) const {
    const std::string file = write("bad.npy", bytes);
    expectInputError([&] { readNpyLabels(file, 3, 2); }, file, field, part);
  }
};

TEST_F(LabelFiles, NumpyNumbersOfAnyKind) {
  const Labels expected{0, 1, 2, 3, 4, 200};
  EXPECT_EQ(npy("<f8", "(6,)", rawBytes<double>({0, 1, 2, 3, 4, 200})), expected);
  EXPECT_EQ(npy("<f4", "(2, 3)", rawBytes<float>({0, 1, 2, 3, 4, 200})), expected);
  EXPECT_EQ(npy("<i8", "(2, 3)", rawBytes<std::int64_t>({0, 1, 2, 3, 4, 200})), expected);
  EXPECT_EQ(npy("<i4", "(2L, 3L)", rawBytes<std::int32_t>({0, 1, 2, 3, 4, 200})), expected);
  EXPECT_EQ(npy("<u2", "(6,)", rawBytes<std::uint16_t>({0, 1, 2, 3, 4, 200})), expected);
  EXPECT_EQ(npy("|u1", "(6,)", rawBytes<std::uint8_t>({0, 1, 2, 3, 4, 200})), expected);
}

TEST_F(LabelFiles, BadNumpyFilesAreErrors) {
  const std::string six = rawBytes<double>({0, 1, 2, 3, 4, 5});
  refused("nothing", "signature", "not a NumPy file");
  refused(std::string("\x93NUMPY\x09\x00\x05\x00", 10), "version", "not 1, 2 or 3");
  refused(npyFile(npyHeader("<f8", "(6,)"), "").substr(0, 40), "header", "cut short");
  refused(npyFile("{}", six), "descr", "is missing");
  refused(npyFile(npyHeader(">f8", "(6,)"), six), "descr", "little-endian");
  refused(npyFile(npyHeader("<c8", "(6,)"), six), "descr", "little-endian");
  refused(npyFile("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3), }", six), "fortran_order", "False");
  refused(npyFile(npyHeader("<f8", "(3, 2)"), six), "shape", "neither (2, 3)");
  refused(npyFile(npyHeader("<f8", "(99999999999999999999,)"), six), "shape", "neither");
  refused(npyFile(npyHeader("<f8", "(6,)"), six.substr(1)), "data", "not as long");
  refused(npyFile(npyHeader("<f8", "(6,)"), six + "x"), "data", "not as long");
  for (const double wrong : {-1.0, 0.5, 65536.0, 1e300, std::numeric_limits<double>::quiet_NaN()})
    refused(npyFile(npyHeader("<f8", "(6,)"), rawBytes<double>({0, 1, wrong, 3, 4, 5})), "data", "value 2 is ");
  refused(npyFile(npyHeader("<f8", "(6,)"), rawBytes<double>({0, 1, -1, 3, 4, 5})), "data",
          "value 2 is -1, no whole number from 0 to 65535");
}

TEST_F(LabelFiles, GreyPicturesHoldTheirNumbers) {
  EXPECT_EQ(readLabelPng(write("a.png", pngBytes(grayRecipe()))).data, grayValues());
  PngRecipe bytes;
  bytes.width = 3;
  bytes.height = 1;
  bytes.bit_depth = 8;
  bytes.scan_lines = std::string("\0\0\7\377", 4);
  EXPECT_EQ(readLabelPng(write("b.png", pngBytes(bytes))).data, (Labels{0, 7, 255}));
}

TEST_F(LabelFiles, ColoursArePlanesAndBlackAndWhiteAreNone) {
  PngRecipe colors;
  colors.width = 5;
  colors.height = 1;
  colors.bit_depth = 8;
  colors.color_type = 2;
  colors.scan_lines = std::string(
      "\0"
      "\5\5\5"
      "\0\0\0"
      "\1\2\3"
      "\377\377\377"
      "\5\5\5",
      16);
  EXPECT_EQ(readLabelPng(write("a.png", pngBytes(colors))).data, (Labels{2, 0, 1, 0, 2}));
}

TEST_F(LabelFiles, OtherPicturesAreErrors) {
  PngRecipe alpha = grayRecipe();
  alpha.color_type = 4;
  const std::string file = write("a.png", pngBytes(alpha));
  expectInputError([&] { readLabelPng(file); }, file, "color type", "neither grey");
  PngRecipe bits;
  bits.bit_depth = 1;
  write("a.png", pngBytes(bits));
  expectInputError([&] { readLabelPng(file); }, file, "bit depth", "is 1, not 8 or 16");
  write("a.png", pngBytes(grayRecipe()));
  expectInputError([&] { readLabelFile(file, 3, 5); }, file, "size", "5x3, but the depth image has 3x5");
}

}  // namespace
}  // namespace epcc::test
