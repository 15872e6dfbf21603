// SPDX-License-Identifier: BSD-3-Clause
// epcc_lines: what it writes, the same for any number of threads; damaged logs and wrong command lines.
#include "eval/lines/lines_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "datasets/rendered/floor_plan.h"
#include "eval/lines/line_map.h"
#include "tests/support/real_frames.h"
#include "tests/support/run_tool.h"

namespace epcc::test {
namespace {

ToolResult run(const std::vector<std::string>& arguments) {
  return callTool(linesMain, "epcc_lines", arguments);
}

/// Scans of a floor plan as FLASER messages.
std::string officeLog(int scans) {
  std::ostringstream text;
  text.precision(9);
  for (const FloorScan& scan : scanOffice(LaserSensor::halfCircle(), scans, 1)) {
    text << "FLASER " << scan.record.scan.ranges.size();
    for (const double range : scan.record.scan.ranges) text << ' ' << range;
    const LaserPose& pose = *scan.record.pose;
    for (int i = 0; i < 2; ++i) text << ' ' << pose.x << ' ' << pose.y << ' ' << pose.theta;
    text << ' ' << *scan.record.timestamp << " host 0\n";
  }
  return text.str();
}

class LinesCommand : public TempFolderTest {
 protected:
  std::vector<std::vector<std::string>> table(const std::string& name) const {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(read(name));
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> fields{""};
      for (const char c : line) {
        if (c == ',')
          fields.emplace_back();
        else
          fields.back() += c;
      }
      rows.push_back(fields);
    }
    return rows;
  }
};

TEST_F(LinesCommand, WritesSegmentsAndPictures) {
  const ToolResult result = run({write("office.log", officeLog(12)), "--out", path("out")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.rfind("office: 12 scans, 2172 returns, sigma_r = 0.0", 0), 0U) << result.out;
  EXPECT_EQ(names("out"), (std::vector<std::string>{"office_lines.csv", "office_map.png", "office_map.svg",
                                                    "office_scan.png", "office_scan.svg"}));
  const auto rows = table("out/office_lines.csv");
  ASSERT_GT(rows.size(), 40U);
  EXPECT_EQ(rows[0][0], "scan");
  EXPECT_EQ(rows[0].size(), 30U);
  // Ends on the wall at y = 0 or in the room's frame within the building, whatever the pose.
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), rows[0].size());
    EXPECT_GT(std::stod(rows[i][13]), -0.1);
    EXPECT_LT(std::stod(rows[i][13]), 14.1);
    EXPECT_GT(std::stod(rows[i][16]), -0.1);
    EXPECT_LT(std::stod(rows[i][16]), 9.1);
    EXPECT_GT(std::stod(rows[i][19]), 0.0);
  }
  EXPECT_EQ(read("out/office_map.png").substr(1, 3), "PNG");
  const std::string svg = read("out/office_map.svg");
  EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST_F(LinesCommand, TheResultDoesNotDependOnThreads) {
  const std::string log = write("office.log", officeLog(20));
  ASSERT_EQ(run({log, "--out", path("one"), "--noise", "0.01,0.001"}).exit_code, 0);
  ASSERT_EQ(run({log, "--out", path("four"), "--noise", "0.01,0.001", "--jobs", "4"}).exit_code, 0);
  for (const std::string& name : names("one")) EXPECT_EQ(read("one/" + name), read("four/" + name)) << name;
}

