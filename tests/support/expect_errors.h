// SPDX-License-Identifier: BSD-3-Clause
// What an error of a reader or writer must look like.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "datasets/support/input_error.h"
#include "tests/support/temp_folder.h"

namespace epcc::test {

/// One line, nothing that moves a terminal's cursor.
inline void expectOneLine(const std::string& text) {
  EXPECT_TRUE(std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) << text;
  EXPECT_LT(text.size(), 2000u);
}

/// `action` throws an Error whose line is "FILE: FIELD: ... PART ...".
template <typename Error, typename Action>
void expectError(const Action& action, const std::string& file, const std::string& field, const std::string& part) {
  try {
    action();
    ADD_FAILURE() << "no error, expected " << field << ": " << part;
  } catch (const Error& error) {
    const std::string what = error.what();
    const std::string start = printable(file, 1000) + ": " + field + ": ";
    EXPECT_EQ(what.substr(0, start.size()), start);
    EXPECT_NE(what.find(part, std::min(what.size(), start.size())), std::string::npos) << what;
    expectOneLine(what);
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another error: " << error.what();
  }
}

template <typename Action>
void expectInputError(const Action& action, const std::string& file, const std::string& field,
                      const std::string& part) {
  expectError<InputError>(action, file, field, part);
}

}  // namespace epcc::test
