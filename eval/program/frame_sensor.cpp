// SPDX-License-Identifier: BSD-3-Clause
// The user's choice goes first, then what the frame says, then what is measured on it.
#include "eval/program/frame_sensor.h"

#include "datasets/support/input_error.h"
#include "epcc_segmentation/sensor_estimation.h"

namespace epcc {

namespace {
const char kAuto[] = "auto";
}

std::string noiseProblem(const std::string& text) {
  if (text == kAuto) return {};
  std::string why;
  if (SensorModel::parse(text, &why)) return {};
  const bool is_unknown = why.find("is neither a preset") != std::string::npos;
  return is_unknown ? why + ", nor auto" : why;
}

FrameSensor frameSensor(const std::string& chosen, const std::optional<std::string>& of_frame, const DepthFrame& frame,
                        const std::string& camera_file) {
  const std::string& text = !chosen.empty() ? chosen : of_frame.value_or(kAuto);
  if (text == kAuto) {
    const SensorModel model = estimateSensor(frame).model();
    return {model, "auto (" + model.description() + ")"};
  }
  std::string why;
  const std::optional<SensorModel> model = SensorModel::parse(text, &why);
  if (!model) throw InputError(camera_file, "noise", why);
  return {*model, text};
}

}  // namespace epcc
