// SPDX-License-Identifier: BSD-3-Clause
// The formats of data sets, and the way from FOLDER or FORMAT:FOLDER to frames.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "datasets/sources/frame_source.h"

namespace epcc {

/// A format of data sets.
struct DatasetFormat {
  std::string name;     ///< what the user writes before the colon
  std::string summary;  ///< what it is, in a few words
  /// Looks at the contents, cheaply; does not throw.
  bool (*recognises)(const std::string& path);
  /// Throws InputError.
  std::unique_ptr<FrameSource> (*open)(const std::string& path);
};

/// All formats, in the order in which they are tried on a folder that comes without a format.
const std::vector<DatasetFormat>& datasetFormats();

/// Their names.
std::vector<std::string> formatNames();

/// True for FORMAT:PATH, known format or not, if nothing exists under the whole name.
bool namesFormat(const std::string& text);

/// Opens PATH, whose format is found out from its contents, or FORMAT:PATH. Something that exists under the whole name
/// is a PATH. Throws InputError in one line: unknown format, nothing recognised, or what the format finds wrong.
std::unique_ptr<FrameSource> openDataset(const std::string& text);

/// PATH of PATH or FORMAT:PATH.
std::string datasetPath(const std::string& text);

/// Name of the data set that openDataset gives: folderName() of its path.
std::string datasetName(const std::string& text);

}  // namespace epcc
