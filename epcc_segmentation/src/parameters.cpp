// SPDX-License-Identifier: BSD-3-Clause
// Checks of the parameters, and their values as text, from the parameter table.
#include "epcc_segmentation/parameters.h"

#include <cmath>
#include <locale>
#include <sstream>

#include "epcc_segmentation/parameter_table.h"
#include "typed_number.h"

namespace epcc {

namespace {

/// As one writes it: "0.15", "60", "1e9".
std::string numberText(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::abs(value) < 1e6 ? 10 : 6);
  text << value;
  std::string number = text.str();
  const std::size_t exponent = number.find("e+0");
  if (exponent != std::string::npos) number.erase(exponent + 1, 2);
  return number;
}

/// A list of words, "a | b | c".
std::string choicesText(const ParameterField& field) {
  std::string text;
  for (const char* word : field.choices) text += (text.empty() ? "" : " | ") + std::string(word);
  return text;
}

/// Empty if the value is in the field's range; NaN never is.
std::string rangeProblem(const ParameterField& field, double value) {
  if (value >= field.low && value <= field.high) return {};
  return std::string(field.name) + " must be in " + rangeText(field) + ", not " + valueText(field, value);
}

/// The value that a text names; NaN if it names none.
double parsedValue(const ParameterField& field, const std::string& text) {
  for (std::size_t i = 0; i < field.choices.size(); ++i)
    if (text == field.choices[i]) return static_cast<double>(i);
  const double value = field.choices.empty() ? typedNumber(text) : std::nan("");
  return !field.whole || value == std::floor(value) ? value : std::nan("");
}

const ParameterField* fieldNamed(const std::string& name) {
  for (const ParameterField& field : parameterFields())
    if (name == field.name) return &field;
  return nullptr;
}

}  // namespace

std::string rangeText(const ParameterField& field) {
  if (!field.choices.empty()) return choicesText(field);
  const bool open = field.low == kAboveZero;
  std::string text = (open ? "(0" : "[" + numberText(field.low)) + ", " + numberText(field.high) + "]";
  if (*field.unit != '\0') text += " " + std::string(field.unit);
  return text;
}

std::string valueText(const ParameterField& field, double value) {
  if (field.choices.empty()) return numberText(value);
  const bool known = value >= 0.0 && value < static_cast<double>(field.choices.size());
  return known ? field.choices[static_cast<std::size_t>(value)] : "choice number " + numberText(value);
}

std::string setParameter(const std::string& assignment, Parameters& parameters) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) return "'" + assignment + "' is not NAME=VALUE";
  const std::string name = assignment.substr(0, equals);
  const std::string text = assignment.substr(equals + 1);
  const ParameterField* field = fieldNamed(name);
  if (field == nullptr) return "there is no parameter '" + name + "'";
  const double value = parsedValue(*field, text);
  if (std::isnan(value))
    return name + " must be " + (field->choices.empty() ? field->whole ? "a whole number in " : "a number in " : "") +
           rangeText(*field) + ", not '" + text + "'";
  const std::string problem = rangeProblem(*field, value);
  if (problem.empty()) field->set(parameters, value);
  return problem;
}

Parameters Parameters::forPaper() {
  Parameters parameters;
  parameters.mode = Mode::Paper;
  return parameters;
}

std::string Parameters::validate() const {
  for (const ParameterField& field : parameterFields()) {
    const std::string problem = rangeProblem(field, field.get(*this));
    if (!problem.empty()) return problem;
  }
  const PaperParameters::Expert& expert = paper.expert;
  if (expert.lines.buffer_samples < expert.lines.minSamples())
    return "paper.expert.lines.buffer_samples (n_buf) must be at least fit_samples + validation_samples = " +
           std::to_string(expert.lines.minSamples()) + ", not " + std::to_string(expert.lines.buffer_samples);
  if (expert.planes.pair_look_back > expert.planes.look_back)
    return "paper.expert.planes.pair_look_back must be at most look_back = " + std::to_string(expert.planes.look_back) +
           ", not " + std::to_string(expert.planes.pair_look_back);
  return {};
}

}  // namespace epcc
