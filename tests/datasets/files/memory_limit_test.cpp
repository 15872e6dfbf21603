// SPDX-License-Identifier: BSD-3-Clause
// A file within the limits of size but not of the memory at hand is an InputError like any other.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "datasets/files/organized_pcd.h"
#include "datasets/files/png_io.h"
#include "tests/support/address_limit.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

constexpr const char* kReason = "needs more memory than there is";

class MemoryLimitTest : public test::TempFolderTest {
 protected:
  void refused(const std::string& file, const std::function<void()>& read) const {
    const test::AddressLimit limit(std::uint64_t{48} << 20);
    ASSERT_TRUE(limit.ok());
    test::expectInputError(read, file, "file", kReason);
  }
};

TEST_F(MemoryLimitTest, BinaryPcd) {
  EPCC_NEED_ADDRESS_LIMIT();
  const std::string header =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 8000\nHEIGHT 8000\nPOINTS 64000000\n"
      "DATA binary\n";
  const std::string file = write("a.pcd", header);
  std::filesystem::resize_file(file, header.size() + 12u * 64000000u);  // takes no space on the disk
  refused(file, [&] { readOrganizedPcd(file); });
}

TEST_F(MemoryLimitTest, Png) {
  EPCC_NEED_ADDRESS_LIMIT();
  const std::string file = path("a.png");
  writeGray16(file, Image<std::uint16_t>(8000, 8000));
  refused(file, [&] { readGray16(file); });
}

}  // namespace
}  // namespace epcc
