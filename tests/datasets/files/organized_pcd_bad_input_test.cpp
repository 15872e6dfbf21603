// SPDX-License-Identifier: BSD-3-Clause
// Every damaged PCD file is an InputError that names the line.
#include <gtest/gtest.h>

#include "datasets/files/organized_pcd.h"
#include "tests/datasets/files/pcd_text.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

struct BadPcd {
  const char* name;
  std::string bytes;
  const char* field;
  const char* part;
};
void PrintTo(const BadPcd& bad, std::ostream* stream) {
  *stream << bad.name;
}

class BadPcdTest : public test::TempFolderTest, public ::testing::WithParamInterface<BadPcd> {};

TEST_P(BadPcdTest, IsAnInputError) {
  const std::string file = write("bad.pcd", GetParam().bytes);
  test::expectInputError([&] { readOrganizedPcd(file); }, file, GetParam().field, GetParam().part);
}

const auto kName = [](const auto& case_info) { return std::string(case_info.param.name); };

std::string ascii(const std::string& key, const std::string& value) {
  return test::asciiPcd({{key, value}});
}
std::string rows(const std::string& text) {
  return test::pcdHeader() + text;
}

INSTANTIATE_TEST_SUITE_P(
    NoPcd, BadPcdTest,
    ::testing::Values(BadPcd{"Empty", "", "file", "is empty"}, BadPcd{"OneByte", "#", "header", "not that of a PCD"},
                      BadPcd{"Blanks", "\n\n  \n", "header", "not that of a PCD"},
                      BadPcd{"CommentsOnly", "# .PCD v0.7\n# nothing\n", "header", "not that of a PCD"},
                      BadPcd{"BadMagic", "ply\nformat ascii 1.0\nend_header\n", "header", "not that of a PCD"},
                      BadPcd{"Zeros", std::string(200, '\0'), "header", "not that of a PCD"},
                      BadPcd{"Png", "\x89PNG\r\n\x1a\n", "header", "not that of a PCD"},
                      BadPcd{"NoLineEnd", "VERSION 0.7", "header", "not that of a PCD"},
                      BadPcd{"HeaderWithoutEnd", test::pcdHeader({{"DATA", "-"}}) + std::string(100000, '#'), "DATA",
                             "is missing"},
                      BadPcd{"BareDataLine", "DATA\n", "DATA", "has no value"},
                      BadPcd{"DataLineAlone", "DATA ascii\n", "FIELDS", "is missing"}),
    kName);

INSTANTIATE_TEST_SUITE_P(MissingLine, BadPcdTest,
                         ::testing::Values(BadPcd{"Fields", ascii("FIELDS", "-"), "FIELDS", "is missing"},
                                           BadPcd{"Size", ascii("SIZE", "-"), "SIZE", "is missing"},
                                           BadPcd{"Type", ascii("TYPE", "-"), "TYPE", "is missing"},
                                           BadPcd{"Width", ascii("WIDTH", "-"), "WIDTH", "is missing"},
                                           BadPcd{"Height", ascii("HEIGHT", "-"), "HEIGHT", "is missing"},
                                           BadPcd{"Data", ascii("DATA", "-"), "DATA", "is missing"},
                                           BadPcd{"FieldsValue", ascii("FIELDS", ""), "FIELDS", "has no value"},
                                           BadPcd{"SizeValue", ascii("SIZE", ""), "SIZE", "has no value"},
                                           BadPcd{"TypeValue", ascii("TYPE", ""), "TYPE", "has no value"},
                                           BadPcd{"CountValue", ascii("COUNT", ""), "COUNT", "has no value"},
                                           BadPcd{"WidthValue", ascii("WIDTH", ""), "WIDTH", "has no value"},
                                           BadPcd{"HeightValue", ascii("HEIGHT", ""), "HEIGHT", "has no value"},
                                           BadPcd{"PointsValue", ascii("POINTS", ""), "POINTS", "has no value"},
                                           BadPcd{"DataValue", ascii("DATA", ""), "DATA", "has no value"}),
                         kName);

