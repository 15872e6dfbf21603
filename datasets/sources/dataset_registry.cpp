// SPDX-License-Identifier: BSD-3-Clause
// A new format is a line in the table here.
#include "datasets/sources/dataset_registry.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "datasets/sources/abw_folder.h"
#include "datasets/sources/labelled_cloud.h"
#include "datasets/sources/native_folder.h"
#include "datasets/sources/scannet_folder.h"
#include "datasets/sources/tum_folder.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"
#include "datasets/support/joined.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

bool never(const std::string&) {
  return false;
}
/// A cloud with a JSON beside it; folders of clouds alone have no JSON at all, or few.
bool hasScans(const std::string& path) {
  if (anyFileEndingIn(path, ".pcd").empty() || anyFileEndingIn(path, ".json").empty()) return false;
  return !listLabelledFrames(path).empty();
}
bool isNativeFolder(const std::string& path) {
  return !anyFileEndingIn(path, "_depth.png").empty() || hasScans(path);
}
bool isCloudFolder(const std::string& path) {
  return !anyFileEndingIn(path, ".pcd").empty();
}

template <typename Source>
std::unique_ptr<FrameSource> open(const std::string& path) {
  return std::make_unique<Source>(path);
}

/// The parts of FORMAT:PATH; `format` stays null where no format is named.
struct FormatAndPath {
  const DatasetFormat* format = nullptr;
  std::string path;
  std::string unknown;  ///< what looks like a format and is none
};

bool looksLikeFormat(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

FormatAndPath splitDatasetText(const std::string& text) {
  FormatAndPath named;
  named.path = text;
  const std::size_t colon = text.find(':');
  std::error_code code;
  if (colon == std::string::npos || fs::exists(text, code)) return named;
  const std::string word = text.substr(0, colon);
  if (!looksLikeFormat(word)) return named;
  for (const DatasetFormat& format : datasetFormats())
    if (format.name == word) named.format = &format;
  if (named.format == nullptr)
    named.unknown = word;
  else
    named.path = text.substr(colon + 1);
  return named;
}

}  // namespace

const std::vector<DatasetFormat>& datasetFormats() {
  static const std::vector<DatasetFormat> formats = {
      {"native", "NAME_depth.png or NAME.pcd, NAME_labels.png, NAME.json", isNativeFolder, open<NativeFolder>},
      {"abw", "SegComp ABW, Sun raster", isAbwFolder, open<AbwFolder>},
      {"scannet", "ScanNet scene: depth/, intrinsic/", isScannetFolder, openScannetFolder},
      {"tum", "TUM RGB-D or ICL-NUIM, camera by the folder's name", isTumFolder, openTumFolder},
      {"tum-fr1", "TUM RGB-D, Freiburg 1", never, openTumFreiburg1},
      {"tum-fr2", "TUM RGB-D, Freiburg 2", never, openTumFreiburg2},
      {"tum-fr3", "TUM RGB-D, Freiburg 3", never, openTumFreiburg3},
      {"icl", "ICL-NUIM in TUM's layout", never, openIclFolder},
      {"pcd", "organized PCD, labels in a field label or intensity", isCloudFolder, open<LabelledCloudFolder>},
  };
  return formats;
}

std::vector<std::string> formatNames() {
  std::vector<std::string> names;
  for (const DatasetFormat& format : datasetFormats()) names.push_back(format.name);
  return names;
}

bool namesFormat(const std::string& text) {
  const FormatAndPath named = splitDatasetText(text);
  return named.format != nullptr || !named.unknown.empty();
}

std::unique_ptr<FrameSource> openDataset(const std::string& text) {
  const FormatAndPath named = splitDatasetText(text);
  if (!named.unknown.empty())
    throw InputError(text, "format", "there is none called '" + named.unknown + "', only " + joined(formatNames()));
  if (named.path.empty()) throw InputError(text, "folder", "has no name");
  if (named.format != nullptr) return named.format->open(named.path);
  std::error_code code;
  if (!fs::exists(text, code))
    throw InputError(text, "folder",
                     code && code != std::errc::no_such_file_or_directory ? code.message() : "does not exist");
  const fs::directory_iterator listed(text, code);
  if (code == std::errc::permission_denied) throw InputError(text, "folder", code.message());
  for (const DatasetFormat& format : datasetFormats())
    if (format.recognises(text)) return format.open(text);
  throw InputError(text, "folder",
                   "has no frame NAME_depth.png and is none of the known data sets; FORMAT:FOLDER names the format (" +
                       joined(formatNames()) + ")");
}

std::string datasetPath(const std::string& text) {
  return splitDatasetText(text).path;
}

std::string datasetName(const std::string& text) {
  return folderName(datasetPath(text));
}

}  // namespace epcc
