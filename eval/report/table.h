// SPDX-License-Identifier: BSD-3-Clause
// A table of texts, and its form for the terminal, Markdown, CSV and LaTeX.
#pragma once

#include <string>
#include <vector>

namespace epcc {

/// Heading and alignment of a column.
struct TableColumn {
  std::string title;
  bool right_aligned = true;
};

/// Cells by row, as UTF-8. A row may be shorter than the heading, not longer (std::invalid_argument on writing).
struct Table {
  std::vector<TableColumn> columns;
  std::vector<std::vector<std::string>> rows;
};

/// A number with so many decimals; `missing` where it is not finite.
std::string numberCell(double value, int decimals, const std::string& missing = "");

/// Columns padded with spaces, two between them.
std::string textTable(const Table& table);
/// GitHub's table; what would be markup is escaped.
std::string markdownTable(const Table& table);
/// RFC 4180 quoting, lines end with a line feed.
std::string csvTable(const Table& table);
/// One line of it.
std::string csvLine(const std::vector<std::string>& cells);
/// A tabular environment with \hline; special characters are escaped.
std::string latexTable(const Table& table);

}  // namespace epcc
