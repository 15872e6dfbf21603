// SPDX-License-Identifier: BSD-3-Clause
// Clouds of any frame and unit, and depth images that are not plain depths, on the command line.
#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "datasets/files/organized_pcd.h"
#include "datasets/files/png_io.h"
#include "tests/eval/segment/tool_runner.h"

namespace {

using epcc::test::SegmentToolTest;
using epcc::test::ToolResult;

class SegmentGeometry : public SegmentToolTest {
 protected:
  /// The room's cloud with each point p -> unit * (axes p + origin).
  void writeMoved(const std::string& name, const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin, double unit,
                  const std::string& viewpoint = "0 0 0 1 0 0 0") const {
    writeCloud("room.pcd");
    const epcc::OrganizedCloud room = epcc::readOrganizedPcd(path("room.pcd"));
    std::ostringstream text;
    text.precision(9);
    text << "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << room.width << "\nHEIGHT "
         << room.height << "\nVIEWPOINT " << viewpoint << "\nPOINTS " << room.width * room.height << "\nDATA ascii\n";
    for (std::size_t i = 0; i < room.xyz.size(); i += 3) {
      const Eigen::Vector3d p = Eigen::Vector3f(room.xyz[i], room.xyz[i + 1], room.xyz[i + 2]).cast<double>();
      const Eigen::Vector3d q = unit * (axes * p + origin);
      text << q.x() << ' ' << q.y() << ' ' << q.z() << '\n';
    }
    write(name, text.str());
  }

  nlohmann::json planesOf(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--planes", "p.json"});
    const ToolResult result = run(all);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(read("p.json"));
  }
};

Eigen::Matrix3d bodyAxes() {  // x forward, y left, z up
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return axes;
}

TEST_F(SegmentGeometry, ACloudInTheRobotsFrameHasItsPlanesThere) {
  const Eigen::Vector3d origin(0.1, -0.2, 1.2);
  writeMoved("robot.pcd", bodyAxes(), origin, 1.0);
  ASSERT_EQ(run({"room.pcd", "--labels", "a.png"}).exit_code, 0);
  const auto list = planesOf({"robot.pcd", "--labels", "b.png"});
  const epcc::LabelImage a = epcc::readGray16(path("a.png")), b = epcc::readGray16(path("b.png"));
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i) same += a.data[i] == b.data[i] ? 1 : 0;
  EXPECT_GE(same, a.data.size() * 97 / 100);  // all but a row at the edge
  EXPECT_EQ(list.at("frame"), "cloud");
  EXPECT_EQ(list.at("sensor").at("kind"), "camera");
  ASSERT_EQ(list.at("sensor").at("pose").size(), 12u);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(list.at("sensor").at("pose")[static_cast<std::size_t>(4 * k + 3)].get<double>(), origin(k), 0.01);
  bool has_wall = false;
  for (const auto& plane : list.at("planes")) {  // the wall 2 m ahead, at x = 2.1 m
    const auto& c = plane.at("coefficients");
    has_wall = has_wall || (std::abs(c[0].get<double>() + 1.0) < 0.01 && std::abs(c[3].get<double>() - 2.1) < 0.02);
  }
  EXPECT_TRUE(has_wall) << list.at("planes").dump();
}

TEST_F(SegmentGeometry, MillimetresAreSaidOrNoticed) {
  writeMoved("mm.pcd", Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), 1000.0);
  const ToolResult guessed = run({"mm.pcd"}), told = run({"mm.pcd", "--unit", "mm"});
  EXPECT_EQ(guessed.exit_code, 0);
  EXPECT_NE(guessed.err.find("mm.pcd: unit: taken as millimetres"), std::string::npos) << guessed.err;
  EXPECT_EQ(std::count(guessed.err.begin(), guessed.err.end(), '\n'), 1);
  EXPECT_EQ(told.err, "");
  EXPECT_EQ(told.out, guessed.out);
  EXPECT_NE(told.out.find(" 2.000 "), std::string::npos) << told.out;
  EXPECT_EQ(planesOf({"mm.pcd", "--unit", "mm"}).at("frame"), "camera x right, y down, z forward");
  writeMoved("cm.pcd", Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), 100.0);
  EXPECT_NE(run({"cm.pcd", "--unit", "cm"}).out.find(" 2.000 "), std::string::npos);
  const auto far = planesOf({"mm.pcd", "--unit", "m"}).at("planes");
  ASSERT_FALSE(far.empty());
  EXPECT_GT(far[0].at("coefficients")[3].get<double>(), 1000.0);
}

