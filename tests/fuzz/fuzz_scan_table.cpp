// SPDX-License-Identifier: BSD-3-Clause
// Tables of laser scans (CSV), packed or not, by way of the function that tells tables and logs apart.
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/scan_check.h"
#include "tests/fuzz/targets.h"
#include "tests/support/gzip_bytes.h"

namespace epcc::fuzz {
namespace {

bool runScanTable(const std::uint8_t* data, std::size_t size) {
  return takesFile(data, size, [](const std::string& path) {
    const LaserLog log = readLaserLog(path);
    require(!log.records.empty(), "a log that is taken has scans");
    checkLog(log);
  });
}

std::vector<std::string> scanTableSeeds() {
  const std::string ros =
      "%time,field.angle_min,field.angle_max,field.angle_increment,field.range_min,field.range_max,"
      "field.ranges0,field.ranges1,field.ranges2,field.intensities0\n"
      "1500000000000000000,-1.5,1.5,0.5,0.1,30,1,inf,2.5,7\n1500000000100000000,-1.5,1.5,0.5,0.1,30,1,,nan,7\n";
  const std::string own =
      "time,x,y,theta,angle_min,angle_increment,ranges\n0.5,1,2,0.25,-0.5,0.01,1,2,3,4\n\n0.6,1,2,0.25,-0.5,0.01,1\n";
  return {ros, own, test::packed(ros), "FLASER 2 1.5 2.5 0.1 0.2 0.3 1 2 3 10.5 host 10.6\n"};
}

}  // namespace

const FuzzTarget kScanTable{runScanTable, scanTableSeeds};

}  // namespace epcc::fuzz
