// SPDX-License-Identifier: BSD-3-Clause
// Line segments of laser scans of any ranges and angles, and the error measured on them.
#include <cmath>

#include "epcc_segmentation/laser_line_extractor.h"
#include "epcc_segmentation/range_noise.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/fuzz_settings.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

constexpr int kMostBeams = 400;

LaserLineParameters takeLineParameters(FuzzInput& input) {
  LaserLineParameters parameters;
  parameters.join_hidden = !input.oneIn(4);
  if (input.oneIn(4)) parameters.min_points = input.raw<std::int8_t>();
  if (!input.oneIn(8)) return parameters;
  for (double* number : {&parameters.k_max, &parameters.max_gap, &parameters.max_hidden})
    if (input.oneIn(2)) *number = input.anyNumber();
  return parameters;
}

/// A room of two walls and odd ranges.
LaserScan takeScan(FuzzInput& input) {
  LaserScan scan;
  scan.ranges.resize(static_cast<std::size_t>(input.number(0, kMostBeams)));
  scan.angle_min = input.oneIn(8) ? input.anyNumber() : -1.5;
  scan.angle_increment = input.oneIn(8) ? input.anyNumber() : 0.01 * (1 + input.byte() % 4);
  if (input.oneIn(8)) scan.range_min = input.anyNumber();
  if (input.oneIn(8)) scan.range_max = input.anyNumber();
  const double first = 1.0 + std::abs(input.small()), second = 1.0 + std::abs(input.small());
  const bool has_angles = input.oneIn(4);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = -1.5 + 0.01 * static_cast<double>(i);
    const double c = std::cos(angle), s = std::sin(angle + 0.5);
    const double wall = std::min(c > 0.0 ? first / c : 1e3, s > 0.0 ? second / s : 1e3);
    const std::uint8_t byte = input.byte();
    scan.ranges[i] = byte < 128 ? wall * (1.0 + (byte == 0 ? 0.0 : (byte - 64) / 1024.0)) : FuzzInput::odd(byte - 128);
    if (has_angles) scan.angles.push_back(byte == 127 ? input.anyNumber() : angle);
  }
  if (input.oneIn(16)) scan.angles.resize(3);
  return scan;
}

template <typename Matrix>
void checkSpread(const Matrix& covariance) {
  require(covariance.allFinite(), "a covariance is finite");
  require(covariance.diagonal().minCoeff() >= 0.0, "no variance is negative");
  const double largest = covariance.cwiseAbs().maxCoeff();
  require((covariance - covariance.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * largest, "a covariance is symmetric");
}

void checkLine(const LaserLine& line, int beams) {
  require(line.first >= 0 && line.first < beams && line.last >= 0 && line.last < beams, "a line has its beams");
  require(line.points > 0 && line.points <= beams, "a line has points");
  require(line.start.allFinite() && line.end.allFinite(), "a line is finite");
  require(std::isfinite(line.alpha) && std::abs(line.alpha) < 3.1416, "a direction is one");
  require(std::isfinite(line.rho) && line.rho > 0.0, "a distance is positive");
  require(std::isfinite(line.variance) && line.variance >= 0.0 && std::isfinite(line.chi_squared), "errors are finite");
  checkSpread(line.covariance);
  checkSpread(line.start_covariance);
  checkSpread(line.end_covariance);
}

bool runLaserLines(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  const LaserLineParameters parameters = takeLineParameters(input);
  const SensorModel noise = takeSensor(input).value_or(SensorModel::polynomial(0.0, 0.0, 0.01));
  const LaserScan scan = takeScan(input);
  if (scan.angles.empty() || scan.angles.size() == scan.ranges.size()) {
    const RangeNoiseEstimate estimate = estimateRangeNoise({scan, scan});
    require(estimate.a >= 0.0 && std::isfinite(estimate.a) && estimate.b >= 0.0 && std::isfinite(estimate.b),
            "an error that was measured is one");
  }
  LaserLineExtractor extractor(noise, parameters);
  LaserLines result;
  if (!extractor.extract(scan, result)) {
    require(extractor.status() != Status::Ok && extractor.status() != Status::Failed, "a failure is foreseen");
    requireOneLine(extractor.error());
    require(result.lines.empty(), "a failure has no lines");
    return false;
  }
  require(result.labels.size() == scan.ranges.size(), "each beam has its label");
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    require(result.labels[i] >= 0 && static_cast<std::size_t>(result.labels[i]) <= result.lines.size(),
            "a label's line exists");
    require(result.labels[i] == 0 || scan.hasReturn(i), "only beams with a return have labels");
  }
  for (const LaserLine& line : result.lines) checkLine(line, static_cast<int>(scan.ranges.size()));
  return true;
}

std::vector<std::string> laserLinesSeeds() {
  std::string seed = std::string("\0\0\0", 3);  // the parameters
  seed += std::string("\2\x0a\0\0", 4);         // 10 mm
  seed += std::string("\x90\1\0\0\0\0\0", 7);   // 400 beams
  seed += std::string("\x20\x30\0", 3);         // two walls
  return {seed};
}

}  // namespace

const FuzzTarget kLaserLines{runLaserLines, laserLinesSeeds};

}  // namespace epcc::fuzz
