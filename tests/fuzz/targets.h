// SPDX-License-Identifier: BSD-3-Clause
// What is fuzzed: functions that take any bytes, with the seeds that a fuzzer begins with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace epcc::fuzz {

struct FuzzTarget {
  /// Whether the bytes gave a result; false if they were refused as they must be. Ends the process where what must
  /// hold does not.
  bool (*run)(const std::uint8_t* data, std::size_t size);
  /// Inputs that give results.
  std::vector<std::string> (*seeds)();
};

// Readers of files.
extern const FuzzTarget kCameraJson;
extern const FuzzTarget kCarmenLog;
extern const FuzzTarget kDepthPng;
extern const FuzzTarget kLabelPng;
extern const FuzzTarget kNpy;
extern const FuzzTarget kParameters;
extern const FuzzTarget kPcd;
extern const FuzzTarget kScanTable;
extern const FuzzTarget kSegcomp;
extern const FuzzTarget kTrajectory;

// The library.
extern const FuzzTarget kCloudGeometry;
extern const FuzzTarget kLaserLines;
extern const FuzzTarget kSegment;
extern const FuzzTarget kStream;
extern const FuzzTarget kSurfaces;
extern const FuzzTarget kTracker;

}  // namespace epcc::fuzz
