// SPDX-License-Identifier: BSD-3-Clause
// Composes the single line of an error.
#include "datasets/input_error.h"

namespace epcc {

namespace {
std::string line(const std::string& file, const std::string& field, const std::string& what) {
  return printable(file, 1000) + ": " + printable(field) + ": " + printable(what, 400);
}
}  // namespace

std::string printable(const std::string& text, std::size_t longest) {
  std::string result;
  for (const char c : text) {
    if (result.size() >= longest) return result + "...";
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code == 0x7f ? '?' : c;
  }
  return result;
}

InputError::InputError(const std::string& file, const std::string& field, const std::string& what)
    : std::runtime_error(line(file, field, what)), file_(file), field_(field) {}

OutputError::OutputError(const std::string& file, const std::string& field, const std::string& what)
    : std::runtime_error(line(file, field, what)) {}

}  // namespace epcc
