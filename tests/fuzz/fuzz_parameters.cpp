// SPDX-License-Identifier: BSD-3-Clause
// Parameters as NAME=VALUE and sensor models, a line each, as command lines have them.
#include <cmath>
#include <sstream>

#include "datasets/support/input_error.h"
#include "epcc_segmentation/parameter_table.h"
#include "epcc_segmentation/sensor_model.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

void checkFields(const Parameters& parameters) {
  static const Parameters defaults;
  for (const ParameterField& field : parameterFields()) {
    const double value = field.get(parameters);
    require(value >= field.low && value <= field.high, "a parameter that was set is in its range");
    require(!field.whole || value == std::floor(value), "a whole number is one");
    if (value == field.get(defaults)) continue;
    Parameters copy;
    const std::string text = std::string(field.name) + "=" + valueText(field, value);
    require(setParameter(text, copy).empty(), "a value is written as it is read");
  }
}

bool setsParameter(const std::string& line, Parameters& parameters) {
  const std::string problem = setParameter(line, parameters);
  if (!problem.empty()) requireOneLine(printable(problem, 1000));
  require(!problem.empty() || line.find('\0') == std::string::npos, "nothing is left unread");
  return problem.empty();
}

bool isModel(const std::string& line) {
  std::string why;
  const auto model = SensorModel::parse(line, &why);
  require(model.has_value() == why.empty(), "a model is refused in words");
  if (!model) return false;
  require(line.find('\0') == std::string::npos, "nothing is left unread");
  require(model->validate().empty(), "a model that was read can be used");
  requireOneLine(model->description());
  for (const double z : {1e-3, 1.0, 10.0, 1e3}) require(model->sigmaZ(z) >= 1e-6, "an error is positive");
  return true;
}

bool runParameters(const std::uint8_t* data, std::size_t size) {
  std::istringstream lines(std::string(reinterpret_cast<const char*>(data), size));
  std::string line;
  Parameters parameters;
  bool all = true, changed = false;
  while (std::getline(lines, line)) {
    const bool is_parameter = setsParameter(line, parameters);
    changed = changed || is_parameter;
    if (!is_parameter && !isModel(line)) all = false;
  }
  if (changed) {
    checkFields(parameters);
    const std::string problem = parameters.validate();
    if (!problem.empty()) requireOneLine(problem);
  }
  return all;
}

std::vector<std::string> parametersSeeds() {
  std::vector<std::string> seeds(1);
  const Parameters defaults;
  for (const ParameterField& field : parameterFields())
    seeds[0] += std::string(field.name) + "=" + valueText(field, field.get(defaults)) + "\n";
  for (const std::string& preset : SensorModel::presetNames()) seeds.push_back(preset);
  for (const char* text : {"0.002,0.001,1.5", "poly:0.001,0.002,0.003", "mode=paper\nscan=rows",
                           "inverse_depth.line_k_max=1e-3\nthreads=256"})
    seeds.emplace_back(text);
  return seeds;
}

}  // namespace

const FuzzTarget kParameters{runParameters, parametersSeeds};

}  // namespace epcc::fuzz