TEST_F(SegmentGeometry, TheWrittenCloudIsInMetresAndInItsOwnFrame) {
  writeMoved("mm.pcd", bodyAxes(), Eigen::Vector3d(0, 0, 1), 1000.0);
  ASSERT_EQ(run({"mm.pcd", "--unit", "mm", "--cloud", "c.pcd"}).exit_code, 0);
  const epcc::OrganizedCloud from = epcc::readOrganizedPcd(path("mm.pcd"));
  const epcc::OrganizedCloud to = epcc::readOrganizedPcd(path("c.pcd"));
  for (std::size_t i = 0; i < to.xyz.size(); ++i) ASSERT_NEAR(to.xyz[i], 0.001f * from.xyz[i], 1e-4f);
}

TEST_F(SegmentGeometry, WhatNoSensorSeesIsAnInputThatCannotBeUsed) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  std::ostringstream text;
  text << "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 40\nHEIGHT 30\nDATA ascii\n";
  for (int i = 0; i < 1200; ++i)
    text << normal(generator) << ' ' << normal(generator) << ' ' << normal(generator) << '\n';
  write("noise.pcd", text.str());
  expectFailure({"noise.pcd", "--labels", "l.png"}, 3, "noise.pcd: frame: no camera and no scanner");
  EXPECT_FALSE(exists("l.png"));
}

TEST_F(SegmentGeometry, AWrongWidthIsNamed) {
  writeCloud("room.pcd");
  std::string text = read("room.pcd");
  const std::string right = "WIDTH 64\nHEIGHT 48\n";
  text.replace(text.find(right), right.size(), "WIDTH 32\nHEIGHT 96\n");
  write("cut.pcd", text);
  expectFailure({"cut.pcd", "--labels", "l.png"}, 3, "as 64x48 they would be a camera's: its width is likely wrong");
  EXPECT_FALSE(exists("l.png"));
}

