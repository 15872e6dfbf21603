// SPDX-License-Identifier: BSD-3-Clause
// A record with an error has its words only: it adds to no number.
#include "eval/experiment/record_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "eval/measures/measure_fields.h"

namespace epcc {

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

FrameRecord recordFromJson(const nlohmann::ordered_json& json, const std::string& dataset, const std::string& frame) {
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

}  // namespace epcc
