// SPDX-License-Identifier: BSD-3-Clause
// docs/reference/parameters.md is what --list-parameters prints, and every parameter is on it once.
#include "eval/segment/parameter_page.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "epcc_segmentation/parameter_table.h"

namespace epcc {
namespace {

TEST(ParameterPage, HasEveryParameterOnce) {
  const std::string page = parameterPage();
  for (const ParameterField& field : parameterFields()) {
    const std::string name = "| `" + std::string(field.name) + "` | ";
    const std::size_t at = page.find(name);
    ASSERT_NE(at, std::string::npos) << field.name;
    EXPECT_EQ(page.find(name, at + 1), std::string::npos) << field.name;
  }
}

TEST(ParameterPage, IsTheDocument) {
  std::ifstream in(EPCC_DOCS_DIR "/reference/parameters.md");
  ASSERT_TRUE(in);
  std::ostringstream document;
  document << in.rdbuf();
  EXPECT_EQ(document.str(), parameterPage())
      << "renew it: epcc_segment --list-parameters > docs/reference/parameters.md";
}

}  // namespace
}  // namespace epcc
