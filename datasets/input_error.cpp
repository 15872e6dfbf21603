// SPDX-License-Identifier: BSD-3-Clause
// Composes the single line of an error.
#include "datasets/input_error.h"

#include <filesystem>

namespace epcc {

namespace {
std::string line(const std::string& file, const std::string& field, const std::string& what) {
  return printable(file, 1000) + ": " + printable(field) + ": " + printable(what, 400);
}

/// Bytes of the control character or line separator that starts at `at`, 0 if none does.
std::size_t controlLength(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  if (byte(at) < 0x20 || byte(at) == 0x7f) return 1;
  if (byte(at) == 0xc2 && byte(at + 1) >= 0x80 && byte(at + 1) <= 0x9f) return 2;  // U+0080 to U+009F
  const bool separator = byte(at) == 0xe2 && byte(at + 1) == 0x80 && (byte(at + 2) == 0xa8 || byte(at + 2) == 0xa9);
  return separator ? 3 : 0;  // U+2028, U+2029
}
}  // namespace

std::string printable(const std::string& text, std::size_t longest) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (result.size() >= longest) return result + "...";
    const std::size_t control = controlLength(text, at);
    result += control > 0 ? '?' : text[at];
    at += control > 0 ? control : 1;
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

InputError::InputError(const std::string& file, const std::string& field, const std::string& what)
    : std::runtime_error(line(file, field, what)), file_(file), field_(field) {}

OutputError::OutputError(const std::string& file, const std::string& field, const std::string& what)
    : std::runtime_error(line(file, field, what)) {}

}  // namespace epcc
