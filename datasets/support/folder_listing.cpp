// SPDX-License-Identifier: BSD-3-Clause
// Lists folders.
#include "datasets/support/folder_listing.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

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

NameTest withEnding(const std::string& ending) {
  return [ending](const std::string& file) { return file.size() > ending.size() && endsIn(file, ending); };
}

}  // namespace

bool endsIn(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
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

std::vector<std::string> filesThat(const std::string& folder, const NameTest& pass) {
  std::error_code code;
  fs::directory_iterator entries(folder, code);
  if (code) throw InputError(folder, "folder", code.message());
  std::vector<std::string> names;
  for (; entries != fs::directory_iterator(); entries.increment(code)) {
    std::string file = entries->path().filename().string();
    if (pass(file)) names.push_back(std::move(file));
  }
  if (code) throw InputError(folder, "folder", code.message());
  std::sort(names.begin(), names.end(), naturallyBefore);
  return names;
}

std::vector<std::string> filesEndingIn(const std::string& folder, const std::string& ending) {
  std::vector<std::string> names = filesThat(folder, withEnding(ending));
  for (std::string& name : names) name.resize(name.size() - ending.size());
  return names;
}

std::string anyFileThat(const std::string& folder, const NameTest& pass) {
  std::error_code code;
  fs::directory_iterator entries(folder, code);
  if (code) return {};
  for (; !code && entries != fs::directory_iterator(); entries.increment(code))
    if (pass(entries->path().filename().string())) return entries->path().string();
  return {};
}

std::string anyFileEndingIn(const std::string& folder, const std::string& ending) {
  return anyFileThat(folder, withEnding(ending));
}

std::string folderName(const std::string& folder) {
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(folder), error);
  if (error) path = fs::path(folder);
  if (path.filename().empty()) path = path.parent_path();
  return path.filename().empty() ? "root" : path.filename().string();
}

}  // namespace epcc
