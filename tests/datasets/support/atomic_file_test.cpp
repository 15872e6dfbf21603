// SPDX-License-Identifier: BSD-3-Clause
// No file is written in the place of a link; what processes that were killed while writing have left is removed, and
// nothing else.
#include "datasets/support/atomic_file.h"

#include <filesystem>

#include "datasets/support/input_error.h"
#include "tests/support/expect_errors.h"
#include "tests/support/temp_folder.h"

namespace epcc::test {
namespace {

class OutputFile : public TempFolderTest {
 protected:
  void link(const std::string& target, const std::string& name) const {
    std::filesystem::create_symlink(target, path(name));
  }
  void refuses(const std::string& name, const std::string& field, const std::string& words) const {
    expectError<OutputError>([&] { writeTextFile(path(name), "new"); }, path(name), field, words);
  }
};

TEST_F(OutputFile, IsNoLinkWhateverItStandsFor) {
  write("below/file", "an input");
  link("below/file", "file");
  link("below/none", "dangling");
  link("/proc/self/fd/1", "stream");  // as /dev/stdout
  link("circle", "circle");
  for (const char* name : {"file", "dangling", "stream", "circle"}) {
    refuses(name, "file", "is a symbolic link");
    EXPECT_TRUE(std::filesystem::is_symlink(path(name))) << name;
  }
  EXPECT_EQ(read("below/file"), "an input");
  EXPECT_EQ(names("below"), std::vector<std::string>{"file"});
}

TEST_F(OutputFile, IsInAFolderThatMayBeALink) {
  std::filesystem::create_directory(path("below"));
  link("below", "folder");
  link("nowhere", "lost");
  writeTextFile(path("folder/file"), "new");
  EXPECT_EQ(read("below/file"), "new");
  refuses("lost/file", "folder", "does not exist");
  refuses("folder", "file", "is a symbolic link");
  refuses("below", "file", "is a folder");
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
