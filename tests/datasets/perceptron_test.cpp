// SPDX-License-Identifier: BSD-3-Clause
// Perceptron scans: the geometry, the files, and planes that come out flat.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "datasets/dataset_registry.h"
#include "datasets/expect_errors.h"
#include "datasets/perceptron_folder.h"
#include "epcc_segmentation/plane_extractor.h"
#include "segcomp_files.h"

namespace epcc::test {
namespace {

class Perceptron : public TempFolderTest {
 protected:
  void writeUnit() const { write("perceptron.json", R"({"metres_per_unit": 0.01})"); }
  LabelledFrame only() const {
    const PerceptronFolder frames(folder());
    EXPECT_EQ(frames.size(), 1U);
    return frames.read(0);
  }
};

/// Values worked out apart from this code, by the formulas of range-to-coords.c.
TEST_F(Perceptron, GeometryIsThatOfTheComparison) {
  EXPECT_LT((perceptronPoint(0, 0, 0) - Eigen::Vector3d(75.581497, 47.210334, 143.456863)).norm(), 1e-5);
  EXPECT_LT((perceptronPoint(511, 100, 4095) - Eigen::Vector3d(270.997099, -301.833831, 910.751733)).norm(), 1e-5);
  EXPECT_LT((perceptronPoint(100, 300, 1234) - Eigen::Vector3d(-33.126916, 80.559708, 408.576218)).norm(), 1e-5);
}

TEST_F(Perceptron, FrameIsTheScanTurnedByAQuarter) {
  writeUnit();
  write("perc.test.0.Z", "");
  write("perc.test.x", "");
  write("perc.test.0", perceptronScan([](int row, int column) { return row == 7 && column == 3 ? 0 : 900; }));
  write("perc.test.0.gt-seg",
        sunRaster([](int row, int column) { return row == 20 && column == 40 ? 9 : 10 + row / 256; }));
  const LabelledFrame frame = only();
  EXPECT_EQ(frame.depth.at(3, 511 - 7), 0.0F);
  EXPECT_FALSE(std::isfinite(frame.scan[3 * (3 * 512 + 511 - 7)]));
  EXPECT_EQ(frame.labels.at(3, 511 - 7), 0);
  EXPECT_EQ(frame.labels.at(40, 511 - 20), 0);
  EXPECT_EQ(frame.labels.at(40, 511 - 21), 10);
  EXPECT_EQ(frame.labels.at(40, 511 - 300), 11);
  const Eigen::Vector3d seen = 0.01 * perceptronPoint(100, 300, 900);
  Eigen::Vector3d point;
  ASSERT_TRUE(frameView(frame).point(300, 411, point));
  EXPECT_LT((point - Eigen::Vector3d(seen.z(), -seen.y(), seen.x())).norm(), 1e-5);
  EXPECT_NEAR(frame.depth.at(300, 411), seen.norm(), 1e-5);
  EXPECT_EQ(detectProjection(frame.scan.data(), 3, 512, 512), Projection::Spherical);
}

/// A corner of three planes as the scanner would see it, in units of 1 cm.
struct Corner {
  const Eigen::Vector4d planes[3] = {{0.0, 0.9578262852, -0.2873478856, 150.0},  // below
                                     {0.7071067812, 0.0, -0.7071067812, 300.0},  // left
                                     {-0.6, 0.0, -0.8, 330.0}};                  // right
  /// Range in counts and number of the nearest plane.
  std::pair<double, int> seen(int row, int column) const {
    const Eigen::Vector3d start = perceptronPoint(row, column, 0.0), step = perceptronPoint(row, column, 1.0) - start;
    std::pair<double, int> nearest{4095.0, 0};
    for (int i = 0; i < 3; ++i) {
      const double range = -(planes[i].head<3>().dot(start) + planes[i](3)) / planes[i].head<3>().dot(step);
      if (range > 0.0 && range < nearest.first) nearest = {range, i + 1};
    }
    return nearest;
  }
};

TEST_F(Perceptron, PlanesOfAScannedCornerAreFound) {
  const Corner corner;
  writeUnit();
  write("perc.train.12",
        perceptronScan([&](int r, int c) { return static_cast<int>(std::lround(corner.seen(r, c).first)); }));
  write("perc.train.12.gt-seg", sunRaster([&](int r, int c) { return 10 * corner.seen(r, c).second; }));
  const auto frames = openDataset(folder());
  const LabelledFrame frame = frames->read(0);
  ASSERT_EQ((std::set<std::uint16_t>(frame.labels.data.begin(), frame.labels.data.end())),
            (std::set<std::uint16_t>{10, 20, 30}));
  PlaneExtractor extractor(Parameters(), SensorModel::parse("0.003,0,1").value());
  PlaneSegmentation found;
  ASSERT_TRUE(extractor.extract(frameView(frame), found)) << extractor.error();
  EXPECT_EQ(found.planes.size(), 3U);
  std::set<std::pair<int, int>> pairs;
  std::size_t labelled = 0;
  for (std::size_t i = 0; i < found.labels.size(); ++i) {
    if (found.labels[i] == 0) continue;
    ++labelled;
    const int row = static_cast<int>(i / 512), column = static_cast<int>(i % 512);
    const bool inside = row > 0 && column > 0 && row < 511 && column < 511;
    if (inside && frame.labels.at(row - 1, column - 1) == frame.labels.at(row + 1, column + 1) &&
        frame.labels.at(row + 1, column - 1) == frame.labels.at(row - 1, column + 1))
      pairs.insert({static_cast<int>(found.labels[i]), frame.labels.at(row, column)});
  }
  EXPECT_GT(labelled, 512U * 512U * 95U / 100U);
  EXPECT_LE(pairs.size(), 6U) << "planes and labels belong together but for pixels at the edges";
}

TEST_F(Perceptron, LengthOfAUnitMustBeSaid) {
  write("perc.train.12", perceptronScan([](int, int) { return 1; }));
  EXPECT_TRUE(isPerceptronFolder(folder()));
  const auto open = [&] { openDataset(folder()); };
  expectInputError(open, path("perceptron.json"), "file", "metres_per_unit");
  write("perceptron.json", "{}");
  expectInputError(open, path("perceptron.json"), "metres_per_unit", "is missing");
  write("perceptron.json", R"({"metres_per_unit": 1e300})");
  expectInputError(open, path("perceptron.json"), "metres_per_unit", "more than 1");
}

TEST_F(Perceptron, OtherFilesAreErrors) {
  writeUnit();
  const std::string good = perceptronScan([](int, int) { return 1; });
  const auto read = [&] { only(); };
  const std::string file = write("perc.train.12", good.substr(0, 1000));
  expectInputError(read, file, "data", "shorter");
  write("perc.train.12", good + std::string(10000, ' '));
  expectInputError(read, file, "data", "longer");
  write("perc.train.12", "word " + good);
  expectInputError(read, file, "header", "Perceptron");
  write("perc.train.12", good.substr(1) + "x");
  expectInputError(read, file, "header", "Perceptron");
}

}  // namespace
}  // namespace epcc::test
