// SPDX-License-Identifier: BSD-3-Clause
// Logs of CARMEN, packed or not.
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/scan_check.h"
#include "tests/fuzz/targets.h"
#include "tests/support/gzip_bytes.h"

namespace epcc::fuzz {
namespace {

bool runCarmenLog(const std::uint8_t* data, std::size_t size) {
  bool has_scans = false;
  takesFile(data, size, [&](const std::string& path) {
    const LaserLog log = readCarmenLog(path);
    checkLog(log);
    has_scans = !log.records.empty();
  });
  return has_scans;
}

std::vector<std::string> carmenLogSeeds() {
  const std::string flaser = "FLASER 3 1.5 2.5 81.83 0.1 0.2 0.3 1 2 3 10.5 host 10.6\n";
  const std::string robot =
      "ROBOTLASER1 0 -1.5 3.0 0.5 20 0.01 0 4 1 2 30 nan 2 7 8 0.5 0.6 0.7 1 2 3 0 0 0 0 0 99.5 host 99.6\n";
  const std::string raw = "RAWLASER1 0 -1.0 2.0 1.0 50 0.01 0 3 1 2 3 0 12.25 host 12.5\n";
  std::string repeated;
  for (int i = 0; i < 11; ++i) repeated += flaser;
  return {"# comment\nODOM 0 0 0 0 0 0 0.1 h 0.1\n" + flaser, robot, raw, repeated, test::packed(flaser + robot + raw)};
}

}  // namespace

const FuzzTarget kCarmenLog{runCarmenLog, carmenLogSeeds};

}  // namespace epcc::fuzz
