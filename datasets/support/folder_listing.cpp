// SPDX-License-Identifier: BSD-3-Clause
// Two comparisons of names, natural order and endings in either case, and the listings that use them.
#include "datasets/support/folder_listing.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "datasets/support/file_place.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace fs = std::filesystem;

namespace {

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The number that starts at `at`, without leading zeros; `at` moves behind it.
std::string takeDigits(const std::string& text, std::size_t& at) {
  std::size_t end = at;
  while (end < text.size() && isDigit(text[end])) ++end;
  while (at + 1 < end && text[at] == '0') ++at;
  const std::string digits = text.substr(at, end - at);
  at = end;
  return digits;
}

/// "_depth.png" -> "_depth.PNG"
std::string withExtensionInCapitals(std::string ending) {
  const auto extension = ending.begin() + static_cast<std::ptrdiff_t>(std::min(ending.rfind('.'), ending.size()));
  std::transform(extension, ending.end(), extension,
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return ending;
}

}  // namespace

bool hasEnding(const std::string& file, const std::string& ending) {
  if (file.size() <= ending.size()) return false;
  const std::string last = file.substr(file.size() - ending.size());
  return last == ending || last == withExtensionInCapitals(ending);
}

bool naturallyBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string left = takeDigits(a, i), right = takeDigits(b, j);
      if (left.size() != right.size()) return left.size() < right.size();
      if (left != right) return left < right;
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
    }
  }
  if (i < a.size() || j < b.size()) return j < b.size();
  return a < b;  // "01" and "1"
}

std::vector<std::string> filesEndingIn(const std::string& folder, const std::string& ending) {
  std::error_code code;
  fs::directory_iterator entries(folder, code);
  if (code) throw InputError(folder, "folder", code.message());
  std::vector<std::string> names;
  for (; !code && entries != fs::directory_iterator(); entries.increment(code)) {
    std::string file = entries->path().filename().string();
    if (!hasEnding(file, ending)) continue;
    file.resize(file.size() - ending.size());
    names.push_back(std::move(file));
  }
  if (code) throw InputError(folder, "folder", code.message());
  std::sort(names.begin(), names.end(), naturallyBefore);
  names.erase(std::unique(names.begin(), names.end()), names.end());  // the same name with both endings
  return names;
}

std::string anyFileEndingIn(const std::string& folder, const std::string& ending) {
  std::error_code code;
  fs::directory_iterator entries(folder, code);
  for (; !code && entries != fs::directory_iterator(); entries.increment(code))
    if (hasEnding(entries->path().filename().string(), ending)) return entries->path().string();
  return {};
}

std::string existingFile(const std::string& path) {
  const std::string capitals = withExtensionInCapitals(path);
  std::error_code code;
  return !fs::exists(path, code) && fs::exists(capitals, code) ? capitals : path;
}

std::string folderName(const std::string& folder) {
  const fs::path path = filePlace(folder);
  return path.filename().empty() ? "root" : path.filename().string();
}

}  // namespace epcc
