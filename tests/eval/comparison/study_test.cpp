// SPDX-License-Identifier: BSD-3-Clause
// The studies' grids, frames and tables.
#include "eval/comparison/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "eval/comparison/line_statistics.h"
#include "eval/comparison/study_catalogue.h"
#include "eval/comparison/study_report.h"

namespace epcc {
namespace {

ComparisonOptions oneScene() {
  ComparisonOptions options;
  options.scenes = {"a"};
  options.noise = parseNoise("white:d435i").value();
  options.seeds = 2;
  return options;
}

TEST(StudyCatalogue, EveryVariantIsValid) {
  const std::size_t variants[] = {16, 16, 4, 2, 6};
  std::size_t i = 0;
  for (const std::string& name : studyNames()) {
    const Study study = makeStudy(name, oneScene());
    EXPECT_EQ(study.name, name);
    EXPECT_EQ(study.variants.size(), variants[i++]);
    for (const StudyVariant& variant : study.variants) {
      const Parameters parameters = variant.parameters(study.frames[0].name);
      EXPECT_EQ(parameters.validate(), "") << name << " " << variant.row;
      EXPECT_EQ(parameters.mode, Mode::Paper);
    }
  }
  EXPECT_THROW(makeStudy("none", oneScene()), std::invalid_argument);
}

TEST(StudyCatalogue, ScenesKeepTable3) {
  const Study study = makeStudy("scan", oneScene());
  EXPECT_EQ(study.variants[0].parameters("a").paper.plane_k_max, 3.0);
  EXPECT_EQ(study.variants[0].parameters("d").paper.plane_k_max, 2.0);
  EXPECT_EQ(study.variants[1].parameters("a").scan, ScanDirection::Rows);
}

TEST(StudyCatalogue, WeightsAreNamedAsOnTheCommandLine) {
  const Study study = makeStudy("weights", oneScene());
  EXPECT_EQ(study.variants[0].row, "printed");
  EXPECT_EQ(study.variants[1].parameters("a").paper.endpoint_weight, EndpointWeight::Exponential);
  EXPECT_EQ(study.variants[5].parameters("a").paper.endpoint_weight, EndpointWeight::None);
}

TEST(Study, RowsTablesAndPictureAgree) {
  const Study study = makeStudy("scan", oneScene());
  const StudyResult result = runStudy(study, 2);
  ASSERT_EQ(result.rows.size(), 4U);  // scene a and the mean, columns and rows
  EXPECT_EQ(result.rows[0].mean, result.rows[2].mean);
  EXPECT_GT(result.rows[0].mean[kDetectedShare], 0.5);
  for (const Table& table : {studyTable(study, result), studyNumbers(study, result)})
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_GT(studyPicture(study, result).width, 4 * 320);
  EXPECT_EQ(runStudy(study, 1).rows[1].mean, result.rows[1].mean);
}

TEST(Study, GridIsPicturedInRows) {
  ComparisonOptions options = oneScene();
  options.seeds = 1;
  const Study study = makeStudy("criteria", options);
  const StudyResult result = runStudy(study, 2);
  EXPECT_EQ(result.rows.size(), 16U);
  const ColorImage picture = studyPicture(study, result);
  EXPECT_GT(picture.width, 4 * 320);
  EXPECT_GT(picture.height, 4 * 180);
  EXPECT_NE(studyNote(study).find("not public"), std::string::npos);
}

TEST(RenderedFrames, WallIsAPlaneAtItsDistance) {
  const LabelledFrame wall = wallWithNoise(3.0, 20.0, NoiseOptions())(0);
  const PinholeCamera& camera = wall.camera.camera;
  const int middle = static_cast<int>(std::lround(camera.cx));
  EXPECT_NEAR(wall.depth.at(0, middle), 3.0 / (1.0 + std::tan(M_PI / 9.0) * (middle - camera.cx) / camera.fx), 1e-5);
  // Inverse depth is linear in the pixel on a plane.
  const double left = 1.0 / wall.depth.at(5, 0), right = 1.0 / wall.depth.at(5, 200);
  EXPECT_NEAR(1.0 / wall.depth.at(5, 100), 0.5 * (left + right), 1e-6);
}

TEST(LineStatistics, ExactWallIsOneSegmentALine) {
  const LabelledFrame wall = wallWithNoise(2.0, 0.0, NoiseOptions())(0);
  const LineStatistics lines = lineStatistics(wall, Parameters::forPaper(), "d435i");
  EXPECT_DOUBLE_EQ(lines.segments_per_line, 1.0);
  EXPECT_DOUBLE_EQ(lines.pixel_share, 1.0);
}

}  // namespace
}  // namespace epcc
