// SPDX-License-Identifier: BSD-3-Clause
// A method that draws random numbers counts as one method a seed; predictions are methods too.
#include "eval/batch/eval_methods.h"

namespace epcc {

std::vector<std::string> seededNames(const std::string& method, int seeds) {
  std::vector<std::string> names = {method};
  if (!drawsAtRandom(method)) return names;
  for (int seed = 1; seed < seeds; ++seed) names.push_back(method + "-seed" + std::to_string(seed));
  return names;
}

std::vector<Method> evalMethods(const EvalOptions& options) {
  std::vector<Method> methods;
  for (const std::string& name : options.methods) {
    const std::vector<std::string> names = seededNames(name, options.seeds);
    for (std::size_t seed = 0; seed < names.size(); ++seed) {
      SegmenterOptions parameters = defaultParameters();
      parameters.ransac.seed = static_cast<int>(seed);
      methods.push_back(registeredMethod(name, parameters));
      methods.back().name = names[seed];
      methods.back().timed = !options.no_times;
    }
  }
  for (const Predictions& p : options.predictions) methods.push_back(importedMethod(p.name, p.folder));
  return methods;
}

}  // namespace epcc
