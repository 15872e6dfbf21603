// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options of epcc_eval.
#include "eval/batch/eval_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>

#include "baselines/registry.h"
#include "datasets/sources/dataset_registry.h"
#include "datasets/support/file_place.h"
#include "datasets/support/input_error.h"
#include "datasets/support/joined.h"
#include "eval/batch/eval_methods.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/number_range.h"
#include "eval/program/reading_arguments.h"

namespace epcc {
namespace {

constexpr const char* kDescription =
    "Scores plane segmentation methods on labelled frames.\n"
    "DATASET is a folder: frames NAME_depth.png or NAME.pcd, NAME_labels.png, NAME.json, or a data set as "
    "distributed,\n"
    "whose format is found out or named, FORMAT:FOLDER (docs/reference/formats.md). Its name in the report is that of\n"
    "the folder.";

constexpr const char* kFooter =
    "epcc_eval merge DIR... --out DIR joins shards; see epcc_eval merge --help.\n"
    "Exit codes: 0 done (frames that could not be scored are counted and named), 2 wrong usage or --out holds another\n"
    "run, 3 no frame could be scored or, with --strict, any could not, 4 an output could not be written.";

/// The options as typed.
struct RawOptions {
  std::vector<std::string> datasets;
  std::vector<std::string> predictions;
  std::string methods;
  std::string shard = "1/1";
  ReadingArguments reading;
  std::string lags;
};

void setMethods(const std::string& list, EvalOptions& options) {
  if (list == "none") return;
  const std::vector<std::string> known = segmenterNames();
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    require(std::find(known.begin(), known.end(), word) != known.end(),
            "--methods: there is no method '" + word + "'; there are " + joined(known) + ", or none");
    require(std::find(options.methods.begin(), options.methods.end(), word) == options.methods.end(),
            "--methods: '" + word + "' is named twice");
    options.methods.push_back(word);
  }
}

/// NAME=DIR where NAME can name a folder; after the first, anything else behind --predictions is a DATASET.
bool isPrediction(const std::string& text) {
  const std::size_t equals = text.find('=');
  return equals != std::string::npos && text.substr(0, equals).find('/') == std::string::npos;
}

void setPredictions(const RawOptions& raw, EvalOptions& options) {
  std::set<std::string> names;
  for (const std::string& method : options.methods)
    for (const std::string& name : seededNames(method, options.seeds)) names.insert(name);
  if (!raw.predictions.empty())
    require(isPrediction(raw.predictions.front()), "--predictions: '" + raw.predictions.front() + "' is not NAME=DIR");
  for (const std::string& text : raw.predictions) {
    if (!isPrediction(text)) {
      options.datasets.push_back(text);
      continue;
    }
    const Predictions predictions{text.substr(0, text.find('=')), text.substr(text.find('=') + 1)};
    const std::string& name = predictions.name;
    require(!name.empty() && name != "." && name != ".." && !predictions.folder.empty(),
            "--predictions: '" + text + "' is not NAME=DIR");
    require(names.insert(name).second, "--predictions: there are two methods '" + name + "'");
    options.predictions.push_back(predictions);
  }
}

/// Writing the labels of a method over the truth or over those that are imported, or anything over the sensor model,
/// would destroy the user's files.
void keepInputs(const EvalOptions& options) {
  namespace fs = std::filesystem;
  if (options.out.empty()) return;
  for (const Method& method : evalMethods(options)) {
    const std::string target = (fs::path(options.out) / "labels" / method.name).string();
    for (const Predictions& predictions : options.predictions)
      require(!isWithin(predictions.folder, target),
              "--predictions: " + predictions.folder + " would be overwritten; choose another NAME or --out");
    for (const std::string& dataset : options.datasets)
      require(!isWithin(datasetPath(dataset), target),
              "DATASET: " + dataset + " would be overwritten, for " + target + " is its folder; choose another --out");
  }
  if (!isNoiseFile(options.noise)) return;
  bool is_output = isWithin(options.noise, (fs::path(options.out) / "results").string());
  for (const char* name : {"run.json", "summary.json"})
    is_output |= filePlace(options.noise) == filePlace((fs::path(options.out) / name).string());
  require(!is_output, "--noise: " + options.noise + " would be overwritten; choose another --out");
}

constexpr int kMaxLag = 10000;
constexpr double kMinTimeout = 0.001, kMaxTimeout = 1e6;

/// Lags from "5,25,75", each once.
void setLags(const std::string& list, EvalOptions& options) {
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const bool is_number =
        !word.empty() && word.size() < 6 && word.find_first_not_of("0123456789") == std::string::npos;
    const int lag = is_number ? std::stoi(word) : 0;
    require(lag >= 1 && lag <= kMaxLag,
            "--repeatability: '" + word + "' is no number of frames from 1 to " + std::to_string(kMaxLag));
    std::vector<int>& lags = options.repeatability_lags;
    require(std::find(lags.begin(), lags.end(), lag) == lags.end(), "--repeatability: " + word + " is named twice");
    lags.push_back(lag);
  }
}

