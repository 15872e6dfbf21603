// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options of epcc_track.
#include "eval/track/track_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <set>
#include <system_error>

#include "datasets/files/text_lines.h"
#include "datasets/support/degree.h"
#include "datasets/support/number_text.h"
#include "epcc_segmentation/parameter_table.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/number_range.h"
#include "eval/program/reading_arguments.h"

namespace epcc {
namespace {

constexpr const char* kDescription =
    "Follows the planes of a sequence of depth images: each gets a label for life and a place in a map.\n"
    "FOLDER is a data set, FOLDER or FORMAT:FOLDER, with one of the formats that epcc_eval reads; its frames are "
    "taken\n"
    "in their order. Poses are those of the frames (\"pose\" in NAME.json) or of a trajectory; without, the planes "
    "tell\n"
    "where the camera is.";
constexpr const char* kFooter =
    "Exit codes: 0 done, 2 wrong usage, 3 an input could not be used (the rest is done), 4 an output could not be\n"
    "written.";
constexpr int kMostLag = 1000;

/// The options as typed.
struct RawOptions {
  ReadingArguments reading;
  std::vector<std::string> assignments;
  std::string pose_sigma, motion_sigma;
  std::string lags = "5,25,75";
};

/// Empty if `text` is METRES,DEGREES, else what is wrong.
std::string setSigmas(const std::string& option, const std::string& text, double& offset, double& angle) {
  if (text.empty()) return {};
  const std::vector<std::string_view> fields = fieldsOf(text);
  const auto metres = fields.size() == 2 ? numberFrom(fields[0]) : std::nullopt;
  const auto degrees = fields.size() == 2 ? numberFrom(fields[1]) : std::nullopt;
  if (!metres || !degrees) return option + ": '" + text + "' is not METRES,DEGREES";
  if (!(*metres > 0.0 && *metres <= 10.0)) return option + ": the metres must be above 0 and at most 10";
  if (!(*degrees > 0.0 && *degrees <= 57.0)) return option + ": the degrees must be above 0 and at most 57";
  offset = *metres;
  angle = *degrees * kDegree;
  return {};
}

std::string setLags(const std::string& text, std::vector<int>& lags) {
  std::set<int> seen;
  for (const std::string_view field : fieldsOf(text)) {
    const auto value = numberFrom(field);
    if (!value || *value != std::floor(*value) || *value < 1.0 || *value > kMostLag)
      return "--lags: '" + std::string(field) + "' is not a whole number from 1 to " + std::to_string(kMostLag);
    if (!seen.insert(static_cast<int>(*value)).second) return "--lags: '" + std::string(field) + "' comes twice";
  }
  lags.assign(seen.begin(), seen.end());
  return {};
}

std::string setParameters(const std::vector<std::string>& assignments, Parameters& parameters) {
  for (const std::string& assignment : assignments) {
    const std::string name = assignment.substr(0, assignment.find('='));
    if (name == "mode" || name.rfind("paper.", 0) == 0)
      return "--set: " + name + ": planes are followed in the inverse-depth mode alone";
    if (name == "threads") return "--set: threads has an option of its own: --threads";
    const std::string problem = setParameter(assignment, parameters);
    if (!problem.empty()) return "--set: " + problem;
  }
  return parameters.validate();
}

std::string setOptions(const RawOptions& raw, TrackOptions& options) {
  std::string problem;
  options.reading = readingOptions(raw.reading, problem);
  if (problem.empty())
    problem =
        setSigmas("--pose-sigma", raw.pose_sigma, options.tracker.pose_offset_sigma, options.tracker.pose_angle_sigma);
  if (problem.empty())
    problem = setSigmas("--motion-sigma", raw.motion_sigma, options.tracker.motion_offset_sigma,
                        options.tracker.motion_angle_sigma);
  if (problem.empty()) problem = setLags(raw.lags, options.lags);
  if (problem.empty()) problem = setParameters(raw.assignments, options.parameters);
  options.measure |= options.compare_single;
  return problem;
}

void addSequenceOptions(CLI::App& app, TrackOptions& options) {
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    return app.add_option(name, value, text)->type_name(type)->group("Sequence");
  };
  add("--poses", options.poses, "FILE",
      "Trajectory with the camera's poses: lines of time, position, quaternion, as TUM's")
      ->check(checkPath);
  app.add_flag("--pose-free", options.pose_free, "Find the poses by the planes, whether they are known or not")
      ->group("Sequence");
  add("--max-time-difference", options.max_time_difference, "S", "Of a frame and a pose of FILE, seconds (0.02)")
      ->check(within(0.0, 10.0));
  add("--rate", options.rate, "HZ", "Frames a second where frames have no times (30)")->check(within(0.01, 10000.0));
  add("--first", options.first, "N", "Frame to start with, from 0 (0)")->check(within(0, 100000000));
  add("--every", options.every, "N", "Take each N-th frame (1)")->check(within(1, 1000000));
  add("--frames", options.count, "N", "Take so many at most (all)")->check(within(1, 100000000));
}

void addMethodOptions(CLI::App& app, TrackOptions& options, RawOptions& raw) {
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    return app.add_option(name, value, text)->type_name(type)->group("Method");
  };
  add("--noise", options.noise, "NOISE",
      "Sensor: PRESET | A,B,L[,C] | poly:K1,K2,K3 | FILE.json | auto (else the first frame's own, else auto)")
      ->check(noiseProblem);
  add("--pose-sigma", raw.pose_sigma, "M,DEG", "Standard deviation of given poses, metres and degrees (0.01,0.29)");
  add("--motion-sigma", raw.motion_sigma, "M,DEG",
      "The same of what a camera without poses does beyond going on as it did (0.02,1.15)");
  add("--confirm", options.tracker.confirm_frames, "N", "A plane gets its label when it was seen in N frames (3)")
      ->check(within(1, 1000));
  add("--memory", options.tracker.memory_frames, "N", "Frames that a decision on clutter and merging remembers (15)")
      ->check(within(1, 1000));
  add("--set", raw.assignments, "NAME=VALUE",
      "Any parameter, as epcc_segment --list-parameters names it; may be given again")
      ->expected(1)
      ->take_all();
  add("--threads", options.parameters.threads, "N", "Threads; the result does not depend on them (1)");
}

