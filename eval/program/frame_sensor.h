// SPDX-License-Identifier: BSD-3-Clause
// Which sensor model a frame is segmented with.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// A sensor model and what to call it in a report.
struct FrameSensor {
  SensorModel model;
  std::string name;
  bool is_measured = false;  ///< on the frame: nothing is left to adapt
  Doubts doubts;             ///< of a measured one
};

/// Empty if `text` is "auto", a FILE.json with a key "noise", as epcc_noise writes it, or something SensorModel::parse
/// takes; else what is wrong. InputError naming the file if there is none that can be used.
std::string noiseProblem(const std::string& text);

/// Whether `text` names a FILE.json.
bool isNoiseFile(const std::string& text);

/// `text`, as noiseProblem() takes it, and the model that is in the file now, if it names one: "sensor.json
/// (0.001,0.003,2)". InputError if the file cannot be read.
std::string noiseText(const std::string& text);

/// Line of a help text: "PRESET is one of d435i, ...", with the `word` that the help has for it.
std::string presetLine(const std::string& word);

/// The command line's choice (empty: none), as noiseProblem() takes it, else the frame's own "noise", else "auto":
/// measured on the frame. InputError naming `camera_file` if the frame's own cannot be read.
FrameSensor frameSensor(const std::string& chosen, const std::optional<std::string>& of_frame, const DepthFrame& frame,
                        const std::string& camera_file);

/// What makes this result for a frame doubtful, its file included.
Doubts doubtsAbout(const LabelledFrame& frame, const FrameSensor& sensor, const PlaneSegmentation& result);

/// "5 frames are doubtful; FRAME: what is said of the first".
std::string doubtfulText(std::size_t frames, const std::string& first, const std::string& doubt);

}  // namespace epcc
