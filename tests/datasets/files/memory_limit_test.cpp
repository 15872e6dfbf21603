// SPDX-License-Identifier: BSD-3-Clause
// A file within the limits of size but not of the memory at hand is an InputError like any other.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "datasets/files/organized_pcd.h"
#include "datasets/files/png_io.h"
#include "tests/support/expect_errors.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EPCC_NEED_ADDRESS_LIMIT() GTEST_SKIP() << "a sanitizer needs more address space than the test leaves"
#else
#define EPCC_NEED_ADDRESS_LIMIT()
#endif

namespace epcc {
namespace {

constexpr const char* kReason = "needs more memory than there is";

/// The process may take this much more address space while this lives.
class AddressLimit {
 public:
  explicit AddressLimit(std::uint64_t more) {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    ::getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    limit.rlim_cur = pages * 4096 + more;
    ok_ = pages > 0 && ::setrlimit(RLIMIT_AS, &limit) == 0;
  }
  AddressLimit(const AddressLimit&) = delete;
  AddressLimit& operator=(const AddressLimit&) = delete;
  ~AddressLimit() { ::setrlimit(RLIMIT_AS, &before_); }
  bool ok() const { return ok_; }

 private:
  rlimit before_{};
  bool ok_ = false;
};

class MemoryLimitTest : public test::TempFolderTest {
 protected:
  void refused(const std::string& file, const std::function<void()>& read) const {
    const AddressLimit limit(std::uint64_t{48} << 20);
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
