// SPDX-License-Identifier: BSD-3-Clause
// A folder of its own for each test, and what an error of a reader must look like.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "datasets/input_error.h"

namespace epcc::test {

/// Makes a folder and removes it with all that is in it.
class TempFolder {
 public:
  TempFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "epcc-test-XXXXXX").string();
    if (::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  ~TempFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  std::string path(const std::string& name = "") const { return name.empty() ? path_ : path_ + "/" + name; }

 private:
  std::string path_;
};

class TempFolderTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_FALSE(folder_.path().empty()) << "no folder for temporary files"; }
  std::string path(const std::string& name) const { return folder_.path(name); }
  const std::string folder() const { return folder_.path(); }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  static std::string bytesOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  /// Names of all that is in the folder, hidden files too.
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder()))
      result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  TempFolder folder_;
};

/// One line, nothing that moves a terminal's cursor.
inline void expectOneLine(const std::string& text) {
  EXPECT_TRUE(std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) << text;
  EXPECT_LT(text.size(), 2000u);
}

/// `action` throws an Error whose line is "FILE: FIELD: ... PART ...".
template <typename Error, typename Action>
void expectError(const Action& action, const std::string& file, const std::string& field, const std::string& part) {
  try {
    action();
    ADD_FAILURE() << "no error, expected " << field << ": " << part;
  } catch (const Error& error) {
    const std::string what = error.what();
    const std::string start = printable(file, 1000) + ": " + field + ": ";
    EXPECT_EQ(what.substr(0, start.size()), start);
    EXPECT_NE(what.find(part, std::min(what.size(), start.size())), std::string::npos) << what;
    expectOneLine(what);
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another error: " << error.what();
  }
}

template <typename Action>
void expectInputError(const Action& action, const std::string& file, const std::string& field,
                      const std::string& part) {
  expectError<InputError>(action, file, field, part);
}

}  // namespace epcc::test
