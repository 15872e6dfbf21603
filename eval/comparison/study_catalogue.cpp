// SPDX-License-Identifier: BSD-3-Clause
// What each study varies, on which frames.
#include "eval/comparison/study_catalogue.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "baselines/registry.h"

namespace epcc {
namespace {

constexpr double kWallDegrees = 20.0;

/// Table 3 for a scene; scene b's for frames that are no scene.
Parameters tableThree(const std::string& frames) {
  const auto options = paperParameters(frames.size() == 1 ? frames[0] : 'b');
  return options.value_or(defaultParameters()).epcc_paper;
}

/// A variant: Table 3 and what `change` does to it.
template <typename Change>
StudyVariant variant(const std::string& row, const std::string& column, const Change& change) {
  return {row, column, [change](const std::string& frames) {
            Parameters parameters = tableThree(frames);
            change(parameters);
            return parameters;
          }};
}

void useScenes(const ComparisonOptions& options, Study& study) {
  study.frames_title = "scene";
  for (const std::string& scene : options.scenes) study.frames.push_back({scene, sceneWithNoise(scene, options.noise)});
  const bool has_c = std::find(options.scenes.begin(), options.scenes.end(), "c") != options.scenes.end();
  study.pictured = has_c ? "c" : options.scenes.front();
}

void addCriteria(const ComparisonOptions& options, Study& study) {
  study.title = "Table 2, Fig. 20: the criterion of Algorithm 2 and its k_max";
  study.row_title = "criterion";
  study.column_title = "k_max";
  const std::pair<const char*, PlaneCriterion> criteria[] = {{"a", PlaneCriterion::PrototypeSensorSegment},
                                                             {"b", PlaneCriterion::PrototypeSensor},
                                                             {"c", PlaneCriterion::PrototypeSegment},
                                                             {"d", PlaneCriterion::Prototype}};
  for (const auto& criterion : criteria)
    for (int k_max = 1; k_max <= 4; ++k_max)
      study.variants.push_back(
          variant(criterion.first, std::to_string(k_max), [kind = criterion.second, k_max](Parameters& parameters) {
            parameters.paper.criterion = kind;
            parameters.paper.plane_k_max = k_max;
          }));
  useScenes(options, study);
}

void addBuffer(const ComparisonOptions& options, Study& study) {
  study.title = "Fig. 12: k_min and n_buf of Algorithm 1";
  study.row_title = "k_min";
  study.column_title = "n_buf";
  for (const int k_min : {4, 8, 12, 16})
    for (const int buffer : {16, 24, 32, 64})
      study.variants.push_back(
          variant(std::to_string(k_min), std::to_string(buffer), [k_min, buffer](Parameters& parameters) {
            parameters.paper.expert.lines.validation_samples = k_min - parameters.paper.expert.lines.fit_samples;
            parameters.paper.expert.lines.buffer_samples = buffer;
          }));
  useScenes(options, study);
}

void addDistance(const ComparisonOptions& options, Study& study) {
  study.title = "Figs. 15, 24: the sensor's noise in Algorithms 1 and 2, on a wall at 1 to 8 m turned by 20 degrees";
  study.frames_title = "distance";
  study.row_title = "noise model";
  study.by_frames = true;
  study.count_lines = true;
  const auto add = [&study](const char* name, bool in_lines, bool in_planes) {
    study.variants.push_back(variant(name, "", [in_lines, in_planes](Parameters& parameters) {
      parameters.paper.expert.lines.use_sensor_noise = in_lines;
      parameters.paper.criterion =
          in_planes ? PlaneCriterion::PrototypeSensorSegment : PlaneCriterion::PrototypeSegment;
    }));
  };
  add("on", true, true);
  add("lines only", true, false);
  add("planes only", false, true);
  add("off", false, false);
  for (int metres = 1; metres <= 8; ++metres)
    study.frames.push_back({std::to_string(metres) + " m", wallWithNoise(metres, kWallDegrees, options.noise)});
}

void addScan(const ComparisonOptions& options, Study& study) {
  study.title = "Figs. 22, 23: columns against rows as scan lines";
  study.row_title = "scan lines";
  study.by_frames = true;
  study.variants = {variant("columns", "", [](Parameters& parameters) { parameters.scan = ScanDirection::Columns; }),
                    variant("rows", "", [](Parameters& parameters) { parameters.scan = ScanDirection::Rows; })};
  useScenes(options, study);
}

void addWeights(const ComparisonOptions& options, Study& study) {
  study.title = "Eq. 26: the weight of an endpoint in the covariance of its plane";
  study.row_title = "weight";
  study.by_frames = true;
  const std::pair<const char*, EndpointWeight> weights[] = {
      {"printed", EndpointWeight::Printed},   {"exponential", EndpointWeight::Exponential},
      {"gaussian", EndpointWeight::Gaussian}, {"cauchy", EndpointWeight::Cauchy},
      {"huber", EndpointWeight::Huber},       {"none", EndpointWeight::None}};
  for (const auto& weight : weights)
    study.variants.push_back(variant(
        weight.first, "", [form = weight.second](Parameters& parameters) { parameters.paper.endpoint_weight = form; }));
  useScenes(options, study);
}

}  // namespace

std::vector<std::string> studyNames() {
  return {"criteria", "buffer", "distance", "scan", "weights"};
}

Study makeStudy(const std::string& name, const ComparisonOptions& options) {
  Study study;
  study.name = name;
  study.noise_text = options.noise_text;
  study.first_seed = options.first_seed;
  study.seeds = options.seeds;
  if (name == "criteria")
    addCriteria(options, study);
  else if (name == "buffer")
    addBuffer(options, study);
  else if (name == "distance")
    addDistance(options, study);
  else if (name == "scan")
    addScan(options, study);
  else if (name == "weights")
    addWeights(options, study);
  else
    throw std::invalid_argument("unknown study '" + name + "'");
  return study;
}

}  // namespace epcc
