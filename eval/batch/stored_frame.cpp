// SPDX-License-Identifier: BSD-3-Clause
// A frame's records are one JSON file; one that is damaged counts as not done.
#include "eval/batch/stored_frame.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "datasets/support/atomic_file.h"
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
                                     const std::vector<std::string>& methods) {
  std::ifstream file(storedFramePath(out, dataset, index), std::ios::binary);
  if (!file) return std::nullopt;
  try {
    const Json json = Json::parse(file);
    StoredFrame frame;
    if (json.at("version") != kStoredVersion || json.at("index") != index) return std::nullopt;
    frame.index = index;
    frame.file_name = json.at("file_name");
    for (const Json& record : json.at("records"))
      frame.records.push_back(recordFromJson(record, dataset, json.at("frame")));
    if (frame.records.empty() || !areOf(methods, frame.records)) return std::nullopt;
    return frame;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace epcc
