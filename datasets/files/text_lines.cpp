// SPDX-License-Identifier: BSD-3-Clause
// zlib reads both kinds of files alike.
#include "datasets/files/text_lines.h"

#include <zlib.h>

#include <algorithm>

#include "datasets/support/input_error.h"

namespace epcc {
namespace {

constexpr std::size_t kBlock = 1 << 16;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

struct TextLines::File {
  gzFile handle = nullptr;
  ~File() {
    if (handle != nullptr) gzclose(handle);
  }
};

TextLines::TextLines(const std::string& path) : file_(new File), path_(path), block_(kBlock) {
  size_ = inputFileSize(path);
  file_->handle = gzopen(path.c_str(), "rb");
  if (file_->handle == nullptr) throw InputError(path, "file", "cannot be opened");
}

TextLines::~TextLines() = default;

bool TextLines::fill() {
  const int count = gzread(file_->handle, block_.data(), static_cast<unsigned>(block_.size()));
  int code = Z_OK;
  const char* const words = gzerror(file_->handle, &code);
  // A file that was cut off ends without an error of gzread, but with this code.
  if (count < 0 || (count == 0 && code == Z_BUF_ERROR))
    throw InputError(path_, "line " + std::to_string(number_ + 1),
                     code == Z_BUF_ERROR
                         ? "the packed file ends too early"
                         : "cannot be read, " + std::string(code == Z_ERRNO ? "the file fails" : words));
  if (count == 0) requireNotCutOff(path_, size_);
  at_ = 0;
  end_ = static_cast<std::size_t>(count);
  return count > 0;
}

bool TextLines::next(std::string_view& line) {
  line_.clear();
  for (;;) {
    if (at_ == end_ && !fill()) {
      if (line_.empty()) return false;
      break;
    }
    const char* const from = block_.data() + at_;
    const char* const to = block_.data() + end_;
    const char* const stop = std::find(from, to, '\n');
    line_.append(from, stop);
    if (line_.size() > kMaxTextLine)
      throw InputError(path_, "line " + std::to_string(number_ + 1),
                       "is longer than " + std::to_string(kMaxTextLine / 1024 / 1024) + " MiB");
    at_ = static_cast<std::size_t>(stop - block_.data());
    if (stop == to) continue;
    ++at_;
    break;
  }
  ++number_;
  line = line_;
  if (number_ == 1 && line.substr(0, kByteOrderMark.size()) == kByteOrderMark)
    line.remove_prefix(kByteOrderMark.size());
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return true;
}

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr const char* kSpaces = " \t\r";
  for (std::size_t at = line.find_first_not_of(kSpaces); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kSpaces, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kSpaces, end);
  }
  return words;
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0;;) {
    const std::size_t end = line.find(',', at);
    fields.push_back(trimmed(line.substr(at, end == std::string_view::npos ? end : end - at)));
    if (end == std::string_view::npos) return fields;
    at = end + 1;
  }
}

}  // namespace epcc