TEST_F(LinesCommand, WithoutPosesThereIsNoMap) {
  const std::string table_text = "angle_min,angle_increment,ranges\n-0.2,0.02,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1\n";
  const ToolResult result = run({write("scans.csv", table_text), "--out", path("out"), "--noise", "0.02,0"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(names("out"), (std::vector<std::string>{"scans_lines.csv", "scans_scan.png", "scans_scan.svg"}));
  const auto rows = table("out/scans_lines.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1][2], "");   // no time
  EXPECT_EQ(rows[1][13], "");  // no pose
}

TEST_F(LinesCommand, DamagedLinesAreToldAndTheRestIsDone) {
  const std::string log = write("office.log", officeLog(5) + "FLASER 1000000000 1 2 3\n");
  const ToolResult result = run({log, path("none.log"), "--out", path("out")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, "epcc_lines: " + log + ": line 6: the number of readings is 1000000000, and 3 words follow\n" +
                            "epcc_lines: " + path("none.log") + ": file: does not exist\n");
  EXPECT_NE(result.out.find("office: 5 scans"), std::string::npos);
  EXPECT_TRUE(exists("out/office_lines.csv"));
}

TEST_F(LinesCommand, LogsAreNotOverwritten) {
  const std::string log = write("out/office.log", officeLog(2));
  for (const char* name : {"office_lines.csv", "office_map.png"}) {
    const std::string other = write(std::string("out/") + name, officeLog(3));
    expectFailure(run({other, log, "--out", path("out")}), "epcc_lines", 2,
                  std::string(name) + " would overwrite a log");
    EXPECT_EQ(bytesOf(other), officeLog(3));
  }
}

TEST_F(LinesCommand, WhatIsDoubtfulIsToldAndNoError) {
  const auto told = [&](const std::string& text, const std::string& words) {
    const std::string log = write("scans.csv", text);
    const ToolResult result = run({log, "--out", path("out")});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err.rfind("epcc_lines: " + log + ": " + words, 0), 0U) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  };
  const auto wall = [](double unit, double step) {  // 2 m ahead, with an error of 1 cm
    std::mt19937 random(1);
    std::normal_distribution<double> error(0.0, 0.01);
    std::ostringstream text;
    text << "angle_min,angle_increment,ranges\n";
    for (int scan = 0; scan < 20; ++scan) {
      text << -60.0 * step << ',' << step;
      for (int i = -60; i <= 60; ++i) text << ',' << unit * (2.0 / std::cos(0.01 * i) + error(random));
      text << '\n';
    }
    return text.str();
  };
  told("angle_min,angle_increment,ranges\n-1,0.1,0,nan,inf\n", "no beam has a return");
  told(wall(1000.0, 0.01), "noise: the measured error is 1");
  told(wall(1.0, 100.0), "no line was found: are the ranges in metres and the angles in radians?");
  EXPECT_EQ(run({write("scans.csv", wall(1.0, 0.01)), "--out", path("out")}).err, "");
}

TEST_F(LinesCommand, WrongCommandLinesAreOneLine) {
  const std::string log = write("office.log", officeLog(2));
  const auto fails = [&](std::vector<std::string> arguments, const std::string& words, int code = 2) {
    arguments.insert(arguments.begin(), log);
    if (std::find(arguments.begin(), arguments.end(), "--out") == arguments.end())
      arguments.insert(arguments.end(), {"--out", path("out")});
    expectFailure(run(arguments), "epcc_lines", code, words);
  };
  fails({"--noise", "0.01"}, "--noise: must be auto or A,B");
  fails({"--noise", "a,b"}, "--noise: must be auto or A,B");
  fails({"--noise", "-1,0"}, "must not be negative");
  fails({"--noise", "nan,0"}, "must not be negative");
  fails({"--noise", "0,0"}, "must not both be zero");
  fails({"--noise", "1001,0"}, "--noise: the coefficients of sigma_z must be at most 1000");
  fails({"--k-max", "0"}, "epcc_lines: --k-max: must be 0.5 to 10");
  fails({"--min-points", "2"}, "--min-points: must be 5 to 1000");
  fails({"--max-gap", "-1"}, "--max-gap: must be 0 to 1000 m");
  fails({"--max-range", "0"}, "--max-range: must be positive");
  fails({"--scan", "-1"}, "--scan: must not be negative");
  fails({"--scan", "2"}, "there are 2 scans, from 0", 3);
  fails({"--jobs", "1000"}, "--jobs: must be 0 to 256");
  fails({"--loud"}, "--loud");
  fails({log}, "two logs are named office");
  fails({"--out", ""}, "--out: the name is empty");
  fails({"--out", log + "/x"}, "cannot be made", 4);
  expectFailure(run({"--out", path("out")}), "epcc_lines", 2, "LOG is required");
}

TEST_F(LinesCommand, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(run({"--help"}).exit_code, 0);
  EXPECT_NE(run({"--version"}).out.find("epcc_lines 0."), std::string::npos);
}

TEST(LineMap, DrawsWhereThingsAre) {
  LineMap map;
  map.points = {{0.0, 0.0}, {1.0, 0.5}};
  map.segments = {{{0.0, 1.0}, {1.0, 1.0}, {255, 0, 0}}};
  const ColorImage image = drawMap(map);
  EXPECT_EQ(image.width, 1200);
  EXPECT_EQ(image.height, 1200);
  EXPECT_EQ(image.at(40, 600).r, 255);  // the segment, at the top
  EXPECT_EQ(image.at(40, 600).g, 0);
  EXPECT_LT(image.at(1160, 40).r, 220);  // the first point, lower left
  EXPECT_EQ(image.at(600, 600).b, 255);
}

TEST_F(LinesCommand, RealLogOfTheIntelLab) {
  EPCC_NEED_REAL_FRAMES("lrf");
  const ToolResult result = run({realFolder("lrf") + "/intel.gfs.log.gz", "--out", path("out")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.rfind("intel.gfs: 910 scans, 159628 returns", 0), 0U) << result.out;
  EXPECT_GT(table("out/intel.gfs_lines.csv").size(), 4500U);
}

}  // namespace
}  // namespace epcc::test
