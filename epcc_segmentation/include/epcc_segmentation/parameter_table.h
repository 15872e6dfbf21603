// SPDX-License-Identifier: BSD-3-Clause
// Every field of Parameters with its range, unit and effect: one table for validate(), the command line and the
// documents.
#pragma once

#include <string>
#include <vector>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/parameters.h"

namespace epcc {

/// The smallest value of a field that must be above 0: its range is written "(0, ...".
constexpr double kAboveZero = 1e-6;

/// One field of Parameters. A number has a range; a choice has words, and its value is the index of one.
struct ParameterField {
  const char* name;                  ///< as in C++, for example "inverse_depth.line_k_max"
  double (*get)(const Parameters&);  ///< its value
  void (*set)(Parameters&, double);  ///< changes it, to the nearest that it can hold; the range is not checked
  bool whole;                        ///< whole numbers only
  double low;                        ///< smallest value of a number, or kAboveZero
  double high;                       ///< largest value of a number
  std::vector<const char*> choices;  ///< the words of a choice; empty for a number
  const char* unit;                  ///< empty for a ratio or a choice
  const char* meaning;               ///< what it is, in a sentence without full stop
  const char* raise;                 ///< number: raise it if ...
  const char* lower;                 ///< number: lower it if ...
  const char* advice;                ///< choice: when to take which, whole sentences without full stop at the end
};

/// All fields, in the order of the headers.
EPCC_CORE_EXPORT const std::vector<ParameterField>& parameterFields();

/// "(0, 100] sigma" or "a | b | c | d".
EPCC_CORE_EXPORT std::string rangeText(const ParameterField& field);
/// A value of the field as one writes it: "1.5", "paper".
EPCC_CORE_EXPORT std::string valueText(const ParameterField& field, double value);

/// Sets one field from "NAME=VALUE". Empty if done, else what is wrong in words; then nothing is changed. Relations
/// between fields are left to Parameters::validate().
EPCC_CORE_EXPORT std::string setParameter(const std::string& assignment, Parameters& parameters);

}  // namespace epcc
