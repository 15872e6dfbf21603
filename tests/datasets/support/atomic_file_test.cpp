// SPDX-License-Identifier: BSD-3-Clause
// Files are written through links and never in the place of one; what processes that were killed while writing have
// left is removed, and nothing else.
#include "datasets/support/atomic_file.h"

#include <filesystem>

#include "datasets/support/input_error.h"
#include "tests/support/expect_errors.h"
#include "tests/support/temp_folder.h"

namespace epcc::test {
namespace {

class WrittenFile : public TempFolderTest {
 protected:
  void link(const std::string& target, const std::string& name) const {
    std::filesystem::create_symlink(target, path(name));
  }
  void refuses(const std::string& name, const std::string& field, const std::string& words) const {
    expectError<OutputError>([&] { writeTextFile(path(name), "new"); }, path(name), field, words);
  }
};

TEST_F(WrittenFile, IsTheOneBehindALink) {
  write("below/file", "old");
  link("below/file", "link");
  link("below/none", "dangling");
  for (const char* name : {"link", "dangling"}) {
    writeTextFile(path(name), name);
    EXPECT_TRUE(std::filesystem::is_symlink(path(name))) << name;
  }
  EXPECT_EQ(read("below/file"), "link");
  EXPECT_EQ(read("below/none"), "dangling");
  EXPECT_EQ(names(), (std::vector<std::string>{"below", "dangling", "link"}));
  EXPECT_EQ(names("below"), (std::vector<std::string>{"file", "none"}));
}

TEST_F(WrittenFile, IsNoStreamNoDeviceAndNoFolder) {
  link("/proc/self/fd/1", "stream");
  link("stream", "to_stream");
  link("/dev/null", "device");
  link("circle", "circle");
  link("nowhere/file", "lost");
  for (const char* name : {"stream", "to_stream", "device", "circle"}) refuses(name, "file", "is not a regular file");
  refuses("lost", "folder", "does not exist");
  refuses("", "file", "is a folder");
  EXPECT_EQ(names(), (std::vector<std::string>{"circle", "device", "lost", "stream", "to_stream"}));
}

class Temporaries : public TempFolderTest {
 protected:
  void SetUp() override {
    TempFolderTest::SetUp();
    for (const char* file : {".epcc-1-2.tmp", "report.tmp", ".epcc-lock", "below/.epcc-3.tmp", "below/result.json"})
      write(file, "x");
  }
};

TEST_F(Temporaries, AreRemovedInTheFolder) {
  removeTemporaries(folder(), false);
  EXPECT_EQ(names(), (std::vector<std::string>{".epcc-lock", "below", "report.tmp"}));
  EXPECT_EQ(names("below"), (std::vector<std::string>{".epcc-3.tmp", "result.json"}));
}

TEST_F(Temporaries, AreRemovedBelowTooIfAsked) {
  removeTemporaries(folder(), true);
  EXPECT_EQ(names("below"), std::vector<std::string>{"result.json"});
}

TEST_F(Temporaries, NoFolderIsNoError) {
  removeTemporaries(path("nowhere"), true);
  EXPECT_EQ(names().size(), 4U);
}

}  // namespace
}  // namespace epcc::test
