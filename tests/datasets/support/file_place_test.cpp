// SPDX-License-Identifier: BSD-3-Clause
// The same file has the same place, by whatever links and names it is reached.
#include "datasets/support/file_place.h"

#include "tests/support/temp_folder.h"

namespace epcc::test {
namespace {

namespace fs = std::filesystem;

class FilePlace : public TempFolderTest {
 protected:
  void SetUp() override {
    TempFolderTest::SetUp();
    write("below/file", "x");
    fs::create_directory_symlink("below", path("folder"));
    fs::create_symlink("below/file", path("link"));
    fs::create_symlink("link", path("chain"));
  }
};

TEST_F(FilePlace, IsTheSameForTheSameFile) {
  const fs::path file = fs::canonical(path("below/file")), none = file.parent_path() / "none";
  for (const char* name : {"below/file", "below/../below/./file", "folder/file", "link", "chain"})
    EXPECT_EQ(filePlace(path(name)), file) << name;
  for (const char* name : {"below/none", "folder/none"}) EXPECT_EQ(filePlace(path(name)), none) << name;
  EXPECT_EQ(filePlace(path("folder/")), filePlace(path("below")));
  EXPECT_EQ(filePlace("."), fs::current_path());
  EXPECT_EQ(filePlace(""), "");
}

TEST_F(FilePlace, FoldersHoldWhatIsBelowThem) {
  EXPECT_TRUE(isWithin(path("link"), path("folder")));
  EXPECT_TRUE(isWithin(path("below/a/b"), path("below/")));
  EXPECT_TRUE(isWithin(path("below"), path("folder")));
  EXPECT_FALSE(isWithin(path("below2/file"), path("below")));
  EXPECT_FALSE(isWithin(path("below/file"), path("below/a")));
}

}  // namespace
}  // namespace epcc::test
