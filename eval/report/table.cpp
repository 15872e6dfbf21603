// SPDX-License-Identifier: BSD-3-Clause
// The same table is written as text, CSV, Markdown or LaTeX.
#include "eval/report/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace epcc {

namespace {

using Cells = std::vector<std::string>;

Cells titles(const Table& table) {
  Cells cells;
  for (const TableColumn& column : table.columns) cells.push_back(column.title);
  return cells;
}

/// The cells of a row, filled up with empty ones.
Cells padded(const Table& table, const Cells& row) {
  if (row.size() > table.columns.size()) throw std::invalid_argument("a row is longer than its table's heading");
  Cells cells = row;
  cells.resize(table.columns.size());
  return cells;
}

template <typename Function>
std::string join(const Cells& cells, const std::string& separator, const Function& function) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? separator : std::string()) + function(cells[i]);
  return line;
}

std::string replaced(char c, const std::vector<std::pair<char, const char*>>& replacements) {
  for (const auto& [from, to] : replacements)
    if (c == from) return to;
  return std::string(1, c);
}

std::string escaped(const std::string& text, const std::vector<std::pair<char, const char*>>& replacements) {
  std::string result;
  for (const char c : text) result += replaced(c, replacements);
  return result;
}

std::string escapeMarkdown(const std::string& text) {
  return escaped(text, {{'\\', "\\\\"},
                        {'|', "\\|"},
                        {'*', "\\*"},
                        {'`', "\\`"},
                        {'_', "\\_"},
                        {'[', "\\["},
                        {'<', "&lt;"},
                        {'&', "&amp;"},
                        {'\n', "<br>"},
                        {'\r', ""}});
}

std::string escapeLatex(const std::string& text) {
  return escaped(text, {{'\\', "\\textbackslash{}"},
                        {'~', "\\textasciitilde{}"},
                        {'^', "\\textasciicircum{}"},
                        {'<', "\\textless{}"},
                        {'>', "\\textgreater{}"},
                        {'&', "\\&"},
                        {'%', "\\%"},
                        {'$', "\\$"},
                        {'#', "\\#"},
                        {'_', "\\_"},
                        {'{', "\\{"},
                        {'}', "\\}"},
                        {'\n', " "},
                        {'\r', ""}});
}

std::string quoteCsv(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  return '"' + escaped(text, {{'"', "\"\""}}) + '"';
}

/// Characters on the screen: UTF-8 continuation bytes take no room.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string alignedLine(const Table& table, const Cells& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string space(widths[i] - widthOf(cells[i]), ' ');
    line += (i > 0 ? "  " : "") + (table.columns[i].right_aligned ? space + cells[i] : cells[i] + space);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

}  // namespace

std::string numberCell(double value, int decimals, const std::string& missing) {
  if (!std::isfinite(value)) return missing;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string textTable(const Table& table) {
  std::vector<Cells> lines = {titles(table)};
  for (const Cells& row : table.rows) {
    lines.push_back(padded(table, row));
    for (std::string& cell : lines.back()) cell = escaped(cell, {{'\n', " "}, {'\r', ""}});
  }
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (const Cells& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], widthOf(line[i]));
  std::string text;
  for (const Cells& line : lines) text += alignedLine(table, line, widths);
  return text;
}

std::string markdownTable(const Table& table) {
  const auto line = [](const Cells& cells) { return "| " + join(cells, " | ", escapeMarkdown) + " |\n"; };
  std::string text = line(titles(table)) + "|";
  for (const TableColumn& column : table.columns) text += column.right_aligned ? "---:|" : "---|";
  text += '\n';
  for (const Cells& row : table.rows) text += line(padded(table, row));
  return text;
}

std::string csvLine(const std::vector<std::string>& cells) {
  return join(cells, ",", quoteCsv) + '\n';
}

std::string csvTable(const Table& table) {
  std::string text = csvLine(titles(table));
  for (const Cells& row : table.rows) text += csvLine(padded(table, row));
  return text;
}

std::string latexTable(const Table& table) {
  const auto line = [](const Cells& cells) { return join(cells, " & ", escapeLatex) + " \\\\\n"; };
  std::string text = "\\begin{tabular}{";
  for (const TableColumn& column : table.columns) text += column.right_aligned ? 'r' : 'l';
  text += "}\n\\hline\n" + line(titles(table)) + "\\hline\n";
  for (const Cells& row : table.rows) text += line(padded(table, row));
  return text + "\\hline\n\\end{tabular}\n";
}

}  // namespace epcc
