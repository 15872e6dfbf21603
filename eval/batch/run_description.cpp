// SPDX-License-Identifier: BSD-3-Clause
// run.json holds what a run was asked to do; two of them are compared before one goes on with the other's results.
#include "eval/batch/run_description.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "datasets/support/joined.h"
#include "datasets/support/text_hash.h"
#include "eval/batch/eval_methods.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/reading_arguments.h"

namespace epcc {

namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr int kVersion = 1;

std::string namesHash(const FrameSource& source) {
  std::uint64_t hash = kTextHashStart;
  for (std::size_t i = 0; i < source.size(); ++i) hash = textHash(source.name(i) + "\n", hash);
  char text[32];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

std::string list(const Words& words) {
  return words.empty() ? "none" : joined(words, ",");
}

std::string differs(const char* what, const std::string& there, const std::string& here) {
  return there == here ? "" : std::string(what) + " was " + there + ", is " + here;
}

std::string timeoutText(const RunDescription& run) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", run.frame_timeout);
  return run.frame_timeout > 0.0 ? text : "none";
}

/// The texts that are not empty, one after the other.
std::string joinedDifferences(Words texts) {
  texts.erase(std::remove(texts.begin(), texts.end(), ""), texts.end());
  return joined(texts, "; ");
}

}  // namespace

RunDescription describeRun(const EvalOptions& options, const std::vector<std::unique_ptr<FrameSource>>& sources,
                           const std::vector<std::string>& unusable) {
  RunDescription run;
  run.program = projectVersion();
  for (const Method& method : evalMethods(options)) run.methods.push_back(method.name);
  for (const Predictions& p : options.predictions) run.predictions.push_back(p.name + "=" + p.folder);
  run.noise = noiseText(options.noise);
  run.reading = readingText(options.reading);
  run.overlays = options.overlays;
  run.times = !options.no_times;
  run.frame_timeout = options.frame_timeout;
  run.pictures = static_cast<std::size_t>(options.pictures);
  run.shard = options.shard;
  for (const auto& source : sources) run.datasets.push_back({source->dataset(), source->size(), namesHash(*source)});
  run.unusable = unusable;
  return run;
}

std::string runDescriptionPath(const std::string& out) {
  return (std::filesystem::path(out) / "run.json").string();
}

void writeRunDescription(const std::string& out, const RunDescription& run) {
  Json json = {{"version", kVersion},       {"program", run.program},
               {"methods", run.methods},    {"predictions", run.predictions},
               {"noise", run.noise},        {"overlays", run.overlays},
               {"reading", run.reading},    {"pictures", run.pictures},
               {"shard", run.shard.text()}, {"datasets", Json::array()},
               {"unusable", run.unusable}};
  if (!run.times) json["times"] = false;
  if (run.frame_timeout > 0.0) json["frame_timeout"] = run.frame_timeout;
  for (const RunDataset& dataset : run.datasets)
    json["datasets"].push_back(
        {{"name", dataset.name}, {"frames", dataset.frames}, {"names_hash", dataset.names_hash}});
  writeTextFile(runDescriptionPath(out), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

RunDescription readRunDescription(const std::string& out) {
  const std::string path = runDescriptionPath(out);
  inputFileSize(path);
  std::ifstream file(path, std::ios::binary);
  try {
    const Json json = Json::parse(file);
    if (json.at("version") != kVersion) throw InputError(path, "version", "is not " + std::to_string(kVersion));
    RunDescription run;
    run.program = json.at("program");
    run.methods = json.at("methods").get<Words>();
    run.predictions = json.at("predictions").get<Words>();
    run.noise = json.at("noise");
    run.reading = json.value("reading", "");
    run.overlays = json.at("overlays");
    run.times = json.value("times", true);
    run.frame_timeout = json.value("frame_timeout", 0.0);
    run.pictures = json.at("pictures");
    const std::optional<Shard> shard = parseShard(json.at("shard"));
    if (!shard) throw InputError(path, "shard", "is not I/N");
    run.shard = *shard;
    for (const Json& dataset : json.at("datasets"))
      run.datasets.push_back({dataset.at("name"), dataset.at("frames"), dataset.at("names_hash")});
    run.unusable = json.at("unusable").get<Words>();
    return run;
  } catch (const Json::exception&) {
    throw InputError(path, "file", "is not the description of a run");
  }
}

std::string optionDifference(const RunDescription& there, const RunDescription& here) {
  const auto noise = [](const RunDescription& run) { return run.noise.empty() ? "the frames' own" : run.noise; };
  const auto reading = [](const RunDescription& run) {
    return run.reading.empty() ? "read without options" : "read with " + run.reading;
  };
  const auto overlays = [](const RunDescription& run) { return std::string(run.overlays ? "on" : "off"); };
  const auto no_times = [](const RunDescription& run) { return std::string(run.times ? "off" : "on"); };
  return joinedDifferences(
      {differs("the version", there.program, here.program),
       differs("--methods", list(there.methods), list(here.methods)),
       differs("--predictions", list(there.predictions), list(here.predictions)),
       differs("--noise", noise(there), noise(here)), differs("the input", reading(there), reading(here)),
       differs("--overlays", overlays(there), overlays(here)), differs("--no-times", no_times(there), no_times(here)),
       differs("--frame-timeout", timeoutText(there), timeoutText(here))});
}

std::string datasetDifference(const RunDataset& there, const RunDataset& here) {
  if (there.frames != here.frames)
    return "data set " + here.name + " had " + std::to_string(there.frames) + " frames, has " +
           std::to_string(here.frames);
  return there.names_hash == here.names_hash ? "" : "the frames of data set " + here.name + " have other names";
}

std::string datasetDifference(const RunDescription& there, const RunDescription& here) {
  const auto names = [](const RunDescription& run) {
    Words words;
    for (const RunDataset& dataset : run.datasets) words.push_back(dataset.name);
    return list(words);
  };
  const std::string names_differ = differs("DATASET", names(there), names(here));
  if (!names_differ.empty()) return names_differ;
  Words texts;
  for (std::size_t i = 0; i < there.datasets.size(); ++i)
    texts.push_back(datasetDifference(there.datasets[i], here.datasets[i]));
  return joinedDifferences(texts);
}

}  // namespace epcc