void addOutputOptions(CLI::App& app, TrackOptions& options, RawOptions& raw) {
  app.add_option("--out", options.out, "Folder of the outputs")
      ->type_name("DIR")
      ->required()
      ->check(checkPath)
      ->group("Output");
  app.add_flag(
         "--online", options.online,
         "Labels stay as they were at the time: none before a plane is confirmed, and one that turns out to be part "
         "of another is not rewritten")
      ->group("Output");
  app.add_flag("--overlays", options.overlays, "Also NAME_overlay.png, the labels on the depth; reads the frames again")
      ->group("Output");
  app.add_option("--cell", options.cell, "Cells of the map's outlines, metres (0.02)")
      ->type_name("M")
      ->check(within(0.001, 1.0))
      ->group("Output");
  app.add_flag("--measure", options.measure, "Print how steady the labels are; the poses must be known")
      ->group("Output");
  app.add_flag("--compare-single", options.compare_single, "The same of the frames segmented one by one, too")
      ->group("Output");
  app.add_option("--lags", raw.lags, "Distances of the frames that are compared (5,25,75)")
      ->type_name("N,N,...")
      ->group("Output");
}

}  // namespace

std::optional<int> parseTrackOptions(int argc, const char* const* argv, TrackOptions& options, std::ostream& out,
                                     std::ostream& err) {
  CLI::App app(kDescription, "epcc_track");
  app.footer(presetLine("PRESET") + kFooter);
  app.set_version_flag("--version", versionText("epcc_track"));
  app.set_help_flag("-h,--help", "Print this help and exit");
  RawOptions raw;
  app.add_option("FOLDER", options.folder, "Data set with the frames")->type_name("")->required()->check(checkPath);
  addSequenceOptions(app, options);
  addDepthArguments(app, raw.reading);
  addMethodOptions(app, options, raw);
  addOutputOptions(app, options, raw);
  return parseCommandLine(app, argc, argv, out, err, [&] {
    const std::string problem = setOptions(raw, options);
    require(problem.empty(), problem);
  });
}

}  // namespace epcc
