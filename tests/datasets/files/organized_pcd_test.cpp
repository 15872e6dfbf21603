// SPDX-License-Identifier: BSD-3-Clause
// Organized PCD clouds of all three kinds, read right; labelled clouds there and back.
#include "datasets/files/organized_pcd.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/datasets/files/pcd_text.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class OrganizedPcdTest : public test::TempFolderTest {
 protected:
  OrganizedCloud read(const std::string& bytes, const std::string& label = "") const {
    return readOrganizedPcd(write("a.pcd", bytes), label);
  }
  /// The points of test::pcdRows().
  void expectPoints(const OrganizedCloud& cloud) const {
    EXPECT_EQ(cloud.width, 3);
    EXPECT_EQ(cloud.height, 2);
    ASSERT_EQ(cloud.xyz.size(), 18u);
    for (std::size_t i = 0; i < 18; ++i)
      EXPECT_EQ(cloud.xyz[i], static_cast<float>(i / 3) + 0.25f * static_cast<float>(i % 3)) << i;
  }
};

TEST_F(OrganizedPcdTest, Ascii) {
  expectPoints(read(test::asciiPcd()));
}
TEST_F(OrganizedPcdTest, Binary) {
  expectPoints(read(test::binaryPcd()));
}
TEST_F(OrganizedPcdTest, BinaryCompressed) {
  expectPoints(read(test::compressedPcd()));
}

TEST_F(OrganizedPcdTest, CompressedBackReferences) {
  // "abcd" as a literal run, then 68 bytes that repeat it from four bytes back: 7 + 59 and two more in a short one.
  std::string packed = std::string("\x03", 1) + std::string("\x00\x00\x80\x3f", 4);
  packed += std::string("\xe0\x35\x03", 3);  // 7 + 53 + 2 = 62 bytes
  packed += std::string("\x80\x03", 2);      // 4 + 2 = 6 bytes
  std::string bytes = test::pcdHeader({{"DATA", "binary_compressed"}});
  test::append(bytes, static_cast<std::uint32_t>(packed.size()));
  test::append(bytes, std::uint32_t{72});
  const OrganizedCloud cloud = read(bytes + packed);
  for (const float value : cloud.xyz) EXPECT_EQ(value, 1.0f);
}

TEST_F(OrganizedPcdTest, CarriageReturnsAreBlanks) {
  std::string rows = test::pcdRows();
  for (std::size_t at = 0; (at = rows.find('\n', at)) != std::string::npos; at += 2) rows.replace(at, 1, "\r\n");
  expectPoints(read(test::pcdHeader({}, "\r\n") + rows));
  expectPoints(read(test::pcdHeader({{"DATA", "binary"}}, "\r\n") + test::binaryPoints()));
}

TEST_F(OrganizedPcdTest, TabsBlankLinesAndNoLineEndAtTheEnd) {
  std::string rows = test::pcdRows();
  rows.replace(rows.find(' '), 1, " \t ");
  rows.replace(rows.find('\n'), 1, "\n\n  \n");
  rows.pop_back();
  expectPoints(read(test::pcdHeader() + rows));
}

TEST_F(OrganizedPcdTest, CommentsAndUnknownLinesInTheHeader) {
  std::string header = test::pcdHeader();
  header.insert(header.find("WIDTH"), "# a comment\n\nSENSOR something\n");
  expectPoints(read(header + test::pcdRows()));
}

TEST_F(OrganizedPcdTest, LinesThatMayBeMissing) {
  expectPoints(read(test::asciiPcd({{"COUNT", "-"}})));
  expectPoints(read(test::asciiPcd({{"VIEWPOINT", "-"}})));
  expectPoints(read(test::asciiPcd({{"POINTS", "-"}})));
}

TEST_F(OrganizedPcdTest, OddViewpointIsPassedOver) {
  for (const char* viewpoint : {"", "1 2 3", "a b c d e f g", "0 0 0 0 0 0 0", "nan nan nan 1 0 0 0", "1e999"})
    expectPoints(read(test::asciiPcd({{"VIEWPOINT", viewpoint}})));
}

TEST_F(OrganizedPcdTest, OldNameOfTheFields) {
  std::string bytes = test::asciiPcd();
  bytes.replace(bytes.find("FIELDS"), 6, "COLUMNS");
  expectPoints(read(bytes));
}

TEST_F(OrganizedPcdTest, AsciiSpellingsOfNumbers) {
  const OrganizedCloud cloud =
      read(test::pcdHeader() + "nan NaN -nan\n+1.5 -0 .5\n1e-3 1E+2 7.\n0 0 0\n0 0 0\n0 0 0\n");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(cloud.xyz[i])) << i;
  EXPECT_EQ(std::vector<float>(cloud.xyz.begin() + 3, cloud.xyz.begin() + 9),
            (std::vector<float>{1.5f, -0.0f, 0.5f, 1e-3f, 100.0f, 7.0f}));
}

