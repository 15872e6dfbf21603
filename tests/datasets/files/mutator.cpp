// SPDX-License-Identifier: BSD-3-Clause
// The kinds of damage.
#include "tests/datasets/files/mutator.h"

#include <algorithm>
#include <cctype>

namespace epcc::test {

std::string Mutator::operator()(std::string bytes) {
  for (std::size_t i = 1 + below(4); i > 0; --i) damage(bytes);
  return bytes;
}

void Mutator::damage(std::string& bytes) {
  if (bytes.empty()) {
    bytes += static_cast<char>(below(256));
    return;
  }
  const std::size_t at = below(bytes.size());
  const std::size_t length = 1 + below(std::min<std::size_t>(16, bytes.size() - at));
  switch (below(10)) {
    case 0:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      break;
    case 1:
      bytes[at] = static_cast<char>(below(256));
      break;
    case 2: {
      const char extremes[] = {'\0', '\x7f', '\x80', '\xff', '\n', ' '};
      bytes.replace(at, length, length, extremes[below(sizeof extremes)]);
      break;
    }
    case 3:
      bytes.resize(at);
      break;
    case 4:
      for (std::size_t i = 0; i < length; ++i)
        bytes.insert(bytes.begin() + static_cast<long>(at), static_cast<char>(below(256)));
      break;
    case 5:
      bytes.insert(below(bytes.size()), bytes.substr(at, length * (1 + below(8))));
      break;
    case 6:
      bytes.erase(at, length);
      break;
    case 7:
      replaceWord(bytes);
      break;
    default:
      replaceNumber(bytes);
  }
}

/// A number in the text, from a random place on, becomes another one.
void Mutator::replaceNumber(std::string& bytes) {
  static const char* const kNumbers[] = {
      "0",           "-1",    "1",     "2",     "3",          "8",          "255",
      "4096",        "16384", "16385", "65537", "2147483647", "4294967295", "4294967296",
      "99999999999", "1e999", "nan",   "-0.0",  "1e-320",     "0x10",       "18446744073709551616"};
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto start = std::find_if(bytes.begin() + static_cast<long>(below(bytes.size())), bytes.end(), is_digit);
  const auto end = std::find_if_not(start, bytes.end(), is_digit);
  if (start != end) bytes.replace(start, end, kNumbers[below(std::size(kNumbers))]);
}

/// A word changes places with another one.
void Mutator::replaceWord(std::string& bytes) {
  static const char* const kWords[] = {"",      "F",    "U",         "X",      "ascii", "binary", "binary_compressed",
                                       "x",     "_",    "DATA",      "POINTS", "null",  "true",   "[",
                                       "\"a\"", "IDAT", "{\"a\":1}", "IEND",   "\r\n",  "tRNS"};
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  const auto start = std::find_if(bytes.begin() + static_cast<long>(below(bytes.size())), bytes.end(), is_letter);
  const auto end = std::find_if_not(start, bytes.end(), is_letter);
  if (start != end) bytes.replace(start, end, kWords[below(std::size(kWords))]);
}

}  // namespace epcc::test
