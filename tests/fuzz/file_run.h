// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a file, for readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "datasets/support/input_error.h"
#include "tests/fuzz/require.h"
#include "tests/support/memory_file.h"

namespace epcc::fuzz {

/// Whether `read(path)` takes a file of these bytes. It may refuse it by an InputError that is one line and begins with
/// the file's name; any other exception ends the process.
template <typename Read>
bool takesFile(const std::uint8_t* data, std::size_t size, const Read& read) {
  static const test::MemoryFile file;
  require(file.fill(data, size), "the memory file can be written");
  try {
    read(file.path());
    return true;
  } catch (const InputError& error) {
    const std::string words = error.what();
    requireOneLine(words);
    const std::string start = file.path() + ": ";
    require(words.compare(0, start.size(), start) == 0, "an error names the file");
    require(words.size() > start.size() + error.field().size() + 2, "an error says what is wrong");
    return false;
  }
}

}  // namespace epcc::fuzz
