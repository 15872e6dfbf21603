// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options that say what is segmented and how.
#include "eval/segment/frame_arguments.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "datasets/support/number_text.h"
#include "epcc_segmentation/parameter_table.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"

namespace epcc {
namespace {

// Help without CLI11's lists of what an option needs and excludes: they are longer than the help itself.
class PlainFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_name().empty() ? std::string() : " " + option->get_type_name();
  }
};

std::string checkFinite(const std::string& text) {
  const std::optional<double> value = numberFrom(text);
  if (!value) return "'" + text + "' is not a number";
  return std::isfinite(*value) ? std::string() : "'" + text + "' is not a finite number";
}

std::string checkPositive(const std::string& text) {
  const std::string problem = checkFinite(text);
  if (!problem.empty()) return problem;
  return *numberFrom(text) > 0.0 ? std::string() : "'" + text + "' is not positive";
}

std::string checkNoise(const std::string& text) {
  return noiseProblem(text);
}

std::string checkMode(const std::string& text) {
  const bool known = text == "inverse-depth" || text == "default" || text == "paper";
  return known ? std::string() : "unknown mode '" + text + "'; use 'inverse-depth' or 'paper'";
}

std::string checkScan(const std::string& text) {
  const bool known = text == "columns" || text == "rows" || text == "both";
  return known ? std::string() : "'" + text + "' is none of 'columns', 'rows', 'both'";
}

std::string checkCriterion(const std::string& text) {
  const bool known = text.size() == 1 && text[0] >= 'a' && text[0] <= 'd';
  return known ? std::string() : "'" + text + "' is none of 'a', 'b', 'c', 'd'";
}

void addCameraOptions(CLI::App& app, SegmentOptions& options, FrameArguments& raw) {
  CLI::Option* file = app.add_option("--camera", options.camera_file, "Camera of the depth images")
                          ->type_name("NAME.json")
                          ->check(checkPath)
                          ->group("Camera");
  const auto number = [&](const char* name, std::optional<double>& value, const char* text, auto check) {
    return app.add_option(name, value, text)->type_name("F")->check(check)->group("Camera")->excludes(file);
  };
  CLI::Option* fx = number("--fx", raw.fx, "Focal length along a row, pixels", checkPositive);
  CLI::Option* fy = number("--fy", raw.fy, "Focal length along a column, pixels", checkPositive);
  CLI::Option* cx = number("--cx", raw.cx, "Column of the principal point, pixels", checkFinite);
  CLI::Option* cy = number("--cy", raw.cy, "Row of the principal point, pixels", checkFinite);
  CLI::Option* scale = number("--depth-scale", raw.depth_scale, "Metres per depth unit (0.001)", checkPositive);
  for (CLI::Option* option : {fx, fy, cx, cy, scale}) {
    for (CLI::Option* other : {fx, fy, cx, cy}) {
      if (option != other) option->needs(other);
    }
  }
}

void addMethodOptions(CLI::App& app, SegmentOptions& options, FrameArguments& raw) {
  Parameters& p = options.parameters;
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    return app.add_option(name, value, text)->type_name(type)->group("Method");
  };
  add("--mode", raw.mode, "MODE", "inverse-depth | paper (inverse-depth, also called default)")->check(checkMode);
  add("--noise", options.noise, "NOISE",
      "Sensor: PRESET | A,B,L[,C] | poly:K1,K2,K3 | FILE.json | auto (else the frame's own, else auto)")
      ->check(checkNoise);
  add("--scan", raw.scan, "WHICH", "Scan lines: columns | rows | both: all that the mode has (both)")->check(checkScan);
  add("--line-k-max", raw.line_k_max, "K", "Gate of a line, in sigma (1.5; paper, Eq. 20: 2)")->check(checkFinite);
  add("--plane-k-max", raw.plane_k_max, "K", "Gate of a plane, in sigma (2; paper, Eq. 23: 3)")->check(checkFinite);
  add("--max-gap", raw.max_gap, "D1", "Paper: gap within a plane beyond the noise, metres (0.15)")->check(checkFinite);
  add("--min-points", raw.min_points, "N", "Planes with fewer pixels are dropped (60; paper: 0)");
  add("--criterion", raw.criterion, "a|b|c|d", "Paper: form of the criterion, Table 2 (a)")->check(checkCriterion);
  add("--plane-weight", raw.plane_weight, "FORM",
      "Paper: weight of an endpoint, Eq. 26: printed | exponential | gaussian | cauchy | huber | none (printed)");
  add("--set", raw.assignments, "NAME=VALUE",
      "Any parameter, as epcc_segment --list-parameters names it; may be given again")
      ->expected(1)
      ->take_all();
  add("--threads", p.threads, "N", "Threads; the result does not depend on them (1)");
}

