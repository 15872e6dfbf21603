// SPDX-License-Identifier: BSD-3-Clause
// Finds the real labelled frames, which are not part of the project.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "data_dir.h"

namespace epcc::test {

/// Folder of a real data set, for example "kinect", or a file below the folder of all of them.
inline std::string realFolder(const std::string& name) {
  return std::string(EPCC_DATA_DIR) + "/" + name;
}
inline bool haveRealFolder(const std::string& name) {
  return std::filesystem::is_directory(realFolder(name));
}

}  // namespace epcc::test

/// Skips the test, saying so, where the real frames are missing.
#define EPCC_NEED_REAL_FRAMES(name)      \
  if (!epcc::test::haveRealFolder(name)) \
  GTEST_SKIP() << "real frames not found: " << epcc::test::realFolder(name) << " (cmake -DEPCC_DATA_DIR=...)"
