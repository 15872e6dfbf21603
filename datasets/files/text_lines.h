// SPDX-License-Identifier: BSD-3-Clause
// The lines of a text file, packed by gzip or not.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace epcc {

/// Longest line that is read, bytes.
constexpr std::size_t kMaxTextLine = 16 * 1024 * 1024;

/// Reads one line after the other. Whether the file is packed is seen from its bytes.
class TextLines {
 public:
  /// InputError if there is no such file, or nothing in it.
  explicit TextLines(const std::string& path);
  ~TextLines();
  TextLines(const TextLines&) = delete;
  TextLines& operator=(const TextLines&) = delete;

  /// The next line without its end, false behind the last. InputError if the file cannot be read or unpacked, was
  /// cut off meanwhile, or the line is too long. The line is good until the next call.
  bool next(std::string_view& line);
  /// Of the last line, from 1.
  long number() const { return number_; }

 private:
  bool fill();

  struct File;
  std::unique_ptr<File> file_;
  std::string path_;
  std::uintmax_t size_ = 0;
  std::string line_;
  std::vector<char> block_;
  std::size_t at_ = 0, end_ = 0;
  long number_ = 0;
};

/// The words of a line, between spaces and tabs, or between commas, without the spaces around them.
std::vector<std::string_view> wordsOf(std::string_view line);
std::vector<std::string_view> fieldsOf(std::string_view line);

}  // namespace epcc
