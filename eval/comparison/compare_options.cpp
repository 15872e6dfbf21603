// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options of epcc_compare.
#include "eval/comparison/compare_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <ostream>
#include <sstream>

#include "datasets/rendered/scene.h"
#include "datasets/support/input_error.h"
#include "datasets/support/joined.h"
#include "datasets/support/number_text.h"
#include "eval/comparison/study_catalogue.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"

namespace epcc {
namespace {

constexpr const char* kDescription =
    "Repeats the paper's comparison (Table 4, Fig. 21) on rendered surrogates of its scenes: region growing, RANSAC\n"
    "and EPCC; with study NAME, its parameter studies. Leaves tables and pictures in --out.";
constexpr const char* kFooter =
    "Exit codes: 0 done, 2 wrong usage, 3 a method failed, 4 an output could not be written.";
constexpr int kMaxSeeds = 100000;

/// The options as typed.
struct RawOptions {
  std::string scenes = "a,b,c,d";
  std::string study;
  bool paper = false;
  bool project_default = false;
  int seeds = 0;  // 0: not given
  int slow_seeds = 0;
  int jobs = 0;
  std::string first_seed = "0";  // CLI11 would take -1 for the largest number there is
};

void setScenes(const std::string& list, ComparisonOptions& options) {
  const std::vector<std::string> known = sceneNames();
  options.scenes.clear();
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    require(std::find(known.begin(), known.end(), word) != known.end(),
            "--scenes: unknown scene '" + word + "'; there are " + joined(known));
    require(std::find(options.scenes.begin(), options.scenes.end(), word) == options.scenes.end(),
            "--scenes: '" + word + "' is named twice");
    options.scenes.push_back(word);
  }
  require(!options.scenes.empty(), "--scenes: name at least one of " + joined(known));
}

void setFirstSeed(const std::string& text, ComparisonOptions& options) {
  const auto first = wholeNumberFrom(text);
  require(first.has_value(), "--first-seed: '" + text + "' is not a whole number from 0 to 2^64 - 1");
  const auto more = static_cast<std::uint64_t>(std::max(options.seeds, options.slow_seeds) - 1);
  require(more <= std::numeric_limits<std::uint64_t>::max() - *first,
          "--first-seed: the last seed is larger than 2^64 - 1");
  options.first_seed = *first;
}

void setOptions(const RawOptions& raw, bool is_study, CompareOptions& options) {
  ComparisonOptions& comparison = options.comparison;
  setScenes(raw.scenes, comparison);
  std::string why;
  const auto noise = parseNoise(comparison.noise_text, &why);
  require(noise.has_value(), "--noise: " + why);
  comparison.noise = *noise;
  comparison.parameters = raw.project_default ? ParameterSet::Default : ParameterSet::Paper;
  if (raw.seeds > 0) comparison.seeds = raw.seeds;
  if (raw.slow_seeds > 0)
    comparison.slow_seeds = raw.slow_seeds;
  else
    comparison.slow_seeds = std::min(comparison.slow_seeds, comparison.seeds);
  setFirstSeed(raw.first_seed, comparison);
  comparison.jobs = threadsFor(raw.jobs);
  if (!is_study) return;
  require(!raw.project_default, "--default: the studies are of the paper's mode");
  const std::vector<std::string> known = studyNames();
  require(std::find(known.begin(), known.end(), raw.study) != known.end(),
          "unknown study '" + raw.study + "'; there are " + joined(known));
  options.study = raw.study;
}

void addOptions(CLI::App& app, CompareOptions& options, RawOptions& raw) {
  ComparisonOptions& comparison = options.comparison;
  auto* paper = app.add_flag("--paper", raw.paper, "Table 3's parameters (default)");
  app.add_flag("--default", raw.project_default, "The project's own parameters")->excludes(paper);
  app.add_option("--noise", comparison.noise_text,
                 "none | white:SENSOR | stereo | stereo-registered (stereo); SENSOR is a preset as d435i, A,B,L or "
                 "poly:K1,K2,K3")
      ->type_name("NOISE");
  app.add_option("--scenes", raw.scenes, "Scenes (a,b,c,d)")->type_name("A,B,...");
  app.add_option("--seeds", raw.seeds, "Seeds for EPCC (20)")->type_name("N")->check(CLI::Range(1, kMaxSeeds));
  app.add_option("--slow-seeds", raw.slow_seeds, "Seeds for region growing and RANSAC (10, or --seeds if that is less)")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxSeeds));
  app.add_option("--first-seed", raw.first_seed, "First seed (0)")->type_name("N");
  app.add_option("--jobs", raw.jobs, "Threads, 0 = one a core (0)")->type_name("J")->check(CLI::Range(0, 1024));
  app.add_option("--out", options.out, "Folder for the tables and pictures (results)")
      ->type_name("DIR")
      ->check(checkPath);
}

}  // namespace

std::optional<int> parseCompareOptions(int argc, const char* const* argv, CompareOptions& options, std::ostream& out,
                                       std::ostream& err) {
  CLI::App app(kDescription, "epcc_compare");
  app.footer(presetLine("A preset SENSOR") + kFooter);
  app.set_version_flag("--version", versionText("epcc_compare"));
  RawOptions raw;
  addOptions(app, options, raw);
  CLI::App* study = app.add_subcommand("study", "One of the paper's parameter studies: " + joined(studyNames()));
  study->fallthrough();
  study->add_option("NAME", raw.study, joined(studyNames()))->required()->type_name("");
  return parseCommandLine(app, argc, argv, out, err, [&] { setOptions(raw, study->parsed(), options); });
}

}  // namespace epcc