// What is wrong with NAME=VALUE for this mode, whatever the value; empty if nothing is.
std::string assignmentProblem(const std::string& assignment, bool paper) {
  const std::string name = assignment.substr(0, assignment.find('='));
  for (const char* option : {"mode", "scan", "threads"})
    if (name == option) return name + " has an option of its own: --" + name;
  if (paper && name.rfind("inverse_depth.", 0) == 0) return name + " belongs to the inverse-depth mode";
  if (!paper && name.rfind("paper.", 0) == 0) return name + " belongs to the paper mode";
  return {};
}

// Puts the method's options into the parameters of their mode. Empty if all is well, else what is wrong.
std::string setMethod(const FrameArguments& raw, Parameters& parameters) {
  const bool paper = raw.mode == "paper";
  parameters.mode = paper ? Mode::Paper : Mode::InverseDepth;
  if (!paper && raw.max_gap) return "--max-gap belongs to the paper mode";
  if (!paper && !raw.criterion.empty()) return "--criterion belongs to the paper mode";
  if (!paper && raw.plane_weight) return "--plane-weight belongs to the paper mode";
  if (raw.scan == "columns") parameters.scan = ScanDirection::Columns;
  if (raw.scan == "rows") parameters.scan = ScanDirection::Rows;
  if (raw.scan == "both") parameters.scan = ScanDirection::Both;
  if (raw.line_k_max) (paper ? parameters.paper.line_k_max : parameters.inverse_depth.line_k_max) = *raw.line_k_max;
  if (raw.plane_k_max) (paper ? parameters.paper.plane_k_max : parameters.inverse_depth.plane_k_max) = *raw.plane_k_max;
  if (raw.max_gap) parameters.paper.max_gap = *raw.max_gap;
  if (raw.min_points) (paper ? parameters.paper.min_points : parameters.inverse_depth.min_points) = *raw.min_points;
  if (!raw.criterion.empty()) parameters.paper.criterion = static_cast<PlaneCriterion>(raw.criterion[0] - 'a');
  if (raw.plane_weight) {
    const std::string problem = setParameter("paper.endpoint_weight=" + *raw.plane_weight, parameters);
    if (!problem.empty()) return "--plane-weight: " + problem;
  }
  for (const std::string& assignment : raw.assignments) {
    std::string problem = assignmentProblem(assignment, paper);
    if (problem.empty()) problem = setParameter(assignment, parameters);
    if (!problem.empty()) return "--set: " + problem;
  }
  return parameters.validate();
}

}  // namespace

void addFrameArguments(CLI::App& app, const std::string& inputs, SegmentOptions& options, FrameArguments& arguments) {
  static_assert(static_cast<int>(PlaneCriterion::Prototype) == 3, "criteria a to d in order");
  app.formatter(std::make_shared<PlainFormatter>());
  app.add_option("INPUT", options.inputs, inputs)->type_name("")->required()->check(checkPath);
  addCameraOptions(app, options, arguments);
  addReadingArguments(app, arguments.reading);
  addMethodOptions(app, options, arguments);
}

std::string setFrameOptions(const FrameArguments& raw, SegmentOptions& options) {
  std::string misread;
  options.reading = readingOptions(raw.reading, misread);
  if (!misread.empty()) return misread;
  if (raw.depth_scale && options.reading.unit) return "--unit takes the place of --depth-scale, give one of them";
  if (raw.fx) {
    options.camera = CameraNumbers{*raw.fx, *raw.fy, *raw.cx, *raw.cy, raw.depth_scale.value_or(0.001)};
    const std::string problem = options.camera->validate();
    if (!problem.empty()) return problem;
  }
  return setMethod(raw, options.parameters);
}

}  // namespace epcc
