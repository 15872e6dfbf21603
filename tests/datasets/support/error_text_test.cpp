// SPDX-License-Identifier: BSD-3-Clause
// An error is one line whatever the path and the file contain.
#include <gtest/gtest.h>

#include "datasets/files/camera_json.h"
#include "datasets/files/organized_pcd.h"
#include "datasets/files/png_io.h"
#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

using ErrorTextTest = test::TempFolderTest;

TEST(PrintableTest, KeepsTextAndUmlauts) {
  EXPECT_EQ(printable("a b-\xc3\xbc\xe2\x82\xac"), "a b-\xc3\xbc\xe2\x82\xac");
}
TEST(PrintableTest, ReplacesControlCharacters) {
  EXPECT_EQ(printable(std::string("a\nb\r\t\x1b[31m\0\x7f", 12)), "a?b???[31m??");
}
TEST(PrintableTest, ReplacesControlCharactersInUtf8) {
  EXPECT_EQ(printable("\xc2\x85|\xc2\x9b|\xc2\xa0"), "?|?|\xc2\xa0");
}
TEST(PrintableTest, ReplacesUnicodeLineSeparators) {
  EXPECT_EQ(printable("\xe2\x80\xa8|\xe2\x80\xa9|\xe2\x80\xa6"), "?|?|\xe2\x80\xa6");
}
TEST(PrintableTest, ReplacesMarksOfTheWritingDirection) {
  EXPECT_EQ(printable("\xe2\x80\xae|\xe2\x81\xa6|\xe2\x80\x8f"), "?|?|?");
}
TEST(PrintableTest, ReplacesBytesThatAreNoUtf8) {
  EXPECT_EQ(printable("\xff"), "?");
  EXPECT_EQ(printable("\xc3"), "?");                 // ends early
  EXPECT_EQ(printable("\xe2|\xa1"), "?|?");          // broken off
  EXPECT_EQ(printable("\xc0\xaf"), "??");            // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), "???");       // a surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "????");  // beyond Unicode
  EXPECT_EQ(printable("\xf0\x9f\x98\x80"), "\xf0\x9f\x98\x80");
}
TEST(PrintableTest, CutsBetweenCharacters) {
  EXPECT_EQ(printable("\xc3\xbc\xc3\xbc", 3), "\xc3\xbc...");
  EXPECT_EQ(printable("\xc3\xbc\xc3\xbc", 4), "\xc3\xbc\xc3\xbc");
}
TEST(PrintableTest, CutsLongTexts) {
  EXPECT_EQ(printable("abcdef", 3), "abc...");
  EXPECT_EQ(printable("abc", 3), "abc");
}

TEST(InputErrorTest, NamesFileAndField) {
  const InputError error("dir/a.json", "fx", "is missing");
  EXPECT_STREQ(error.what(), "dir/a.json: fx: is missing");
  EXPECT_EQ(error.file(), "dir/a.json");
  EXPECT_EQ(error.field(), "fx");
}
TEST(OutputErrorTest, NamesFileAndField) {
  EXPECT_STREQ(OutputError("a.png", "file", "is a folder").what(), "a.png: file: is a folder");
}
TEST(InputErrorTest, IsOneLineWhateverItIsMadeOf) {
  test::expectOneLine(InputError("a\nb", "c\rd", "e\n" + std::string(100000, 'x')).what());
  test::expectOneLine(OutputError("a\nb", "c\rd", std::string(100000, '\n')).what());
}

TEST_F(ErrorTextTest, MissingFileWithLineBreakInItsName) {
  const std::string file = path("a\nb\x1b[2J.png");
  test::expectInputError([&] { readGray16(file); }, file, "file", "does not exist");
  test::expectInputError([&] { readCameraJson(file); }, file, "file", "does not exist");
  test::expectInputError([&] { readOrganizedPcd(file); }, file, "file", "does not exist");
}

TEST_F(ErrorTextTest, BadFileWithLineBreakInItsName) {
  const std::string file = write("a\nb.json", "{\"width\": \"x\"}");
  test::expectInputError([&] { readCameraJson(file); }, file, "width", "is not a number");
}

TEST_F(ErrorTextTest, WriterWithLineBreakInTheName) {
  const std::string file = path("no\nfolder/a.png");
  test::expectError<OutputError>([&] { writeGray16(file, LabelImage(1, 1)); }, file, "folder", "does not exist");
}

TEST_F(ErrorTextTest, JsonWithControlCharacters) {
  const std::string file = write("a.json", "{\"width\": \"\x1b[31m\n\n\"}");
  test::expectInputError([&] { readCameraJson(file); }, file, "JSON", "");
}

TEST_F(ErrorTextTest, PcdHeaderWithControlCharacters) {
  const std::string file = write("a.pcd", "VERSION 0.7\nFIELDS x\x1b[2J\nSIZE \x1b[31m\x07\nTYPE F\nDATA ascii\n");
  test::expectInputError([&] { readOrganizedPcd(file); }, file, "SIZE", "[31m");
}

TEST_F(ErrorTextTest, PcdHeaderWithALongWord) {
  const std::string file =
      write("a.pcd", "VERSION 0.7\nFIELDS x\nSIZE " + std::string(60000, '9') + "\nTYPE F\nDATA ascii\n");
  test::expectInputError([&] { readOrganizedPcd(file); }, file, "SIZE", "999");
}

TEST_F(ErrorTextTest, PcdKeyWithControlCharactersIsNotRepeated) {
  const std::string file = write("a.pcd", "VERSION 0.7\n\x1b[2J 1\n\x1b[2J 1\nDATA ascii\n");
  test::expectInputError([&] { readOrganizedPcd(file); }, file, "?[2J", "occurs twice");
}

}  // namespace
}  // namespace epcc
