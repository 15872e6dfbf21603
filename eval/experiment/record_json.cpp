// SPDX-License-Identifier: BSD-3-Clause
// A record with an error has its words only: it adds to no number.
#include "eval/experiment/record_json.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "datasets/support/input_error.h"
#include "eval/measures/measure_fields.h"

namespace epcc {

namespace {

constexpr std::uint64_t kLargestNumber = 1'000'000'000'000'000;

/// Counts, pixels, millionths and micrometres of one frame.
long wholeNumber(const nlohmann::json& json, const char* name) {
  const nlohmann::json& value = json.at(name);
  // nlohmann keeps what is not below zero as unsigned, and as a double what is too large or no whole number.
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kLargestNumber)
    throw InputError("record", name, "is no whole number from 0 to 10^15");
  return value.get<long>();
}

}  // namespace

nlohmann::ordered_json toJson(const FrameRecord& record) {
  nlohmann::ordered_json json = {{"method", record.method}};
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

FrameRecord recordFromJson(const nlohmann::json& json, const std::string& dataset, const std::string& frame) {
  FrameRecord record{dataset, frame, json.at("method"), {}, {}, json.value("error", "")};
  if (!record.error.empty()) return record;
  for (const auto* fields : {&countFields(), &furtherFields()})
    for (const MeasureField& field : *fields) field.of(record.measures) = wholeNumber(json, field.name);
  // One table gives both pairs of numbers.
  record.measures.instances.surfaces = record.measures.paper.surfaces;
  record.measures.instances.clusters = record.measures.paper.clusters;
  if (json.contains("microseconds")) record.ms = 1e-3 * static_cast<double>(wholeNumber(json, "microseconds"));
  record.doubt = json.value("doubt", "");
  return record;
}

}  // namespace epcc
