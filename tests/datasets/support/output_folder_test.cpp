// SPDX-License-Identifier: BSD-3-Clause
// Folders that are made, are there already, or cannot be made.
#include "datasets/support/output_folder.h"

#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

class OutputFolder : public test::TempFolderTest {};

TEST_F(OutputFolder, FilesThatCannotBeWrittenAreToldBefore) {
  makeOutputFolder(path("a"), {"x.csv", "y.png"});
  EXPECT_TRUE(names("a").empty());
  std::filesystem::create_directory(path("a/y.png"));
  test::expectError<OutputError>(
      [&] {
        makeOutputFolder(path("a"), {"x.csv", "y.png"});
      },
      path("a/y.png"), "file", "is a folder");
}

TEST_F(OutputFolder, IsMadeWithThoseAboveIt) {
  makeOutputFolder(path("a/b/c"));
  EXPECT_TRUE(std::filesystem::is_directory(path("a/b/c")));
}

TEST_F(OutputFolder, MayBeThereAlready) {
  write("a/file", "kept");
  makeOutputFolder(path("a"));
  makeOutputFolder(path("a/"));
  EXPECT_EQ(read("a/file"), "kept");
}

TEST_F(OutputFolder, InPlaceOfAFileIsAnError) {
  const std::string file = write("file", "kept");
  test::expectError<OutputError>([&] { makeOutputFolder(file); }, file, "folder", "cannot be made");
  test::expectError<OutputError>([&] { makeOutputFolder(file + "/below"); }, file + "/below", "folder",
                                 "cannot be made");
  EXPECT_EQ(read("file"), "kept");
}

}  // namespace
}  // namespace epcc
