// SPDX-License-Identifier: BSD-3-Clause
// The two errors of the file readers and writers: one clear line naming file and field; the check all readers begin
// with.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace epcc {

/// Text fit for one line of a terminal, in valid UTF-8: control characters (ASCII and C1), line separators, marks of
/// the writing direction and bytes that are no UTF-8 become '?'; texts of more than `max_bytes` bytes are cut between
/// characters.
std::string printable(const std::string& text, std::size_t max_bytes = 200);

/// A file that cannot be used. what() is "FILE: FIELD: WHAT", always a single line.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, const std::string& field, const std::string& what);
  const std::string& file() const { return file_; }
  const std::string& field() const { return field_; }

 private:
  std::string file_;
  std::string field_;
};

/// Size of an input file in bytes. InputError if there is none, it is a folder, a device or empty.
std::uintmax_t inputFileSize(const std::string& path);
/// For the end of a text that was `size` bytes long when it was opened: InputError if it was cut off meanwhile, which
/// no number that it ends with tells.
void requireNotCutOff(const std::string& path, std::uintmax_t size);

/// A file that cannot be written. what() is "FILE: FIELD: WHAT", always a single line.
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& file, const std::string& field, const std::string& what);
  /// The what() of another process's.
  explicit OutputError(const std::string& line) : std::runtime_error(line) {}
};

}  // namespace epcc
