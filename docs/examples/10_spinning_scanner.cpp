// SPDX-License-Identifier: BSD-3-Clause
// Columns of a spinning scanner as they come: planes are printed as they are finished. Needs Eigen alone.
#include <epcc_segmentation/scan_line_stream.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kColumns = 900;  // a turn, clockwise

/// One column of a room of 8 x 6 m, 1.5 m above its floor: a range for each ring, metres, with 1 cm of noise.
std::vector<float> measure(double azimuth, const std::vector<double>& elevations, std::mt19937& random) {
  const double x = std::cos(azimuth), y = std::sin(azimuth);
  const double wall = 1.0 / std::max({x / 5.0, -x / 3.0, y / 2.5, -y / 3.5});
  std::vector<float> ranges;
  for (const double elevation : elevations) {
    const double floor = elevation < 0.0 ? -1.5 / std::sin(elevation) : 1e9;
    double normal = -6.0;
    for (int i = 0; i < 12; ++i) normal += static_cast<double>(random()) / 4294967296.0;
    ranges.push_back(static_cast<float>(std::min(wall / std::cos(elevation), floor) + 0.01 * normal));
  }
  return ranges;
}

}  // namespace

int main() {
  std::vector<double> elevations;  // 32 rings, from 10 degrees up to 30 degrees down
  for (int ring = 0; ring < 32; ++ring) elevations.push_back((10.0 - 40.0 * ring / 31.0) * kPi / 180.0);

  epcc::StreamOptions options;
  options.sensor = epcc::SensorModel::axial(0.01, 0.0);  // 1 cm at any range
  epcc::ScanLineStream stream(epcc::StreamGeometry::scanner(elevations, -2.0 * kPi / kColumns), options);

  stream.onPlane([](const epcc::StreamPlane& found) {
    const auto& p = found.plane.coefficients;  // x forward, y left, z up
    std::printf("columns %4d to %4d: plane %d, normal (%5.2f %5.2f %5.2f), %.2f m away, %zu points%s\n",
                static_cast<int>(found.first_line), static_cast<int>(found.last_line), static_cast<int>(found.id), p(0),
                p(1), p(2), p(3), found.plane.pixel_count, found.is_cut ? ", goes on" : "");
  });
  int labelled = 0;
  stream.onLine([&labelled](const epcc::LabelledLine& line) {  // the labels of each column, final
    for (const epcc::LabelRun& run : line) labelled += run.last - run.first + 1;
  });

  std::mt19937 random(0);
  for (int column = 0; column < 2 * kColumns; ++column) {
    const double azimuth = std::remainder(-2.0 * kPi * column / kColumns, 2.0 * kPi);
    if (!stream.addColumnAt(azimuth, measure(azimuth, elevations, random).data()))
      std::fprintf(stderr, "%s\n", stream.error().c_str());  // a column that came late, say: it is left out
  }
  stream.finish();  // hands out what is still open
  std::printf("%d of %d points lie on planes\n", labelled, 2 * kColumns * 32);
}

// Prints:
//   columns    0 to   87: plane 1, normal (-1.00  0.00 -0.00), 5.00 m away, 1621 points
//   columns   11 to  138: plane 2, normal ( 0.00 -0.00  1.00), 1.50 m away, 1269 points
//   columns   88 to  326: plane 3, normal ( 0.00  1.00  0.00), 3.50 m away, 5299 points
//   columns  312 to  347: plane 4, normal ( 0.00  0.00  1.00), 1.50 m away, 230 points
//   columns  327 to  550: plane 5, normal ( 1.00  0.00  0.00), 3.00 m away, 5530 points
//   columns  551 to  834: plane 6, normal (-0.00 -1.00  0.00), 2.50 m away, 7567 points
//   columns  835 to  987: plane 8, normal (-1.00  0.00  0.00), 5.00 m away, 2728 points
//   columns  811 to 1050: plane 7, normal ( 0.00 -0.00  1.00), 1.50 m away, 2230 points
//   columns  988 to 1227: plane 9, normal ( 0.00  1.00 -0.00), 3.50 m away, 5300 points
//   columns 1202 to 1247: plane 10, normal (-0.00  0.00  1.00), 1.50 m away, 257 points
//   columns 1228 to 1450: plane 11, normal ( 1.00 -0.00  0.00), 3.00 m away, 5489 points
//   columns 1451 to 1734: plane 12, normal (-0.00 -1.00  0.00), 2.50 m away, 7622 points
//   columns 1705 to 1799: plane 13, normal (-0.00 -0.00  1.00), 1.50 m away, 883 points
//   columns 1735 to 1799: plane 14, normal (-1.00  0.00 -0.00), 5.00 m away, 1207 points
//   47232 of 57600 points lie on planes
