// SPDX-License-Identifier: BSD-3-Clause
// An error's line is made fit for a terminal, whatever file names and file contents it quotes.
#include "datasets/support/input_error.h"

#include <cstdint>
#include <filesystem>

namespace epcc {

namespace {
std::string line(const std::string& file, const std::string& field, const std::string& what) {
  return printable(file, 1000) + ": " + printable(field) + ": " + printable(what, 400);
}

/// Bytes of the UTF-8 character at `at`, 0 if there is none; `code` is its number.
std::size_t decode(const std::string& text, std::size_t at, std::uint32_t& code) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length == 0 || at + length > text.size()) return 0;
  code = length == 1 ? first : first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[at + i]);
    if ((next & 0xc0U) != 0x80) return 0;
    code = (code << 6) | (next & 0x3fU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  return overlong || code > 0x10ffff || (code >= 0xd800 && code < 0xe000) ? 0 : length;
}

/// Characters that move the cursor, end a line or turn the writing direction.
bool isControl(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x200e && code <= 0x200f) ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string printable(const std::string& text, std::size_t max_bytes) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::uint32_t code = 0;
    const std::size_t length = decode(text, at, code);
    const bool fit = length != 0 && !isControl(code);
    if (result.size() + (fit ? length : 1) > max_bytes) return result + "...";
    result += fit ? text.substr(at, length) : "?";
    at += length == 0 ? 1 : length;
  }
  return result;
}

std::uintmax_t inputFileSize(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found) throw InputError(path, "file", "does not exist");
  if (code) throw InputError(path, "file", code.message());
  if (fs::is_directory(status)) throw InputError(path, "file", "is a folder");
  if (!fs::is_regular_file(status)) throw InputError(path, "file", "is not a regular file");
  const std::uintmax_t size = fs::file_size(path, code);
  if (code) throw InputError(path, "file", code.message());
  if (size == 0) throw InputError(path, "file", "is empty");
  return size;
}

void requireNotCutOff(const std::string& path, std::uintmax_t size) {
  std::error_code code;
  const std::uintmax_t now = std::filesystem::file_size(path, code);
  if (!code && now < size) throw InputError(path, "file", "was cut off while it was read");
}

InputError::InputError(const std::string& file, const std::string& field, const std::string& what)
    : std::runtime_error(line(file, field, what)), file_(file), field_(field) {}

OutputError::OutputError(const std::string& file, const std::string& field, const std::string& what)
    : std::runtime_error(line(file, field, what)) {}

}  // namespace epcc
