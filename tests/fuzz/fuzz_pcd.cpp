// SPDX-License-Identifier: BSD-3-Clause
// Organized PCD clouds, with and without labels, and how they were seen.
#include <cmath>

#include "datasets/files/labelled_frame.h"
#include "datasets/files/organized_pcd.h"
#include "datasets/files/pcd_header.h"
#include "datasets/sources/labelled_cloud.h"
#include "tests/datasets/files/pcd_text.h"
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

constexpr std::size_t kSmallCloud = 512;  // larger ones take long to be understood

void checkCloud(const OrganizedCloud& cloud) {
  const std::size_t points = static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height);
  require(cloud.width > 0 && cloud.height > 1, "a cloud is organized");
  require(cloud.xyz.size() == 3 * points, "sizes agree");
  for (const float value : cloud.xyz) require(!std::isinf(value), "no coordinate is infinite");
  for (const double value : cloud.viewpoint) require(std::isfinite(value), "a viewpoint is finite");
}

void checkFrame(const LabelledFrame& frame) {
  const std::size_t points = frame.depth.data.size();
  require(frame.scan.size() == 3 * points, "a frame has its points");
  require(frame.labels.empty() || frame.labels.data.size() == points, "a frame has its labels");
  for (const float depth : frame.depth.data) require(std::isfinite(depth) && depth >= 0.0F, "depths are finite");
  const DepthFrame view = frameView(frame);
  require(view.empty() == (view.status() != Status::Ok), "a view that cannot be used says why");
  if (view.empty()) requireOneLine(view.problem());
}

bool runPcd(const std::uint8_t* data, std::size_t size) {
  return takesFile(data, size, [](const std::string& path) {
    const PcdHeader header = readPcdHeader(path);
    checkCloud(readOrganizedPcd(path));
    if (header.points() <= kSmallCloud) checkFrame(readLabelledCloud(path));
  });
}

/// A header with other fields than x, y and z.
std::string headerWith(test::HeaderLines lines, const std::string& data) {
  lines.emplace_back("DATA", data);
  return test::pcdHeader(lines);
}

std::vector<std::string> pcdSeeds() {
  const test::HeaderLines labelled = {
      {"FIELDS", "x y z label"}, {"SIZE", "4 4 4 4"}, {"TYPE", "F F F U"}, {"COUNT", "1 1 1 1"}};
  const test::HeaderLines padded = {{"FIELDS", "x _ y z intensity"},
                                    {"SIZE", "4 1 8 2 4"},
                                    {"TYPE", "F U F I F"},
                                    {"COUNT", "1 3 1 1 1"},
                                    {"VIEWPOINT", "1 2 3 0 1 0 0"}};
  std::string rows;
  for (int i = 0; i < 6; ++i) rows += std::to_string(i) + " 1 nan " + std::to_string(i + 8) + "\n";
  std::string fields;
  for (int i = 0; i < 18; ++i) test::append(fields, 1.0F + static_cast<float>(i));
  for (std::uint32_t i = 0; i < 6; ++i) test::append(fields, i);
  return {test::asciiPcd(),
          test::binaryPcd(),
          test::compressedPcd(),
          test::asciiPcd({{"VIEWPOINT", "1 2 3 0 1 0 0"}}),
          headerWith(labelled, "ascii") + rows,
          headerWith(padded, "binary") + std::string(6 * (4 + 3 + 8 + 2 + 4), '\x41'),
          headerWith(labelled, "binary_compressed") + test::literalLzf(fields)};
}

}  // namespace

const FuzzTarget kPcd{runPcd, pcdSeeds};

}  // namespace epcc::fuzz