TEST_F(OrganizedPcdTest, InfiniteAndTooLargeCoordinatesAreInvalid) {
  const OrganizedCloud cloud = read(test::pcdHeader() + "inf -inf 1e39\n-1e300 3e38 1\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(std::isnan(cloud.xyz[i])) << i;
  EXPECT_EQ(cloud.xyz[4], 3e38f);
}

TEST_F(OrganizedPcdTest, DoublePrecisionCoordinates) {
  const test::HeaderLines header = {{"SIZE", "8 8 8"}, {"DATA", "binary"}};
  std::string points, fields;
  for (int i = 0; i < 18; ++i) test::append(points, i / 3 + 0.25 * (i % 3));
  for (int i = 0; i < 18; ++i) test::append(fields, i % 6 + 0.25 * (i / 6));
  expectPoints(read(test::pcdHeader(header) + points));
  expectPoints(read(test::pcdHeader({{"SIZE", "8 8 8"}, {"DATA", "binary_compressed"}}) + test::literalLzf(fields)));
}

TEST_F(OrganizedPcdTest, OtherFieldsAroundTheCoordinates) {
  const test::HeaderLines lines = {
      {"FIELDS", "rgb y _ z hist x"}, {"SIZE", "4 4 1 4 2 4"}, {"TYPE", "U F U F I F"}, {"COUNT", "1 1 4 1 3 1"}};
  std::string points, rows;
  for (int i = 0; i < 6; ++i) {
    const float base = static_cast<float>(i);
    test::append(points, std::uint32_t{0xffffffff});
    test::append(points, base + 0.25f);
    test::append(points, std::uint32_t{1});
    test::append(points, base + 0.5f);
    for (int k = 0; k < 3; ++k) test::append(points, std::int16_t{-7});
    test::append(points, base);
    const std::string text = std::to_string(i);
    rows += "9 " + text + ".25 1 2 3 4 " + text + ".5 -7 -7 -7 " + text + "\n";
  }
  test::HeaderLines binary = lines;
  binary.emplace_back("DATA", "binary");
  expectPoints(read(test::pcdHeader(binary) + points));
  expectPoints(read(test::pcdHeader(lines) + rows));
}

TEST_F(OrganizedPcdTest, PaddingIsNotPartOfACompressedPayload) {
  const std::string header = test::pcdHeader({{"FIELDS", "_ x y _ z"},
                                              {"SIZE", "1 4 4 1 4"},
                                              {"TYPE", "U F F U F"},
                                              {"COUNT", "4 1 1 4 1"},
                                              {"DATA", "binary_compressed"}});
  expectPoints(read(header + test::literalLzf(test::binaryFields())));
}

// ---- label fields ----

struct LabelType {
  const char* type;
  int size;
  double largest;  ///< that a float holds exactly
};

template <typename T>
void appendLabel(std::string& bytes, double value) {
  test::append(bytes, static_cast<T>(value));
}

void appendLabel(std::string& bytes, const LabelType& type, double value) {
  const std::string name = type.type + std::to_string(type.size);
  if (name == "U1") appendLabel<std::uint8_t>(bytes, value);
  if (name == "U2") appendLabel<std::uint16_t>(bytes, value);
  if (name == "U4") appendLabel<std::uint32_t>(bytes, value);
  if (name == "U8") appendLabel<std::uint64_t>(bytes, value);
  if (name == "I1") appendLabel<std::int8_t>(bytes, value);
  if (name == "I2") appendLabel<std::int16_t>(bytes, value);
  if (name == "I4") appendLabel<std::int32_t>(bytes, value);
  if (name == "I8") appendLabel<std::int64_t>(bytes, value);
  if (name == "F4") appendLabel<float>(bytes, value);
  if (name == "F8") appendLabel<double>(bytes, value);
}

class PcdLabelTest : public OrganizedPcdTest, public ::testing::WithParamInterface<LabelType> {};

TEST_P(PcdLabelTest, IsReadFromAllThreeKinds) {
  const LabelType& type = GetParam();
  const bool is_signed = *type.type != 'U';
  const std::vector<double> labels = {0, 1, type.largest, is_signed ? -3.0 : 3.0, 100, is_signed ? -type.largest : 7.0};
  const std::string size = " " + std::to_string(type.size);
  test::HeaderLines lines = {{"FIELDS", "x y z tag"},
                             {"SIZE", "4 4 4" + size},
                             {"TYPE", std::string("F F F ") + type.type},
                             {"COUNT", "1 1 1 1"}};
  std::string rows, points, fields = test::binaryFields();
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string text = std::to_string(i);
    rows += text + " " + text + ".25 " + text + ".5 " + std::to_string(static_cast<long>(labels[i])) + "\n";
    points += test::binaryPoints().substr(12 * i, 12);
    appendLabel(points, type, labels[i]);
    appendLabel(fields, type, labels[i]);
  }
  const auto expectLabels = [&](const OrganizedCloud& cloud) {
    expectPoints(cloud);
    EXPECT_EQ(cloud.label, std::vector<float>(labels.begin(), labels.end()));
  };
  expectLabels(read(test::pcdHeader(lines) + rows, "tag"));
  lines.emplace_back("DATA", "binary");
  expectLabels(read(test::pcdHeader(lines) + points, "tag"));
  lines.back().second = "binary_compressed";
  expectLabels(read(test::pcdHeader(lines) + test::literalLzf(fields), "tag"));
  EXPECT_TRUE(read(test::pcdHeader(lines) + test::literalLzf(fields)).label.empty());
}