/// What belongs to frames that are scored one by one, in any order.
void refuseScoring(const RawOptions& raw, const EvalOptions& options) {
  const std::string words = " does not go with --repeatability";
  require(!options.resume, "--resume" + words);
  require(!options.overlays, "--overlays" + words);
  require(raw.shard == "1/1", "--shard" + words);
  require(options.frame_timeout == 0.0, "--frame-timeout" + words);
  require(!options.no_times, "--no-times" + words);
  require(options.jobs == 1, "--jobs" + words + ": frames are taken in their order");
}

void setOptions(const RawOptions& raw, EvalOptions& options) {
  options.datasets = raw.datasets;
  setMethods(raw.methods, options);
  setPredictions(raw, options);
  require(!options.datasets.empty(), "name at least one DATASET");
  require(!options.methods.empty() || !options.predictions.empty(), "there is no method to score");
  setLags(raw.lags, options);
  if (!options.repeatability_lags.empty()) refuseScoring(raw, options);
  require(!options.overlays || !options.out.empty(), "--overlays needs --out");
  require(!options.resume || !options.out.empty(), "--resume needs --out");
  const std::optional<Shard> shard = parseShard(raw.shard);
  require(shard.has_value(), "--shard: '" + raw.shard + "' is not I/N with I from 1 to N");
  options.shard = *shard;
  std::string misread;
  options.reading = readingOptions(raw.reading, misread);
  require(misread.empty(), misread);
  keepInputs(options);
  options.jobs = threadsFor(options.jobs);
}

void addOptions(CLI::App& app, EvalOptions& options, RawOptions& raw) {
  raw.methods = joined(segmenterNames(), ",");
  app.add_option("DATASET", raw.datasets, "FOLDER or FORMAT:FOLDER, FORMAT one of " + joined(formatNames()))
      ->type_name("")
      ->check(checkPath);
  app.add_option("--methods", raw.methods, "Methods, or none (" + raw.methods + ")")->type_name("A,B,...");
  app.add_option("--predictions", raw.predictions,
                 "Label images DIR/NAME_labels.png of another program, scored as method NAME")
      ->type_name("NAME=DIR ...");
  app.add_option("--noise", options.noise,
                 "Sensor: PRESET | A,B,L[,C] | poly:K1,K2,K3 | FILE.json | auto (else the frame's own, else auto)")
      ->type_name("NOISE")
      ->check(noiseProblem);
  app.add_option("--out", options.out, "Folder for the report, the results frame by frame, and labels/METHOD/")
      ->type_name("DIR")
      ->check(checkPath);
  app.add_option("--jobs", options.jobs, "Frames at a time, 0 = one a core (1; more disturb the times)")
      ->type_name("J")
      ->check(CLI::Range(0, 1024));
  app.add_option("--shard", raw.shard, "Only part I of N: every N-th frame from the I-th on; see epcc_eval merge")
      ->type_name("I/N");
  app.add_flag("--resume", options.resume, "Go on with the run in --out; what is done stays");
  app.add_option("--seeds", options.seeds, "Runs of methods that draw at random, as NAME, NAME-seed1, ... (1)")
      ->type_name("S")
      ->check(CLI::Range(1, 1000));
  app.add_option("--frame-timeout", options.frame_timeout,
                 "A frame that takes longer is an error and is given up; J processes then do the frames (none)")
      ->type_name("SECONDS")
      ->check(within(kMinTimeout, kMaxTimeout));
  app.add_flag("--no-times", options.no_times, "Leave times out: the same frames give the same files to the byte");
  app.add_flag("--overlays", options.overlays, "A picture of each frame: depth, truth, every method");
  app.add_option("--pictures", options.pictures,
                 "So many first, worst and best frames of each data set in report.html (2)")
      ->type_name("N")
      ->check(CLI::Range(0, 1000));
  addReadingArguments(app, raw.reading);
  app.add_option("--repeatability", raw.lags,
                 "Instead of scores: what frames i and i + LAG of a sequence with poses have in common")
      ->type_name("LAG,LAG,...")
      ->check([](const std::string& text) { return text.empty() ? "LAG is empty" : ""; });
  app.add_flag("--strict", options.strict, "Exit code 3 if any frame could not be scored");
}

}  // namespace

std::optional<int> parseEvalOptions(int argc, const char* const* argv, EvalOptions& options, std::ostream& out,
                                    std::ostream& err) {
  CLI::App app(kDescription, "epcc_eval");
  app.footer(presetLine("PRESET") + kFooter);
  app.set_version_flag("--version", versionText("epcc_eval"));
  RawOptions raw;
  addOptions(app, options, raw);
  return parseCommandLine(app, argc, argv, out, err, [&] { setOptions(raw, options); });
}

}  // namespace epcc
