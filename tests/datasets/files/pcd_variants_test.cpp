// SPDX-License-Identifier: BSD-3-Clause
// PCD files of other programs that PCL reads: without VERSION, with integer coordinates, with NaN in Microsoft's words.
#include <gtest/gtest.h>

#include <cmath>

#include "datasets/files/organized_pcd.h"
#include "tests/datasets/files/pcd_text.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

class PcdVariants : public test::TempFolderTest {
 protected:
  OrganizedCloud read(const std::string& bytes) const { return readOrganizedPcd(write("a.pcd", bytes)); }
  void expectPoints(const OrganizedCloud& cloud) const { EXPECT_EQ(cloud.xyz, read(test::asciiPcd()).xyz); }
};

TEST_F(PcdVariants, NaNAsMicrosoftPrintsIt) {
  const OrganizedCloud cloud =
      read(test::pcdHeader() + "-1.#IND 1.#QNAN -1.#IND0000\n1.#INF -1.#INF00 1.#SNAN\n-nan(ind) nan 1\n2 3 4\n" +
           "0 0 0\n0 0 0\n");
  for (std::size_t i = 0; i < 8; ++i) EXPECT_TRUE(std::isnan(cloud.xyz[i])) << i;
  EXPECT_EQ(cloud.xyz[8], 1.0f);
  EXPECT_EQ(cloud.xyz[11], 4.0f);
  for (const char* word : {"1.#", "1.#IND1", "2.#IND", "--1.#IND", "1.#NAN", "#IND"})
    EXPECT_THROW(read(test::pcdHeader() + word + " 0 0\n" + test::pcdRows(5)), InputError) << word;
}

TEST_F(PcdVariants, HeaderWithoutVersion) {
  expectPoints(read(test::asciiPcd({{"VERSION", "-"}})));
  expectPoints(read(test::binaryPcd({{"VERSION", "-"}})));
  expectPoints(read(test::compressedPcd({{"VERSION", ""}})));
}

TEST_F(PcdVariants, IntegerCoordinatesAreTakenAsTheyAre) {
  const test::HeaderLines header = {{"SIZE", "2 4 1"}, {"TYPE", "I I U"}, {"DATA", "binary"}};
  std::string points;
  for (int i = 0; i < 6; ++i) {
    test::append(points, static_cast<std::int16_t>(-1000 * i));
    test::append(points, static_cast<std::int32_t>(70000 * i));
    test::append(points, static_cast<std::uint8_t>(40 * i));
  }
  const OrganizedCloud cloud = read(test::pcdHeader(header) + points);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(cloud.xyz[3 * i], -1000.0f * static_cast<float>(i));
    EXPECT_EQ(cloud.xyz[3 * i + 1], 70000.0f * static_cast<float>(i));
    EXPECT_EQ(cloud.xyz[3 * i + 2], 40.0f * static_cast<float>(i));
  }
  const OrganizedCloud text =
      read(test::pcdHeader({{"TYPE", "I I I"}}) + "1 -2 3\n4 5 6\n" + "0 0 0\n0 0 0\n0 0 0\n7 8 9\n");
  EXPECT_EQ(text.xyz[1], -2.0f);
  EXPECT_EQ(text.xyz[17], 9.0f);
}

}  // namespace
}  // namespace epcc
