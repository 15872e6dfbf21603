// SPDX-License-Identifier: BSD-3-Clause
// Rows of the parameter table as Markdown, so that the page cannot differ from what the programs do.
#include "eval/segment/parameter_page.h"

#include <utility>
#include <vector>

#include "epcc_segmentation/parameter_table.h"

namespace epcc {

namespace {

constexpr const char* kIntroduction =
    "# Parameters\n\n"
    "Every field of `epcc::Parameters`, as `epcc_segment --list-parameters` prints it. On the command line\n"
    "`--set NAME=VALUE` sets any of them but `mode`, `scan` and `threads`, which are options; in C++ the name is the\n"
    "path of the field (`parameters.inverse_depth.line_k_max`), or `epcc::setParameter(\"NAME=VALUE\", parameters)` "
    "of\n"
    "`epcc_segmentation/parameter_table.h` sets it. The PCL class takes them by `setParameters()`, has setters for "
    "the\n"
    "basic ones and `paper()` for the paper mode's. Words such as `paper` or `a` are enumerators in C++, in the same\n"
    "order (`parameters.h`, `paper_parameters.h`).\n\n"
    "Most users need none of these: say what the sensor is (`--noise`), or let it be measured. Lengths in sigma are\n"
    "in standard deviations of the sensor model (sigma_w: of an inverse depth); independent samples are pixels\n"
    "divided by those that the sensor's correlated error covers. S1 to S9, c1 and c2 are the steps and symbols of\n"
    "[the algorithm](../research/algorithm.md).\n";

/// Where a field's heading comes from: the beginning of its name.
const std::vector<std::pair<std::string, std::string>>& groups() {
  static const std::vector<std::pair<std::string, std::string>> all = {
      {"", "General"},
      {"inverse_depth.", "Inverse-depth mode, basic"},
      {"inverse_depth.expert.lines.", "Inverse-depth mode, S1: line segments"},
      {"inverse_depth.expert.planes.", "Inverse-depth mode, S2 and S3: planes"},
      {"inverse_depth.expert.merging.", "Inverse-depth mode, S4, S6 and S8: merging"},
      {"inverse_depth.expert.refinement.", "Inverse-depth mode, S5: borders"},
      {"inverse_depth.expert.evidence.", "Inverse-depth mode, S7: what counts as a plane"},
      {"paper.", "Paper mode, basic"},
      {"paper.expert.lines.", "Paper mode, Algorithm 1"},
      {"paper.expert.planes.", "Paper mode, Algorithm 2"},
  };
  return all;
}

/// A field belongs to the group whose prefix leaves nothing but the field's own word.
bool isIn(const ParameterField& field, const std::string& prefix) {
  const std::string name = field.name;
  return name.rfind(prefix, 0) == 0 && name.find('.', prefix.size()) == std::string::npos;
}

/// A bar would end the cell.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string effect(const ParameterField& field) {
  if (!field.choices.empty()) return std::string(field.advice) + ".";
  return std::string("Raise it if ") + field.raise + "; lower it if " + field.lower + ".";
}

std::string row(const ParameterField& field) {
  const std::string value = valueText(field, field.get(Parameters()));
  return "| `" + std::string(field.name) + "` | " + value + " | " + cell(rangeText(field)) + " | " + field.meaning +
         ". " + effect(field) + " |\n";
}

}  // namespace

std::string parameterPage() {
  std::string page = kIntroduction;
  for (const auto& [prefix, title] : groups()) {
    page += "\n## " + title + "\n\n| name | default | range | what it is |\n|---|---|---|---|\n";
    for (const ParameterField& field : parameterFields())
      if (isIn(field, prefix)) page += row(field);
  }
  return page;
}

}  // namespace epcc
