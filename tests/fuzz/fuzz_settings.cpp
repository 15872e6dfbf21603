// SPDX-License-Identifier: BSD-3-Clause
// Fields are picked from the table of parameters.
#include "tests/fuzz/fuzz_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "epcc_segmentation/parameter_table.h"

namespace epcc::fuzz {
namespace {

constexpr int kMostThreads = 3;  // more of them cost time and show nothing new

double takeValue(const ParameterField& field, double before, FuzzInput& input) {
  switch (input.byte() % 8) {
    case 0:
      return field.low;
    case 1:
      return field.high;
    case 2:
      return field.whole ? std::floor(0.5 * before) : 0.5 * before;
    case 3:
      return 2.0 * before;
    case 4:
      return before + 1.0;
    case 5:
      return field.low + input.byte() % 4;
    default:
      return field.whole ? input.raw<std::int16_t>() : input.anyNumber();
  }
}

}  // namespace

Parameters takeParameters(FuzzInput& input) {
  Parameters parameters = input.oneIn(3) ? Parameters::forPaper() : Parameters();
  parameters.scan = static_cast<ScanDirection>(input.byte() % 3);
  parameters.line_segments = input.oneIn(2);
  for (int i = input.byte() % 8; i > 0; --i) {
    const auto& fields = parameterFields();
    const ParameterField& field = fields[input.byte() % fields.size()];
    const double value = takeValue(field, field.get(parameters), input);
    // A choice is an enumerator, which other numbers are not.
    if (field.choices.empty() || (value >= field.low && value <= field.high)) field.set(parameters, value);
  }
  if (parameters.threads > kMostThreads) parameters.threads = kMostThreads;
  return parameters;
}

std::optional<SensorModel> takeSensor(FuzzInput& input) {
  const auto presets = SensorModel::presetNames();
  switch (input.byte() % 5) {
    case 0:
      return std::nullopt;
    case 1:
      return SensorModel::preset(presets[input.byte() % presets.size()]);
    case 2: {
      const double a = 0.001 * input.byte(), b = 0.001 * input.byte();
      return SensorModel::axial(a, b, input.byte() / 16.0);
    }
    case 3: {
      const double a = input.anyNumber(), b = input.anyNumber();
      return SensorModel::axial(a, b, input.anyNumber());
    }
    default: {
      const double a = input.anyNumber(), b = input.anyNumber(), c = input.anyNumber();
      return SensorModel::polynomial(a, b, c, input.anyNumber());
    }
  }
}

}  // namespace epcc::fuzz