INSTANTIATE_TEST_SUITE_P(
    Fields, BadPcdTest,
    ::testing::Values(
        BadPcd{"NegativeSize", ascii("SIZE", "4 -4 4"), "SIZE", "-4 is not in 1..8"},
        BadPcd{"SizeZero", ascii("SIZE", "4 0 4"), "SIZE", "0 is not in 1..8"},
        BadPcd{"SizeThree", ascii("SIZE", "4 3 4"), "SIZE", "3 is not 1, 2, 4 or 8"},
        BadPcd{"SizeHuge", ascii("SIZE", "4 99999999999999999999 4"), "SIZE", "is not a whole number"},
        BadPcd{"SizeWord", ascii("SIZE", "4 four 4"), "SIZE", "'four' is not a whole number"},
        BadPcd{"SizeOfTwo", ascii("SIZE", "4 4"), "SIZE", "a value for each field"},
        BadPcd{"SizeOfFour", ascii("SIZE", "4 4 4 4"), "SIZE", "a value for each field"},
        BadPcd{"TypeX", ascii("TYPE", "F X F"), "TYPE", "'X' is not F, I or U"},
        BadPcd{"TypeLowerCase", ascii("TYPE", "f f f"), "TYPE", "'f' is not F, I or U"},
        BadPcd{"TypeLong", ascii("TYPE", "F FLOAT F"), "TYPE", "'FLOAT' is not"},
        BadPcd{"TypeOfOne", ascii("TYPE", "F"), "TYPE", "a value for each field"},
        BadPcd{"FloatOfTwoBytes", ascii("SIZE", "4 2 4"), "SIZE", "of a float must be 4 or 8"},
        BadPcd{"CountZero", ascii("COUNT", "1 0 1"), "COUNT", "0 is not in"},
        BadPcd{"CountNegative", ascii("COUNT", "1 -1 1"), "COUNT", "-1 is not in"},
        BadPcd{"CountHuge", ascii("COUNT", "1 1 2147483647"), "COUNT", "2147483647 is not in"},
        BadPcd{"CountThatWraps", ascii("COUNT", "4096 1 4096"), "COUNT", "more than 4096 bytes"},
        BadPcd{"CountOfTwo", ascii("COUNT", "1 1"), "COUNT", "a value for each field"},
        BadPcd{"NoZ", ascii("FIELDS", "x y depth"), "FIELDS", "no field z"},
        BadPcd{"NoX", ascii("FIELDS", "X y z"), "FIELDS", "no field x"},
        BadPcd{"SeveralY",
               test::pcdHeader({{"COUNT", "1 2 1"}}) + "0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n",
               "COUNT", "y is not a single number"},
        BadPcd{"PaddingOnly", test::compressedPcd({{"FIELDS", "_ _ _"}}), "FIELDS", "padding"},
        BadPcd{"FieldTwice", ascii("FIELDS", "x y y"), "FIELDS", "'y' occurs twice"},
        BadPcd{"SizeTwice", "VERSION 0.7\nSIZE 4\nSIZE 4\nDATA ascii\n", "SIZE", "occurs twice"},
        BadPcd{"ThousandFields",
               [] {
                 std::string names, ones;
                 for (int i = 0; i < 1000; ++i) names += "f ", ones += "1 ";
                 return test::asciiPcd({{"FIELDS", names}, {"SIZE", ones}, {"TYPE", ones}, {"COUNT", ones}});
               }(),
               "FIELDS", "more than 256"}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Size, BadPcdTest,
    ::testing::Values(
        BadPcd{"HeightOne", test::asciiPcd({{"WIDTH", "6"}, {"HEIGHT", "1"}}), "HEIGHT", "not organized"},
        BadPcd{"HeightZero", ascii("HEIGHT", "0"), "HEIGHT", "0 is not in"},
        BadPcd{"WidthZero", ascii("WIDTH", "0"), "WIDTH", "0 is not in"},
        BadPcd{"WidthNegative", ascii("WIDTH", "-3"), "WIDTH", "-3 is not in"},
        BadPcd{"WidthFraction", ascii("WIDTH", "3.5"), "WIDTH", "is not a whole number"},
        BadPcd{"WidthHexadecimal", ascii("WIDTH", "0x3"), "WIDTH", "is not a whole number"},
        BadPcd{"WidthTwoValues", ascii("WIDTH", "3 3"), "WIDTH", "needs one value"},
        BadPcd{"WidthTooLarge", ascii("WIDTH", "16385"), "WIDTH", "16384"},
        BadPcd{"HeightTooLarge", ascii("HEIGHT", "16385"), "HEIGHT", "16384"},
        BadPcd{"WidthTimesHeightWraps", test::asciiPcd({{"WIDTH", "65536"}, {"HEIGHT", "65537"}}), "HEIGHT", "16384"},
        BadPcd{"TooManyPoints", test::asciiPcd({{"WIDTH", "16384"}, {"HEIGHT", "16384"}}), "WIDTH", "64000000"},
        BadPcd{"WidthBeyondLong", ascii("WIDTH", "99999999999999999999999"), "WIDTH", "is not a whole number"},
        BadPcd{"PointsTooFew", ascii("POINTS", "5"), "POINTS", "is not WIDTH x HEIGHT"},
        BadPcd{"PointsZero", ascii("POINTS", "0"), "POINTS", "is not WIDTH x HEIGHT"},
        BadPcd{"PointsHuge", ascii("POINTS", "18446744073709551615"), "POINTS", ""},
        BadPcd{"PointsNegative", ascii("POINTS", "-6"), "POINTS", "-6 is not in"},
        BadPcd{"PointsMoreThanTheFileHolds",
               test::binaryPcd({{"WIDTH", "8000"}, {"HEIGHT", "8000"}, {"POINTS", "64000000"}}), "DATA", "is shorter"}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Ascii, BadPcdTest,
    ::testing::Values(
        BadPcd{"UnknownKind", ascii("DATA", "text"), "DATA", "'text' is not ascii"},
        BadPcd{"NoRows", rows(""), "DATA", "shorter"},
        BadPcd{"TooFewRows", rows(test::pcdRows(5)), "DATA", "ends at point 5"},
        BadPcd{"TooManyRows", rows(test::pcdRows(7)), "DATA", "more rows"},
        BadPcd{"TooFewValues", rows("1 2 3\n1 2\n" + test::pcdRows(6)), "DATA", "too few values at point 1"},
        BadPcd{"TooManyValues", rows("1 2 3 4\n" + test::pcdRows(5)), "DATA", "too many values at point 0"},
        BadPcd{"Word", rows("1 2 abc\n" + test::pcdRows(5)), "DATA", "'abc' at point 0 is not a number"},
        BadPcd{"NumberAndWord", rows("1 2 3m\n" + test::pcdRows(5)), "DATA", "'3m' at point 0"},
        BadPcd{"DecimalComma", rows("1,5 2 3\n" + test::pcdRows(5)), "DATA", "'1,5' at point 0"},
        BadPcd{"TwoSigns", rows("+-1 2 3\n" + test::pcdRows(5)), "DATA", "'+-1' at point 0"},
        BadPcd{"SignAlone", rows("- 2 3\n" + test::pcdRows(5)), "DATA", "'-' at point 0"},
        BadPcd{"BeyondDouble", rows("1e999 2 3\n" + test::pcdRows(5)), "DATA", "'1e999' at point 0"},
        BadPcd{"ZeroBytes", rows(std::string(60, '\0')), "DATA", "is not a number"}),
    kName);

std::string compressed(std::uint32_t packed_size, std::uint32_t size, const std::string& packed) {
  std::string bytes = test::pcdHeader({{"DATA", "binary_compressed"}});
  test::append(bytes, packed_size);
  test::append(bytes, size);
  return bytes + packed;
}

/// 72 bytes of literal runs, followed by what the case is about, with sizes that agree.
std::string packedAs(const std::string& packed) {
  return compressed(static_cast<std::uint32_t>(packed.size()), 72, packed);
}
const std::string kRuns = test::literalLzf(test::binaryFields()).substr(8);

std::string cut(std::string bytes, std::size_t by) {
  return bytes.substr(0, bytes.size() - by);
}

INSTANTIATE_TEST_SUITE_P(
    Binary, BadPcdTest,
    ::testing::Values(
        BadPcd{"NoPayload", test::pcdHeader({{"DATA", "binary"}}), "DATA", "is shorter"},
        BadPcd{"OneByteShort", cut(test::binaryPcd(), 1), "DATA", "is shorter"},
        BadPcd{"CompressedWithoutSizes", test::pcdHeader({{"DATA", "binary_compressed"}}), "DATA",
               "before the compressed sizes"},
        BadPcd{"CompressedWithHalfTheSizes", test::pcdHeader({{"DATA", "binary_compressed"}}) + "1234567", "DATA",
               "before the compressed sizes"},
        BadPcd{"CompressedOneByteShort", cut(test::compressedPcd(), 1), "DATA", "shorter than its compressed"},
        BadPcd{"CompressedSizeHuge", compressed(0xffffffffu, 72, kRuns), "DATA", "shorter than its compressed"},
        BadPcd{"UncompressedSizeTooLarge", compressed(75, 73, kRuns), "DATA", "not WIDTH x HEIGHT"},
        BadPcd{"UncompressedSizeTooSmall", compressed(75, 71, kRuns), "DATA", "not WIDTH x HEIGHT"},
        BadPcd{"UncompressedSizeHuge", compressed(75, 0xffffffffu, kRuns), "DATA", "uncompressed size"},
        BadPcd{"FarMorePointsThanPacked",
               test::compressedPcd({{"WIDTH", "8000"}, {"HEIGHT", "8000"}, {"POINTS", "64000000"}}), "DATA",
               "uncompressed size"},
        BadPcd{"NothingPacked", compressed(0, 72, ""), "DATA", "damaged"},
        BadPcd{"TooLittlePacked", packedAs(kRuns.substr(0, 66)), "DATA", "damaged"},
        BadPcd{"TooMuchPacked", packedAs(kRuns + std::string("\0a", 2)), "DATA", "damaged"},
        BadPcd{"RunBeyondTheEnd", packedAs(std::string("\x1f", 1) + "abc"), "DATA", "damaged"},
        BadPcd{"ReferenceBeforeTheStart", packedAs(std::string("\x20\x00", 2) + kRuns), "DATA", "damaged"},
        BadPcd{"ReferenceTooFarBack", packedAs(std::string("\0a\x20\x01", 4) + kRuns), "DATA", "damaged"},
        BadPcd{"ReferenceCutShort", packedAs(std::string("\0a\x20", 3)), "DATA", "damaged"},
        BadPcd{"LongReferenceCutShort", packedAs(std::string("\0a\xe0", 3)), "DATA", "damaged"},
        BadPcd{"LongReferenceCutShorter", packedAs(std::string("\0a\xe0\x10", 4)), "DATA", "damaged"},
        BadPcd{"ReferenceBeyondTheEnd", packedAs(std::string("\0a\xe0\xff\0", 5)), "DATA", "damaged"}),
    kName);

class BadPcdFileTest : public test::TempFolderTest {};

TEST_F(BadPcdFileTest, MissingFile) {
  test::expectInputError([&] { readOrganizedPcd(path("no.pcd")); }, path("no.pcd"), "file", "does not exist");
}
TEST_F(BadPcdFileTest, FolderInsteadOfFile) {
  test::expectInputError([&] { readOrganizedPcd(folder()); }, folder(), "file", "is a folder");
}
TEST_F(BadPcdFileTest, DeviceInsteadOfFile) {
  test::expectInputError([] { readOrganizedPcd("/dev/zero"); }, "/dev/zero", "file", "regular");
}
TEST_F(BadPcdFileTest, MissingLabelField) {
  const std::string file = write("a.pcd", test::asciiPcd());
  test::expectInputError([&] { readOrganizedPcd(file, "label"); }, file, "FIELDS", "no single field label");
}
TEST_F(BadPcdFileTest, LabelFieldOfSeveralElements) {
  const std::string file =
      write("a.pcd",
            test::binaryPcd({{"FIELDS", "x y z tag"}, {"SIZE", "4 4 4 1"}, {"TYPE", "F F F U"}, {"COUNT", "1 1 1 2"}}) +
                std::string(12, '\0'));
  test::expectInputError([&] { readOrganizedPcd(file, "tag"); }, file, "FIELDS", "no single field tag");
}
TEST_F(BadPcdFileTest, CutAnywhere) {
  for (const std::string& whole : {test::asciiPcd(), test::binaryPcd(), test::compressedPcd()})
    for (std::size_t size = 0; size + 3 < whole.size(); ++size) {  // without its last digits an ASCII file is whole
      const std::string file = write("a.pcd", whole.substr(0, size));
      EXPECT_THROW(readOrganizedPcd(file), InputError) << size;
    }
}

}  // namespace
}  // namespace epcc
