// SPDX-License-Identifier: BSD-3-Clause
// Runs epcc_segment in a folder of its own on tiny inputs made on the spot.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/run_tool.h"

namespace epcc::test {

class SegmentToolTest : public TempFolderTest {
 protected:
  /// Runs the program inside the folder.
  ToolResult run(const std::vector<std::string>& arguments) const;
  /// The same, and checks that it fails as promised (run_tool.h).
  void expectFailure(const std::vector<std::string>& arguments, int exit_code, const std::string& words) const;

  /// NAME_depth.png of a room's corner: back wall at 2 m and floor 0.35 m below the camera, 64x48, and NAME.json.
  void writeFrame(const std::string& name) const;
  void writeDepth(const std::string& name) const;
  void writeCamera(const std::string& name, int width = 64, int height = 48, const std::string& more = "") const;
  /// The same room as an organized ASCII cloud; `flipped` turns it by 180 degrees about x (y up, z to the back).
  void writeCloud(const std::string& name, bool flipped = false) const;
  /// Overwrites a big-endian number or a byte of the PNG header and mends its check sum.
  void patchPngHeader(const std::string& name, std::size_t offset, std::uint32_t value, int bytes) const;
};

}  // namespace epcc::test
