// SPDX-License-Identifier: BSD-3-Clause
// What a method did on a frame as JSON of whole numbers: for files, and from one process to another.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "eval/experiment/experiment.h"

namespace epcc {

/// Without the names of data set and frame. Times are kept in whole microseconds.
nlohmann::ordered_json toJson(const FrameRecord& record);

/// Throws InputError or nlohmann's exceptions for what toJson() has not written: numbers that are not whole, below zero
/// or above 10^15 among them.
FrameRecord recordFromJson(const nlohmann::json& json, const std::string& dataset, const std::string& frame);

}  // namespace epcc
