// SPDX-License-Identifier: BSD-3-Clause
// Lists in messages.
#pragma once

#include <string>
#include <vector>

namespace epcc {

/// One text of several, "a, b".
inline std::string joined(const std::vector<std::string>& words, const std::string& between = ", ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

}  // namespace epcc
