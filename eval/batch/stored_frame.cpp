// SPDX-License-Identifier: BSD-3-Clause
// A frame's records are one JSON file; one that is damaged counts as not done.
#include "eval/batch/stored_frame.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "datasets/support/atomic_file.h"
#include "datasets/support/output_folder.h"
#include "eval/measures/measure_fields.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kStoredVersion = 1;

Json toJson(const FrameRecord& record) {
  Json json = {{"method", record.method}};
  if (!record.error.empty()) {
    json["error"] = record.error;
    return json;
  }
  for (const auto* fields : {&countFields(), &furtherFields()})
    for (const MeasureField& field : *fields) json[field.name] = field.value(record.measures);
  if (record.ms) json["microseconds"] = std::lround(1e3 * *record.ms);
  if (!record.doubt.empty()) json["doubt"] = record.doubt;
  return json;
}

/// Throws nlohmann's exceptions for what toJson() has not written.
FrameRecord fromJson(const Json& json, const std::string& dataset, const std::string& frame) {
  FrameRecord record{dataset, frame, json.at("method"), {}, {}, json.value("error", "")};
  if (!record.error.empty()) return record;
  for (const auto* fields : {&countFields(), &furtherFields()})
    for (const MeasureField& field : *fields) field.of(record.measures) = json.at(field.name);
  // One table gives both pairs of numbers.
  record.measures.instances.surfaces = record.measures.paper.surfaces;
  record.measures.instances.clusters = record.measures.paper.clusters;
  if (json.contains("microseconds")) record.ms = 1e-3 * json.at("microseconds").get<double>();
  record.doubt = json.value("doubt", "");
  return record;
}

}  // namespace

std::string storedFramePath(const std::string& out, const std::string& dataset, std::size_t index) {
  char name[64];
  std::snprintf(name, sizeof name, "%06zu/%03zu.json", index / 1000, index % 1000);
  return (fs::path(out) / "results" / dataset / name).string();
}

void storeFrame(const std::string& out, const StoredFrame& frame) {
  const FrameRecord& first = frame.records.at(0);
  Json json = {{"version", kStoredVersion}, {"dataset", first.dataset},     {"index", frame.index},
               {"frame", first.frame},      {"file_name", frame.file_name}, {"records", Json::array()}};
  for (const FrameRecord& record : frame.records) json["records"].push_back(toJson(record));
  const std::string path = storedFramePath(out, first.dataset, frame.index);
  makeOutputFolder(fs::path(path).parent_path().string());
  writeTextFile(path, json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<StoredFrame> loadFrame(const std::string& out, const std::string& dataset, std::size_t index) {
  std::ifstream file(storedFramePath(out, dataset, index), std::ios::binary);
  if (!file) return std::nullopt;
  try {
    const Json json = Json::parse(file);
    StoredFrame frame;
    if (json.at("version") != kStoredVersion || json.at("index") != index) return std::nullopt;
    frame.index = index;
    frame.file_name = json.at("file_name");
    for (const Json& record : json.at("records")) frame.records.push_back(fromJson(record, dataset, json.at("frame")));
    if (frame.records.empty()) return std::nullopt;
    return frame;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace epcc
