// SPDX-License-Identifier: BSD-3-Clause
// Runs epcc_segment in a folder of its own on tiny inputs made on the spot.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace epcc_test {

/// What a program left.
struct ToolResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// A temporary folder, gone at the end of the test.
class SegmentToolTest : public ::testing::Test {
 protected:
  SegmentToolTest();
  ~SegmentToolTest() override;

  /// Runs the program inside the folder.
  ToolResult run(const std::vector<std::string>& arguments) const;
  /// The same, and checks that it fails as promised: exit code, one line on stderr that starts with the program's
  /// name and contains `words`, nothing on stdout.
  void expectFailure(const std::vector<std::string>& arguments, int exit_code, const std::string& words) const;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  std::string read(const std::string& name) const;
  void write(const std::string& name, const std::string& content) const;
  /// Names of the files in a folder below the temporary one, sorted.
  std::vector<std::string> list(const std::string& folder = ".") const;

  /// NAME_depth.png of a room's corner: back wall at 2 m and floor 0.35 m below the camera, 64x48, and NAME.json.
  void writeFrame(const std::string& name) const;
  void writeDepth(const std::string& name) const;
  void writeCamera(const std::string& name, int width = 64, int height = 48, const std::string& more = "") const;
  /// The same room as an organized ASCII cloud; `flipped` turns it by 180 degrees about x (y up, z to the back).
  void writeCloud(const std::string& name, bool flipped = false) const;
  /// Overwrites a big-endian number or a byte of the PNG header and mends its check sum.
  void patchPngHeader(const std::string& name, std::size_t offset, std::uint32_t value, int bytes) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace epcc_test
