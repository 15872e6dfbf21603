// SPDX-License-Identifier: BSD-3-Clause
// Logs of laser range finders: every message and column, packed or not, and what is damaged.
#include "datasets/files/laser_log.h"

#include <gtest/gtest.h>

#include "tests/support/expect_errors.h"
#include "tests/support/gzip_bytes.h"
#include "tests/support/temp_folder.h"

namespace epcc::test {
namespace {

constexpr double kDegree = 0.017453292519943295;
const std::string kFlaser = "FLASER 3 1.5 2.5 81.83 0.1 0.2 0.3 1 2 3 10.5 host 10.6\n";
const std::string kRobotLaser =
    "ROBOTLASER1 0 -1.5 3.0 0.5 20 0.01 0 4 1 2 30 nan 2 7 8 0.5 0.6 0.7 1 2 3 0 0 0 0 0 99.5 host 99.6\n";
const std::string kRawLaser = "RAWLASER1 0 -1.0 2.0 1.0 50 0.01 0 3 1 2 3 0 12.25 host 12.5\n";
const std::string kHeading =
    "%time,field.angle_min,field.angle_max,field.angle_increment,field.range_min,field.range_max,"
    "field.ranges0,field.ranges1,field.ranges2,field.intensities0\n";

class LaserLogFile : public TempFolderTest {
 protected:
  LaserLog log(const std::string& text) { return readLaserLog(write("a.log", text)); }
  /// The only scan is damaged.
  void expectDamaged(const std::string& text, const std::string& words) {
    const std::string file = write("a.log", text);
    expectInputError([&] { readLaserLog(file); }, file, "scans", words);
  }
};

TEST_F(LaserLogFile, Flaser) {
  const LaserLog result = log("# comment\nODOM 0 0 0 0 0 0 0.1 h 0.1\n" + kFlaser);
  ASSERT_EQ(result.records.size(), 1U);
  const LaserRecord& record = result.records[0];
  EXPECT_EQ(record.line, 3);
  EXPECT_EQ(record.scan.ranges, (std::vector<double>{1.5, 2.5, 81.83}));
  EXPECT_DOUBLE_EQ(record.scan.angle_min, -90 * kDegree);
  EXPECT_DOUBLE_EQ(record.scan.angle_increment, 90 * kDegree);
  EXPECT_EQ(record.timestamp, 10.5);
  ASSERT_TRUE(record.pose);
  EXPECT_EQ(record.pose->y, 0.2);
  EXPECT_EQ(record.pose->theta, 0.3);
  EXPECT_TRUE(result.problems.empty());
}

TEST_F(LaserLogFile, FlaserHasTheUsualAngles) {
  for (const auto& [beams, first, step] : {std::tuple(180, -90.0, 1.0), std::tuple(181, -90.0, 1.0),
                                           std::tuple(361, -90.0, 0.5), std::tuple(401, -50.0, 0.25)}) {
    std::string text = "FLASER " + std::to_string(beams);
    for (int i = 0; i < beams; ++i) text += " 1";
    const LaserLog result = log(text + " 0 0 0 0 0 0 1 h 1\n");
    EXPECT_NEAR(result.records[0].scan.angle_min, first * kDegree, 1e-12) << beams;
    EXPECT_NEAR(result.records[0].scan.angle_increment, step * kDegree, 1e-12) << beams;
  }
}

TEST_F(LaserLogFile, TheLargestRangeOfManyFlaserBeamsIsNoReturn) {
  std::string text;
  for (int i = 0; i < 9; ++i) text += kFlaser;
  EXPECT_TRUE(log(text).records[0].scan.hasReturn(2));
  EXPECT_FALSE(log(text + kFlaser).records[0].scan.hasReturn(2));
  EXPECT_TRUE(log(text + kFlaser).records[0].scan.hasReturn(1));
}

TEST_F(LaserLogFile, RobotLaserComesBeforeTheOthers) {
  const LaserLog result = log(kFlaser + kRawLaser + kRobotLaser);
  ASSERT_EQ(result.records.size(), 1U);
  const LaserRecord& record = result.records[0];
  EXPECT_EQ(record.scan.ranges.size(), 4U);
  EXPECT_EQ(record.scan.angle_min, -1.5);
  EXPECT_EQ(record.scan.angle_increment, 0.5);
  EXPECT_EQ(record.timestamp, 99.5);
  EXPECT_EQ(record.pose->theta, 0.7);
  EXPECT_TRUE(record.scan.hasReturn(1));
  EXPECT_FALSE(record.scan.hasReturn(2));  // beyond the maximum
  EXPECT_FALSE(record.scan.hasReturn(3));  // nan
}

TEST_F(LaserLogFile, RawLaserHasNoPose) {
  const LaserLog result = log(kRawLaser);
  ASSERT_EQ(result.records.size(), 1U);
  EXPECT_FALSE(result.records[0].pose);
  EXPECT_EQ(result.records[0].timestamp, 12.25);
  EXPECT_EQ(result.records[0].scan.ranges.size(), 3U);
}

TEST_F(LaserLogFile, ATableAsRosPrintsIt) {
  const LaserLog result =
      log(kHeading + "1500000000500000000,-1,1,1,0.1,30,1,nan,0.05,200\r\n\n7,-1,1,1,0.1,inf,1,,3,200\n");
  ASSERT_EQ(result.records.size(), 2U);
  EXPECT_DOUBLE_EQ(*result.records[0].timestamp, 1500000000.5);
  EXPECT_EQ(result.records[0].scan.ranges.size(), 3U);
  EXPECT_TRUE(result.records[0].scan.hasReturn(0));
  EXPECT_FALSE(result.records[0].scan.hasReturn(1));
  EXPECT_FALSE(result.records[0].scan.hasReturn(2));  // below the minimum
  EXPECT_EQ(result.records[1].timestamp, 7.0);
  EXPECT_FALSE(result.records[1].scan.hasReturn(1));
  EXPECT_FALSE(result.records[1].pose);
}

TEST_F(LaserLogFile, ATableWhoseHeadingDoesNotSayWhatIsWhatIsRefused) {
  const std::string row = "-1,1,1,2,3\n";
  const auto refused = [&](const std::string& heading, const std::string& words) {
    expectDamaged(heading + "\n" + row, "line 1: " + words);
  };
  refused("angle_min,angle_increment,ranges0,ranges2,ranges3", "the heading has 'ranges2' out of order");
  refused("angle_min,angle_increment,ranges1,ranges0,ranges2", "the heading has 'ranges0' out of order");
  refused("angle_min,angle_increment,ranges0,note,ranges1", "the heading has 'ranges1' out of order");
  refused("angle_min,angle_increment,ranges0,ranges1,ranges1", "the heading has 'ranges1' out of order");
  refused("angle_min,angle_increment,ranges0,angle_min,note", "the heading has 'angle_min' twice");
  EXPECT_EQ(log("%time,field.header.stamp,angle_min,angle_increment,ranges,ranges\n1,2,-1,1,3,4\n").records.size(), 1U);
}

TEST_F(LaserLogFile, ARecordThatGoesOnBehindItsEndIsDamaged) {
  for (const std::string& message : {kFlaser, kRobotLaser, kRawLaser}) {
    const std::string joined = message.substr(0, message.size() - 1) + " " + message;
    const LaserLog result = log(joined + message);
    EXPECT_EQ(result.records.size(), 1U) << message;
    ASSERT_EQ(result.problems.size(), 1U) << message;
    EXPECT_NE(result.problems[0].find("words follow the timestamp"), std::string::npos) << result.problems[0];
  }
}

TEST_F(LaserLogFile, AByteOrderMarkIsNoPartOfTheFirstWord) {
  EXPECT_EQ(log("\xEF\xBB\xBF" + kFlaser + kFlaser).records.size(), 2U);
  EXPECT_EQ(log("\xEF\xBB\xBF" + kHeading + "7,-1,1,1,0.1,inf,1,2,3,200\n").records.size(), 1U);
}

TEST_F(LaserLogFile, ATableMayHavePosesAndScansOfAnyLength) {
  const LaserLog result = log("x,y,theta,angle_min,angle_increment,ranges\n1,2,3,0,0.1,1,2,3,4\n1,2,3,0,0.1,1\n");
  ASSERT_EQ(result.records.size(), 2U);
  EXPECT_EQ(result.records[0].scan.ranges.size(), 4U);
  EXPECT_EQ(result.records[1].scan.ranges.size(), 1U);
  EXPECT_EQ(result.records[0].pose->y, 2.0);
  EXPECT_FALSE(result.records[0].timestamp);
}

TEST_F(LaserLogFile, PackedIsTheSame) {
  const LaserLog result = readLaserLog(write("a.log.gz", packed(kRobotLaser + kRobotLaser)));
  EXPECT_EQ(result.records.size(), 2U);
}

TEST_F(LaserLogFile, ADamagedLineIsLeftOutAndNamed) {
  const std::string file = write("a.log", kFlaser + "FLASER 3 1 2 x 0 0 0 0 0 0 1 h 1\n" + kFlaser);
  const LaserLog result = readLaserLog(file);
  EXPECT_EQ(result.records.size(), 2U);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems[0], file + ": line 2: a range 'x' is no number");
}

TEST_F(LaserLogFile, ManyDamagedLinesAreCounted) {
  std::string text = kFlaser;
  for (int i = 0; i < 25; ++i) text += "FLASER\n";
  const LaserLog result = log(text);
  EXPECT_EQ(result.problems.size(), 10U);
  EXPECT_EQ(result.more_problems, 15U);
}

TEST_F(LaserLogFile, WhatIsDamagedIsSaid) {
  expectDamaged("FLASER\n", "line 1: ends before the number of readings");
  expectDamaged("FLASER 3 1 2\n", "the number of readings is 3, and 2 words follow");
  expectDamaged("FLASER 999999999999999999999 1 2\n", "and 2 words follow");
  expectDamaged("FLASER 1e300 1 2\n", "and 2 words follow");
  expectDamaged("FLASER -1 1 2\n", "the number of readings is no count");
  expectDamaged("FLASER nan 1 2\n", "the number of readings is no count");
  expectDamaged("FLASER 2.5 1 2\n", "the number of readings is no count");
  expectDamaged("FLASER 0 0 0 0 0 0 0 1 h 1\n", "there are no readings");
  expectDamaged("FLASER 1 1 0 0 inf 0 0 0 1 h 1\n", "the pose is not finite");
  expectDamaged("FLASER 1 1 0 0 0 0 0 0 soon h 1\n", "the timestamp 'soon' is no number");
  expectDamaged("RAWLASER1 0 -1 2 0 50 0 0 1 1 0 1 h 1\n", "the angular resolution is zero");
  expectDamaged("RAWLASER1 0 -1 2 1 -5 0 0 1 1 0 1 h 1\n", "the maximum range is not positive");
  expectDamaged("RAWLASER1 0 nan 2 1 5 0 0 1 1 0 1 h 1\n", "the start angle is not finite");
  expectDamaged("RAWLASER1 0 -1 2 1 5 0 0 1 1 77 1 h 1\n", "the number of remissions is 77");
  expectDamaged(std::string("FLASER 1 \x1b[31m\n"), "a range '?[31m' is no number");
  expectDamaged("angle_min,ranges\n1,2\n", "the heading has no angle_increment");
  expectDamaged("angle_min,angle_increment\n1,2\n", "the heading has no ranges");
  expectDamaged("angle_min,angle_increment,ranges\n0,0,1\n", "line 2: angle_increment is zero");
  expectDamaged("angle_min,angle_increment,ranges\n0\n", "ends before angle_increment");
  expectDamaged("angle_min,angle_increment,ranges\n0,1\n", "ends before its ranges");
  expectDamaged("angle_min,angle_increment,range_min,range_max,ranges\n0,1,5,4,1\n",
                "range_max is not above range_min");
  expectDamaged("angle_min,angle_increment,ranges\n0,1,1,two\n", "a range 'two' is no number");
  expectDamaged("nothing of interest\n", "there are none");
}

TEST_F(LaserLogFile, FilesThatCannotBeReadAreSaid) {
  expectInputError([&] { readLaserLog(path("none.log")); }, path("none.log"), "file", "does not exist");
  expectInputError([&] { readLaserLog(folder()); }, folder(), "file", "is a folder");
  expectInputError([&] { readLaserLog(write("empty.log", "")); }, path("empty.log"), "file", "is empty");
  const std::string endless = write("endless.log", std::string(kMaxTextLine + 10, 'a'));
  expectInputError([&] { readLaserLog(endless); }, endless, "line 1", "is longer than 16 MiB");
}

TEST_F(LaserLogFile, APackedFileThatBreaksOffGivesWhatCameBefore) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "FLASER 1 " + std::to_string(i * 7919 % 10007) + " 0 0 0 0 0 0 1 h 1\n";
  const std::string whole = packed(text);
  const std::string file = write("cut.log.gz", whole.substr(0, whole.size() / 2));
  const LaserLog result = readLaserLog(file);
  EXPECT_GT(result.records.size(), 1000U);
  EXPECT_LT(result.records.size(), 20000U);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_NE(result.problems[0].find("the packed file ends too early"), std::string::npos) << result.problems[0];
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 0x55);
  const LaserLog damaged = readLaserLog(write("flipped.log.gz", flipped));
  EXPECT_FALSE(damaged.problems.empty());
}

}  // namespace
}  // namespace epcc::test
