// SPDX-License-Identifier: BSD-3-Clause
// The four forms of a table, and cells that would break them.
#include "eval/report/table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace {

using epcc::Table;

Table smallTable() {
  Table table;
  table.columns = {{"method", false}, {"D/N", true}};
  table.rows = {{"epcc", "1.00"}, {"region-growing", "0.5"}};
  return table;
}

Table tableOf(const std::string& cell) {
  Table table;
  table.columns = {{"c", false}};
  table.rows = {{cell}};
  return table;
}

TEST(Table, Text) {
  EXPECT_EQ(epcc::textTable(smallTable()),
            "method           D/N\n"
            "epcc            1.00\n"
            "region-growing   0.5\n");
}

TEST(Table, TextAlignsByCharactersNotBytes) {
  Table table = smallTable();
  table.rows = {{"σ", "1"}};
  EXPECT_EQ(epcc::textTable(table), "method  D/N\nσ         1\n");
}

TEST(Table, TextHasNoSpacesAtTheEndAndOneLineARow) {
  EXPECT_EQ(epcc::textTable(tableOf("a\nlonger ")), "c\na longer\n");
}

TEST(Table, Markdown) {
  EXPECT_EQ(epcc::markdownTable(smallTable()),
            "| method | D/N |\n"
            "|---|---:|\n"
            "| epcc | 1.00 |\n"
            "| region-growing | 0.5 |\n");
}

TEST(Table, MarkdownEscapesMarkup) {
  EXPECT_EQ(epcc::markdownTable(tableOf("a|b\\*_<x>\nc")), "| c |\n|---|\n| a\\|b\\\\\\*\\_&lt;x><br>c |\n");
}

TEST(Table, Csv) {
  EXPECT_EQ(epcc::csvTable(smallTable()), "method,D/N\nepcc,1.00\nregion-growing,0.5\n");
}

TEST(Table, CsvQuotesWhatNeedsIt) {
  EXPECT_EQ(epcc::csvTable(tableOf("a,b")), "c\n\"a,b\"\n");
  EXPECT_EQ(epcc::csvTable(tableOf("say \"a\"")), "c\n\"say \"\"a\"\"\"\n");
  EXPECT_EQ(epcc::csvTable(tableOf("two\nlines")), "c\n\"two\nlines\"\n");
  EXPECT_EQ(epcc::csvTable(tableOf("return\r")), "c\n\"return\r\"\n");
  EXPECT_EQ(epcc::csvTable(tableOf(" plain; ")), "c\n plain; \n");
}

TEST(Table, Latex) {
  EXPECT_EQ(epcc::latexTable(smallTable()),
            "\\begin{tabular}{lr}\n\\hline\nmethod & D/N \\\\\n\\hline\nepcc & 1.00 \\\\\nregion-growing & 0.5 \\\\\n"
            "\\hline\n\\end{tabular}\n");
}

TEST(Table, LatexEscapesSpecialCharacters) {
  const std::string text = epcc::latexTable(tableOf("50 % of N_o & $x#{y}~^\\"));
  EXPECT_NE(text.find("50 \\% of N\\_o \\& \\$x\\#\\{y\\}\\textasciitilde{}\\textasciicircum{}\\textbackslash{} \\\\"),
            std::string::npos)
      << text;
}

TEST(Table, ShortRowsAreFilledLongOnesRefused) {
  Table table = smallTable();
  table.rows = {{"epcc"}};
  EXPECT_EQ(epcc::csvTable(table), "method,D/N\nepcc,\n");
  EXPECT_EQ(epcc::markdownTable(table), "| method | D/N |\n|---|---:|\n| epcc |  |\n");
  table.rows = {{"epcc", "1", "2"}};
  EXPECT_THROW(epcc::textTable(table), std::invalid_argument);
  EXPECT_THROW(epcc::markdownTable(table), std::invalid_argument);
  EXPECT_THROW(epcc::csvTable(table), std::invalid_argument);
  EXPECT_THROW(epcc::latexTable(table), std::invalid_argument);
}

TEST(Table, Numbers) {
  EXPECT_EQ(epcc::numberCell(1.005, 1), "1.0");
  EXPECT_EQ(epcc::numberCell(-2.0, 3), "-2.000");
  EXPECT_EQ(epcc::numberCell(std::nan(""), 3), "");
  EXPECT_EQ(epcc::numberCell(HUGE_VAL, 3, "-"), "-");
}

}  // namespace
