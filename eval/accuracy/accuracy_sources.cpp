// SPDX-License-Identifier: BSD-3-Clause
// Opens the data sets, splits one of them, and makes copies and rendered frames.
#include "eval/accuracy/accuracy_sources.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "datasets/rendered/rendered_scenes.h"
#include "datasets/rendered/scene.h"
#include "datasets/rendered/step_frames.h"
#include "datasets/sources/dataset_registry.h"
#include "datasets/sources/frame_copies.h"
#include "datasets/sources/selected_frames.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace {

const char kSensors[] = "sensors", kLidars[] = "lidars", kScans[] = "synpeb", kSequence[] = "sequence";

/// Data sets of one sensor each, and the first words of the names of the frames of several.
const std::pair<const char*, const char*> kSensorNames[] = {
    {"realsense", "Intel RealSense D4xx"},
    {"kinect", "Kinect v1"},
    {"abw", "ABW structured light"},
    {"icl", "rendered, no error (ICL-NUIM)"},
    {"structure", "structured light, tunnel"},
    {"synpeb", "rendered spherical scanner (SynPEB)"},
    {"faro", "Faro survey laser"},
    {"gemini", "Orbbec Gemini, stereo"},
    {"helios", "Lucid Helios, time of flight"},
    {"k4a", "Azure Kinect"},
    {"l515", "RealSense L515"},
    {"p30tof", "phone, time of flight"},
    {"phoxi", "Photoneo PhoXi"},
    {"ouster", "Ouster OS1-128 lidar"},
    {"hdl64", "Velodyne HDL-64E lidar"},
};

std::unique_ptr<FrameSource> opened(const std::string& folder, const std::string& name,
                                    std::vector<std::string>& problems) {
  try {
    return openDataset((std::filesystem::path(folder) / name).string());
  } catch (const InputError& error) {
    problems.emplace_back(error.what());
    return nullptr;
  }
}

bool isScan(const FrameSource& source, std::size_t index) {
  const std::vector<std::string> files = source.files(index);
  return !files.empty() && hasEnding(files.front(), ".pcd");
}

/// The scans of a source, or the others.
std::unique_ptr<FrameSource> part(const FrameSource& source, const std::string& dataset, bool scans) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < source.size(); ++i)
    if (isScan(source, i) == scans) indices.push_back(i);
  return std::make_unique<SelectedFrames>(source, dataset, std::move(indices));
}

void openFolders(const std::string& folder, AccuracySources& sources, std::vector<std::string>& problems) {
  for (const std::string& name : accuracyDatasets())
    if (namesItsNoise(name))
      if (auto source = opened(folder, name, problems)) sources.named.push_back(std::move(source));
  if (auto source = opened(folder, kSensors, problems)) {
    sources.unnamed.push_back(part(*source, kSensors, false));
    sources.unnamed.push_back(part(*source, kLidars, true));
    sources.folders.push_back(std::move(source));
  }
  if (auto source = opened(folder, kSequence, problems)) sources.sequence.push_back(std::move(source));
}

FrameSources copiesOf(const FrameSources& originals) {
  FrameSources copies;
  for (const auto& original : originals)
    for (const FrameCopy copy : frameCopies())
      if (original->dataset() != kScans && original->dataset() != kLidars)
        copies.push_back(std::make_unique<CopiedFrames>(*original, copy));
  return copies;
}

FrameSources sceneSources(int seeds) {
  FrameSources sources;
  for (const std::string& noise : accuracyNoises())
    for (const std::string& scene : sceneNames())
      sources.push_back(std::make_unique<RenderedFrames>(sceneDataset(scene, noise), 0, seeds,
                                                         sceneWithNoise(scene, parseNoise(noise).value())));
  return sources;
}

FrameSources stepSources(int seeds) {
  FrameSources sources;
  for (const AccuracyStep& step : accuracySteps()) {
    const StepSensor sensor = step.sensor == "realsense" ? realsenseSensor() : kinectSensor();
    const StepScene scene = step.scene == "door" ? doorScene(step.metres) : pictureFrameScene(step.metres);
    sources.push_back(std::make_unique<RenderedFrames>(stepDataset(step), 0, seeds, stepWithNoise(scene, sensor)));
  }
  return sources;
}

}  // namespace

std::vector<std::string> accuracyDatasets() {
  return {"realsense", "kinect", "abw", kSensors, kLidars, "icl", "structure", kScans};
}

bool namesItsNoise(const std::string& dataset) {
  return dataset != kSensors && dataset != kLidars;
}

std::string sensorOf(const std::string& dataset, const std::string& frame) {
  const std::string word = namesItsNoise(dataset) ? dataset : frame.substr(0, frame.find('_'));
  const auto found = std::find_if(std::begin(kSensorNames), std::end(kSensorNames),
                                  [&word](const auto& name) { return word == name.first; });
  return found == std::end(kSensorNames) ? word : found->second;
}

std::vector<std::string> accuracyNoises() {
  return {"white:d435i", "stereo"};
}

std::vector<AccuracyStep> accuracySteps() {
  std::vector<AccuracyStep> steps;
  for (const char* sensor : {"kinect-v1", "realsense"})
    for (const double metres : {0.05, 0.10, 0.15, 0.20}) steps.push_back({"door", sensor, metres});
  for (const char* sensor : {"kinect-v1", "realsense"})
    for (const double metres : {0.01, 0.02, 0.03}) steps.push_back({"frame", sensor, metres});
  return steps;
}

std::string stepDataset(const AccuracyStep& step) {
  return step.scene + "-" + step.sensor + "-" + std::to_string(std::lround(1e3 * step.metres));
}

std::string sceneDataset(const std::string& scene, const std::string& noise) {
  return scene + "-" + noise.substr(0, noise.find(':'));
}

AccuracySources openAccuracySources(const std::string& folder, int scene_seeds, int step_seeds,
                                    std::vector<std::string>& problems) {
  AccuracySources sources;
  openFolders(folder, sources, problems);
  sources.named_copies = copiesOf(sources.named);
  sources.unnamed_copies = copiesOf(sources.unnamed);
  sources.scenes = sceneSources(scene_seeds);
  sources.steps = stepSources(step_seeds);
  return sources;
}

}  // namespace epcc
