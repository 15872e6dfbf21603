// SPDX-License-Identifier: BSD-3-Clause
// Frames of the .mat: depth by index, labels from its data set "planes" or from the folder planes/ beside it.
#include "datasets/nyu_mat.h"

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "datasets/dataset_registry.h"
#include "datasets/depth_image_folder.h"
#include "datasets/folder_listing.h"
#include "datasets/input_error.h"
#include "datasets/mat_images.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

const char kFile[] = "nyu_depth_v2_labeled.mat";

std::string matFile(const std::string& path) {
  std::error_code code;
  return fs::is_directory(path, code) ? (fs::path(path) / kFile).string() : path;
}

}  // namespace

bool isNyuMat(const std::string& path) {
  std::error_code code;
  const std::string file = matFile(path);
  return endsIn(file, ".mat") && fs::is_regular_file(file, code);
}

#ifndef EPCC_HAVE_HDF5

std::unique_ptr<FrameSource> openNyuMat(const std::string& path) {
  throw InputError(path, "format", "this build has no HDF5 and cannot read .mat files (libhdf5-dev)");
}

#else

namespace {

const char kPlanesFolder[] = "planes";
constexpr int kWidth = 640, kHeight = 480;
// The colour camera's calibration of the data set's toolbox; depth is registered to it.
constexpr PinholeCamera kCamera = {kWidth, kHeight, 518.85790117, 519.46961112, 325.58244941, 253.73616633};
constexpr float kFarthest = 9.99F;  // metres; the data set's toolbox clamps at 10 m

class NyuMat : public FrameSource {
 public:
  explicit NyuMat(const std::string& path);
  const std::string& dataset() const override { return dataset_; }
  std::size_t size() const override { return frames_.size(); }
  std::string name(std::size_t index) const override;
  LabelledFrame read(std::size_t index) const override;

 private:
  struct Frame {
    std::size_t number;      // in the file, from 0
    std::string label_file;  // in planes/, empty for none
  };
  void listFrames();

  std::string planes_folder_;
  std::string dataset_;
  MatFile file_;
  MatImages depths_;
  std::optional<MatImages> planes_;
  std::vector<Frame> frames_;
};

/// Four digits from 1, as MATLAB counts.
std::string numberText(std::size_t number) {
  const std::string digits = std::to_string(number + 1);
  return std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
}

NyuMat::NyuMat(const std::string& path)
    : planes_folder_((fs::path(matFile(path)).parent_path() / kPlanesFolder).string()),
      dataset_(folderName(path)),
      file_(matFile(path)),
      // What was measured; `depths` has its holes filled in.
      depths_(file_, file_.has("rawDepths") ? "rawDepths" : "depths", kWidth, kHeight) {
  if (file_.has(kPlanesFolder)) {
    planes_.emplace(file_, kPlanesFolder, kWidth, kHeight);
    if (planes_->count() != depths_.count())
      throw InputError(file_.path(), kPlanesFolder, "has not as many images as the depth");
  }
  listFrames();
}

void NyuMat::listFrames() {
  std::error_code code;
  const bool labelled_by_files = !planes_ && fs::is_directory(planes_folder_, code);
  for (std::size_t number = 0; number < depths_.count(); ++number) {
    std::string file;
    for (const char* ending : {".png", ".npy"}) {
      if (!labelled_by_files || !file.empty()) break;
      const std::string candidate = numberText(number) + ending;
      if (fs::exists(fs::path(planes_folder_) / candidate, code)) file = candidate;
    }
    if (!labelled_by_files || !file.empty()) frames_.push_back({number, file});
  }
  if (frames_.empty())
    throw InputError(planes_folder_, "folder", "has no label image NNNN.png or NNNN.npy, numbered from 0001");
}

std::string NyuMat::name(std::size_t index) const {
  return "nyu_" + numberText(frames_.at(index).number);
}

LabelledFrame NyuMat::read(std::size_t index) const {
  const Frame& which = frames_.at(index);
  LabelledFrame frame;
  frame.name = name(index);
  frame.camera.camera = kCamera;
  frame.camera.depth_scale = 0.0002;  // metres; 16 bits hold the whole range
  frame.camera.noise = "kinect-v1";
  frame.depth = depths_.readFloats(which.number);
  for (float& z : frame.depth.data)
    if (!(z > 0.0F && z < kFarthest)) z = 0.0F;
  if (planes_) frame.labels = planes_->readLabels(which.number);
  if (!which.label_file.empty())
    frame.labels = readLabelFile((fs::path(planes_folder_) / which.label_file).string(), kWidth, kHeight);
  return frame;
}

}  // namespace

std::unique_ptr<FrameSource> openNyuMat(const std::string& path) {
  return std::make_unique<NyuMat>(path);
}

#endif

}  // namespace epcc