INSTANTIATE_TEST_SUITE_P(Pcd, PcdLabelTest,
                         ::testing::Values(LabelType{"U", 1, 255}, LabelType{"U", 2, 65535}, LabelType{"U", 4, 1 << 24},
                                           LabelType{"U", 8, 1 << 24}, LabelType{"I", 1, 127}, LabelType{"I", 2, 32767},
                                           LabelType{"I", 4, 1 << 24}, LabelType{"I", 8, 1 << 24},
                                           LabelType{"F", 4, 1 << 24}, LabelType{"F", 8, 1 << 24}),
                         [](const auto& case_info) {
                           return case_info.param.type + std::to_string(case_info.param.size);
                         });

TEST_F(OrganizedPcdTest, CoordinateMayServeAsLabel) {
  const OrganizedCloud cloud = read(test::asciiPcd(), "y");
  expectPoints(cloud);
  EXPECT_EQ(cloud.label[5], 5.25f);
}

// ---- there and back ----

TEST_F(OrganizedPcdTest, LabelledCloudRoundTripWithNaNPoints) {
  const std::vector<float> xyz = {0.1f,  0.2f, 1.0f, kNaN, kNaN, kNaN, -1.5f, 0.0f, 2.5f,
                                  1e-7f, 3e7f, 4.0f, 5.0f, kNaN, 6.0f, 0.0f,  0.0f, 0.0f};
  const std::vector<std::uint32_t> labels = {1, 0, 65535, 2, 16777216, 3};
  writeLabelledPcd(path("a.pcd"), 3, 2, xyz, labels);
  const OrganizedCloud cloud = readOrganizedPcd(path("a.pcd"), "label");
  EXPECT_EQ(cloud.width, 3);
  EXPECT_EQ(cloud.height, 2);
  ASSERT_EQ(cloud.xyz.size(), xyz.size());
  for (std::size_t i = 0; i < xyz.size(); ++i) {
    if (std::isnan(xyz[i]))
      EXPECT_TRUE(std::isnan(cloud.xyz[i])) << i;
    else
      EXPECT_EQ(cloud.xyz[i], xyz[i]) << i;
  }
  EXPECT_EQ(cloud.label, (std::vector<float>{1, 0, 65535, 2, 16777216, 3}));
  EXPECT_EQ(names(), std::vector<std::string>{"a.pcd"});
}

TEST_F(OrganizedPcdTest, LargeCloudsOfNoiseAndOfOneValueRoundTrip) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-10.0f, 10.0f);
  const int width = 333, height = 201;
  std::vector<float> xyz(3u * 333 * 201);
  std::vector<std::uint32_t> labels(333 * 201);
  for (float& value : xyz) value = uniform(random);
  for (auto& label : labels) label = static_cast<std::uint32_t>(random() % 60000);
  for (const bool noise : {true, false}) {
    if (!noise) xyz.assign(xyz.size(), 1.0f), labels.assign(labels.size(), 0);
    writeLabelledPcd(path("a.pcd"), width, height, xyz, labels);
    const OrganizedCloud cloud = readOrganizedPcd(path("a.pcd"), "label");
    EXPECT_EQ(cloud.xyz, xyz);
    EXPECT_EQ(cloud.label, std::vector<float>(labels.begin(), labels.end()));
  }
}

TEST_F(OrganizedPcdTest, SmallestCloudsRoundTrip) {
  for (const auto& [width, height] : {std::pair{1, 2}, {2, 2}, {1, 3}}) {
    const std::vector<float> xyz(3 * static_cast<std::size_t>(width * height), 0.7f);
    writeLabelledPcd(path("a.pcd"), width, height, xyz, std::vector<std::uint32_t>(xyz.size() / 3, 5));
    EXPECT_EQ(readOrganizedPcd(path("a.pcd"), "label").xyz, xyz);
  }
}

}  // namespace
}  // namespace epcc