TEST_F(SegmentGeometry, WhatNoInputHasAUseForIsRefused) {
  writeFrame("room");
  writeCloud("cloud.pcd");
  const std::vector<std::string> numbers = {"--fx", "60", "--fy", "60", "--cx", "31.5", "--cy", "23.5"};
  const auto with = [](std::vector<std::string> inputs, const std::vector<std::string>& more) {
    inputs.insert(inputs.end(), more.begin(), more.end());
    return inputs;
  };
  expectFailure(with({"cloud.pcd"}, numbers), 2, "--fx is for depth images, and there are clouds only");
  expectFailure({"cloud.pcd", "--camera", "room.json"}, 2, "--camera is for depth images");
  expectFailure({"cloud.pcd", "--distance"}, 2, "--distance is for depth images, and there are clouds only");
  expectFailure({"room_depth.png", "--projection", "scanner"}, 2, "--projection is for clouds");
  std::filesystem::create_directory(path("clouds"));
  std::filesystem::rename(path("cloud.pcd"), path("clouds/cloud.pcd"));
  writeCamera("clouds/cloud.json");
  expectFailure({"clouds", "--distance"}, 2, "--distance is for depth images");
  expectFailure({"clouds", "--camera", "room.json"}, 2, "--camera is for depth images");
  // Together each has its use.
  EXPECT_EQ(run(with({"clouds/cloud.pcd", "room_depth.png"}, numbers)).exit_code, 0);
  EXPECT_EQ(run({"clouds/cloud.pcd", "room_depth.png", "--distance", "--projection", "camera"}).exit_code, 0);
  EXPECT_EQ(run({"clouds", "--projection", "camera"}).exit_code, 0);
  EXPECT_EQ(run({"room_depth.png", "--projection", "auto"}).exit_code, 0);
  // What is not there might have had a use for it.
  const ToolResult missing = run({"nothing.png", "clouds/cloud.pcd", "--distance"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_NE(missing.err.find("nothing.png: file: does not exist"), std::string::npos) << missing.err;
}

TEST_F(SegmentGeometry, TheKindMayBeNamed) {
  writeMoved("robot.pcd", bodyAxes(), Eigen::Vector3d::Zero(), 1.0);
  for (const char* kind : {"camera", "scanner"})
    EXPECT_EQ(planesOf({"robot.pcd", "--projection", kind}).at("sensor").at("kind"), kind);
}

TEST_F(SegmentGeometry, LengthsOfRays) {
  writeFrame("room");
  epcc::Image<std::uint16_t> image = epcc::readGray16(path("room_depth.png"));
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      auto& value = image.data[static_cast<std::size_t>(row * image.width + column)];
      const double u = (column - 31.5) / 60.0, v = (row - 23.5) / 60.0;
      value = static_cast<std::uint16_t>(std::lround(value * std::sqrt(1.0 + u * u + v * v)));
    }
  writeCamera("ray.json");
  epcc::writeGray16(path("ray_depth.png"), image);
  const auto distances = [&](const std::vector<std::string>& arguments) {
    std::vector<double> d;
    const nlohmann::json found = planesOf(arguments);
    for (const auto& plane : found.at("planes")) d.push_back(plane.at("coefficients")[3].get<double>());
    return d;
  };
  const std::vector<double> depth = distances({"room_depth.png"}), ray = distances({"ray_depth.png", "--distance"});
  ASSERT_EQ(depth.size(), 2U);
  ASSERT_EQ(ray.size(), 2U);
  for (std::size_t i = 0; i < depth.size(); ++i) EXPECT_NEAR(depth[i], ray[i], 0.005);
}

TEST_F(SegmentGeometry, InvalidValuesAndRanges) {
  writeFrame("room");
  epcc::Image<std::uint16_t> image = epcc::readGray16(path("room_depth.png"));
  writeCamera("holes.json");
  for (std::size_t i = 0; i < 20; ++i)
    for (std::size_t k = 0; k < 20; ++k) image.data[64 * i + k] = 9000;
  epcc::writeGray16(path("holes_depth.png"), image);
  const auto labelAt = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"holes_depth.png", "--labels", "l.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).exit_code, 0);
    return epcc::readGray16(path("l.png")).data[64 * 10 + 10];
  };
  EXPECT_NE(labelAt({}), 0);  // a plane at 9 m
  EXPECT_EQ(labelAt({"--invalid", "9000"}), 0);
  EXPECT_EQ(labelAt({"--max-depth", "5"}), 0);
  EXPECT_EQ(labelAt({"--min-depth", "9.5"}), 0);
  for (auto& value : image.data)
    if (value == 9000) value = 65535;
  epcc::writeGray16(path("holes_depth.png"), image);
  EXPECT_EQ(labelAt({}), 0);
}

TEST_F(SegmentGeometry, NumbersAreChecked) {
  writeFrame("room");
  const auto usage = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> arguments = {"room_depth.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expectFailure(arguments, 2, words);
  };
  usage({"--unit", "km"}, "--unit");
  usage({"--projection", "fisheye"}, "--projection");
  usage({"--min-depth", "-1"}, "--min-depth");
  usage({"--max-depth", "nan"}, "--max-depth");
  usage({"--invalid", "none"}, "--invalid");
  usage({"--unit", "mm", "--fx", "60", "--fy", "60", "--cx", "32", "--cy", "24", "--depth-scale", "1"},
        "--depth-scale");
  usage({"--min-depth", "3", "--max-depth", "2"}, "--min-depth is not less than --max-depth");
}

}  // namespace
