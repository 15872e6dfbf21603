// SPDX-License-Identifier: BSD-3-Clause
// Finds out whether each INPUT is a file or a data set, and reads its frames.
#include "eval/segment/segment_input.h"

#include <filesystem>

#include "datasets/files/camera_json.h"
#include "datasets/files/cloud_frame.h"
#include "datasets/files/labelled_frame.h"
#include "datasets/files/png_io.h"
#include "datasets/sources/dataset_registry.h"
#include "datasets/support/folder_listing.h"
#include "eval/program/reading_arguments.h"

namespace epcc {
namespace {

namespace fs = std::filesystem;

const char kDepthEnding[] = "_depth.png";

/// "X" of X_depth.png, else the name without its extension.
std::string frameName(const fs::path& path) {
  const std::string file = path.filename().string();
  if (hasEnding(file, kDepthEnding)) return file.substr(0, file.size() - (sizeof kDepthEnding - 1));
  return path.stem().string();
}

/// Camera of X_depth.png or X.png.
std::string cameraBeside(const fs::path& path) {
  return existingFile((path.parent_path() / (frameName(path) + ".json")).string());
}

SegmentInput fileInput(const std::string& path, const SegmentOptions& options) {
  SegmentInput input;
  input.path = path;
  input.name = frameName(path);
  std::error_code code;
  if (path == "-") {
    input.problem = InputError(path, "standard input", "cannot be read, name a file");
  } else if (!fs::exists(path, code)) {
    input.problem = InputError(path, "file", code ? code.message() : "does not exist");
  } else if (hasEnding(path, ".pcd")) {
    input.is_cloud = true;
  } else if (!hasEnding(path, ".png")) {
    input.problem = InputError(path, "name", "is neither .pcd, .png nor a folder");
  } else if (!options.camera) {
    input.camera_file = options.camera_file.empty() ? cameraBeside(path) : options.camera_file;
  }
  return input;
}

/// The depth images and scans of a folder of native frames as files, for a camera that is not that of their JSON.
std::vector<SegmentInput> nativeFiles(const std::string& folder, const SegmentOptions& options) {
  std::vector<SegmentInput> inputs;
  for (const std::string& name : listLabelledFrames(folder))
    inputs.push_back(fileInput(labelledFrameFile(folder, name), options));
  return inputs;
}

std::vector<SegmentInput> sourceInputs(const std::string& dataset) {
  const std::shared_ptr<const FrameSource> source = openDataset(dataset);
  std::vector<SegmentInput> inputs(source->size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::vector<std::string> files = source->files(i);
    inputs[i].path = files.empty() ? source->name(i) : files.front();
    inputs[i].name = source->name(i);
    inputs[i].source = source;
    inputs[i].index = i;
  }
  return inputs;
}

/// The frames of a data set; one that cannot be opened is an input with a problem.
std::vector<SegmentInput> datasetInputs(const std::string& dataset, const SegmentOptions& options, InputList& list) {
  try {
    if (options.givesCamera()) {
      std::vector<SegmentInput> inputs =
          namesFormat(dataset) ? std::vector<SegmentInput>() : nativeFiles(dataset, options);
      if (inputs.empty())
        list.usage_problem = dataset + ": camera: comes with the data set; --camera and --fx are for depth images";
      return inputs;
    }
    return sourceInputs(dataset);
  } catch (const InputError& error) {
    SegmentInput unusable;
    unusable.path = dataset;
    unusable.problem = error;
    return {unusable};
  }
}

void checkCamera(SegmentInput& input, InputList& list) {
  std::error_code ignored;
  if (input.problem || input.camera_file.empty() || fs::exists(input.camera_file, ignored)) return;
  input.problem = InputError(input.path, "camera", "there is no " + input.camera_file + " beside it");
  if (!list.several)
    list.usage_problem = input.path + ": camera: none given and no " + input.camera_file +
                         "; use --camera or --fx --fy --cx --cy --depth-scale";
}

/// Names the option that none of the inputs has a use for, as far as they can be known.
std::string uselessFor(const std::vector<SegmentInput>& inputs, const SegmentOptions& options) {
  FrameKinds kinds;
  for (const SegmentInput& input : inputs) {
    if (input.problem) return {};
    kinds.add(input.path);
  }
  if (options.givesCamera() && kinds.has_clouds && !kinds.has_depth_images)
    return std::string(options.camera ? "--fx" : "--camera") + " is for depth images, and there are clouds only";
  return uselessOption(options.reading, kinds);
}

CameraFile cameraFor(const SegmentInput& input, const SegmentOptions& options, int width, int height) {
  if (!options.camera) return readCameraJson(input.camera_file);
  CameraFile file;
  file.camera =
      PinholeCamera{width, height, options.camera->fx, options.camera->fy, options.camera->cx, options.camera->cy};
  file.depth_scale = options.camera->depth_scale;
  return file;
}

LabelledFrame readDepthFile(const SegmentInput& input, const SegmentOptions& options) {
  const Image<std::uint16_t> raw = readGray16(input.path);
  LabelledFrame frame;
  frame.name = input.name;
  frame.camera = cameraFor(input, options, raw.width, raw.height);
  const PinholeCamera& camera = frame.camera.camera;
  if (camera.width != raw.width || camera.height != raw.height)
    throw InputError(input.path, "size",
                     sizeText(raw.width, raw.height) + ", but the camera " + input.camera_file + " has " +
                         sizeText(camera.width, camera.height));
  takeDepth(raw, frame);
  return frame;
}

}  // namespace

LabelledFrame loadInput(const SegmentInput& input, const SegmentOptions& options) {
  LabelledFrame frame = input.source     ? input.source->read(input.index)
                        : input.is_cloud ? readCloud(input.path)
                                         : readDepthFile(input, options);
  readAs(frame, options.reading);
  return frame;
}

InputList listInputs(const SegmentOptions& options) {
  if (!options.camera_file.empty()) readCameraJson(options.camera_file);  // once, and whatever the inputs are
  InputList list;
  list.several = options.inputs.size() > 1;
  for (const std::string& input : options.inputs) {
    std::error_code ignored;
    if (fs::is_directory(input, ignored) || namesFormat(input)) {
      list.several = true;
      for (SegmentInput& frame : datasetInputs(input, options, list)) list.inputs.push_back(std::move(frame));
    } else {
      list.inputs.push_back(fileInput(input, options));
    }
  }
  for (SegmentInput& input : list.inputs) checkCamera(input, list);
  if (list.usage_problem.empty()) list.usage_problem = uselessFor(list.inputs, options);
  return list;
}

}  // namespace epcc
