// SPDX-License-Identifier: BSD-3-Clause
// A frame's records are one JSON file; one that is damaged counts as not done.
#include "eval/batch/stored_frame.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/files/camera_json.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"
#include "eval/experiment/record_json.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kStoredVersion = 1;

bool areOf(const std::vector<std::string>& methods, const std::vector<FrameRecord>& records) {
  return std::equal(methods.begin(), methods.end(), records.begin(), records.end(),
                    [](const std::string& method, const FrameRecord& record) { return method == record.method; });
}

/// JSON is UTF-8: what is none comes back as something else.
nlohmann::json asStored(const std::string& text) {
  return nlohmann::json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
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

std::optional<StoredFrame> loadFrame(const std::string& out, const std::string& dataset, std::size_t index,
                                     const std::vector<std::string>& methods, const std::optional<std::string>& name) {
  try {
    const nlohmann::json json = readJsonObject(storedFramePath(out, dataset, index));
    StoredFrame frame;
    if (json.at("version") != kStoredVersion || json.at("index") != index) return std::nullopt;
    if (json.at("dataset") != asStored(dataset) || (name && json.at("frame") != asStored(*name))) return std::nullopt;
    frame.index = index;
    frame.file_name = json.at("file_name");
    for (const nlohmann::json& record : json.at("records"))
      frame.records.push_back(recordFromJson(record, dataset, json.at("frame")));
    if (frame.records.empty() || !areOf(methods, frame.records)) return std::nullopt;
    return frame;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace epcc
