// SPDX-License-Identifier: BSD-3-Clause
// The CSV of line segments reads back as what was written.
#include "datasets/files/segment_list.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/support/temp_folder.h"

namespace epcc {
namespace {

std::vector<std::vector<std::string>> cells(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    rows.emplace_back();
    for (std::string word; std::getline(words, word, ',');) rows.back().push_back(word);
  }
  return rows;
}

LineSegment oddNumbers() {
  LineSegment segment;
  segment.scan = ScanDirection::Rows;
  segment.line = 7;
  segment.first = 3;
  segment.last = 40;
  segment.samples = 36;
  segment.label = 12;
  segment.start << 1.0 / 3.0, -2e-17, 3.0;
  segment.end << 1e22, 0.1, -0.0;
  segment.mean << 2.0 / 7.0, -0.3;
  segment.covariance << 1e-5, -2e-6, -2e-6, 3.3333333333333333e-4;
  segment.variance = 1.2345678901234567e-6;
  segment.theta << 0.7, -1.0 / 7.0;
  segment.theta_covariance << 2e-9, 1e-10, 1e-10, 3.1e-8;
  return segment;
}

TEST(SegmentList, HeadingNamesUnitsAndEveryColumn) {
  const auto rows = cells(segmentListCsv({}));
  ASSERT_EQ(rows.size(), 1U);
  const std::vector<std::string> expected{"scan",
                                          "line",
                                          "first_px",
                                          "last_px",
                                          "samples",
                                          "label",
                                          "start_x_m",
                                          "start_y_m",
                                          "start_z_m",
                                          "end_x_m",
                                          "end_y_m",
                                          "end_z_m",
                                          "mean_t1_m",
                                          "mean_t2_m",
                                          "var_t1_m2",
                                          "cov_t1_t2_m2",
                                          "var_t2_m2",
                                          "residual_var_m2",
                                          "theta1_per_m",
                                          "theta2_per_m",
                                          "var_theta1_per_m2",
                                          "cov_theta1_theta2_per_m2",
                                          "var_theta2_per_m2"};
  EXPECT_EQ(rows[0], expected);
}

TEST(SegmentList, ReadsBackExactly) {
  const LineSegment s = oddNumbers();
  const auto rows = cells(segmentListCsv({s, LineSegment()}));
  ASSERT_EQ(rows.size(), 3U);
  const std::vector<std::string> whole{"row", "7", "3", "40", "36", "12"};
  EXPECT_EQ(std::vector<std::string>(rows[1].begin(), rows[1].begin() + 6), whole);
  EXPECT_EQ(rows[2][0], "column");
  const double expected[] = {s.start(0),
                             s.start(1),
                             s.start(2),
                             s.end(0),
                             s.end(1),
                             s.end(2),
                             s.mean(0),
                             s.mean(1),
                             s.covariance(0, 0),
                             s.covariance(0, 1),
                             s.covariance(1, 1),
                             s.variance,
                             s.theta(0),
                             s.theta(1),
                             s.theta_covariance(0, 0),
                             s.theta_covariance(0, 1),
                             s.theta_covariance(1, 1)};
  ASSERT_EQ(rows[1].size(), 23U);
  for (std::size_t i = 0; i < 17; ++i) EXPECT_EQ(std::strtod(rows[1][6 + i].c_str(), nullptr), expected[i]) << i;
}

class SegmentListFile : public test::TempFolderTest {};

TEST_F(SegmentListFile, IsTheText) {
  writeSegmentList(path("out.csv"), {oddNumbers()});
  std::ifstream file(path("out.csv"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), segmentListCsv({oddNumbers()}));
  EXPECT_EQ(names(), std::vector<std::string>{"out.csv"});
}

}  // namespace
}  // namespace epcc
