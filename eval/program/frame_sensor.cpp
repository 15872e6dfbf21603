// SPDX-License-Identifier: BSD-3-Clause
// The user's choice goes first, then what the frame says, then what is measured on it.
#include "eval/program/frame_sensor.h"

#include <algorithm>

#include "datasets/files/camera_json.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"
#include "datasets/support/joined.h"
#include "epcc_segmentation/sensor_estimation.h"

namespace epcc {

namespace {

const char kAuto[] = "auto";
const char kFileEnding[] = ".json";

/// "noise" of a file that epcc_noise has written, or of any frame's JSON. Throws InputError.
std::string noiseOfFile(const std::string& path) {
  const nlohmann::json json = readJsonObject(path);
  const auto found = json.find("noise");
  if (found == json.end()) throw InputError(path, "noise", "is missing");
  if (!found->is_string()) throw InputError(path, "noise", "is not a text");
  return found->get<std::string>();
}

}  // namespace

bool isNoiseFile(const std::string& text) {
  return hasEnding(text, kFileEnding);
}

std::string noiseProblem(const std::string& text) {
  if (text == kAuto) return {};
  std::string why;
  if (isNoiseFile(text)) {
    if (!SensorModel::parse(noiseOfFile(text), &why)) throw InputError(text, "noise", why);
    return {};
  }
  if (SensorModel::parse(text, &why)) return {};
  const bool is_unknown = why.find("is neither a preset") != std::string::npos;
  return is_unknown ? why + ", nor auto, nor a FILE.json" : why;
}

std::string noiseText(const std::string& text) {
  return isNoiseFile(text) ? text + " (" + noiseOfFile(text) + ")" : text;
}

std::string presetLine(const std::string& word) {
  return word + " is one of " + joined(SensorModel::presetNames()) + ".\n";
}

FrameSensor frameSensor(const std::string& chosen, const std::optional<std::string>& of_frame, const DepthFrame& frame,
                        const std::string& camera_file) {
  const std::string& text = !chosen.empty() ? chosen : of_frame.value_or(kAuto);
  if (text == kAuto) {
    const SensorEstimate estimate = estimateSensor(frame);
    const SensorModel model = estimate.model();
    return {model, "auto (" + model.description() + ")", true, Doubts::of(frame, estimate)};
  }
  std::string why;
  const bool is_file = !chosen.empty() && isNoiseFile(text);
  const std::optional<SensorModel> model = SensorModel::parse(is_file ? noiseOfFile(text) : text, &why);
  if (!model) throw InputError(is_file ? text : camera_file, "noise", why);
  return {*model, text, false, {}};
}

Doubts doubtsAbout(const LabelledFrame& frame, const FrameSensor& sensor, const PlaneSegmentation& result) {
  const std::vector<float>& depth = frame.depth.data;
  Doubts doubts = sensor.is_measured ? sensor.doubts : result.doubts;
  doubts.bytes_are_swapped = frame.bytes_are_swapped;
  if (std::none_of(depth.begin(), depth.end(), [](float z) { return z > 0.0F; })) doubts.scattered_share = 0.0;
  return doubts;
}

std::string doubtfulText(std::size_t frames, const std::string& first, const std::string& doubt) {
  return std::to_string(frames) + (frames == 1 ? " frame is" : " frames are") + " doubtful; " + first + ": " + doubt;
}

}  // namespace epcc
