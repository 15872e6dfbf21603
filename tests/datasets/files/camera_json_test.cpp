// SPDX-License-Identifier: BSD-3-Clause
// Camera files: round trip, unknown keys, and each key missing, of the wrong type or out of range.
#include "datasets/files/camera_json.h"

#include <gtest/gtest.h>

#include "tests/support/expect_errors.h"

namespace epcc {
namespace {

using nlohmann::json;

json goodJson() {
  return {{"width", 640}, {"height", 480}, {"fx", 525.5},         {"fy", 524.25},
          {"cx", 319.5},  {"cy", 239.5},   {"depth_scale", 0.001}};
}

class CameraJsonTest : public test::TempFolderTest {
 protected:
  CameraFile read(const json& content) const { return readCameraJson(write("a.json", content.dump())); }
  void expectRefused(const std::string& content, const std::string& field, const std::string& part) const {
    const std::string file = write("a.json", content);
    test::expectInputError([&] { readCameraJson(file); }, file, field, part);
  }
  void expectRefused(const json& content, const std::string& field, const std::string& part) const {
    expectRefused(content.dump(), field, part);
  }
  /// The good file with `key` written as `value`, which need not be JSON.
  static std::string with(const std::string& key, const std::string& value) {
    json content = goodJson();
    content[key] = "@";
    std::string text = content.dump();
    return text.replace(text.find("\"@\""), 3, value);
  }
};

TEST_F(CameraJsonTest, RoundTripKeepsEveryDigit) {
  CameraFile file;
  file.camera = {641, 479, 525.1234567890123, 1.0 / 3.0, -0.5, 1e4 / 7.0};
  file.depth_scale = 2e-5;
  file.name = "frame \"1\" \xc3\xa9";
  file.noise = "kinect-v1";
  writeCameraJson(path("a.json"), file);
  const CameraFile read = readCameraJson(path("a.json"));
  EXPECT_EQ(read.camera.width, 641);
  EXPECT_EQ(read.camera.height, 479);
  EXPECT_EQ(read.camera.fx, file.camera.fx);
  EXPECT_EQ(read.camera.fy, file.camera.fy);
  EXPECT_EQ(read.camera.cx, file.camera.cx);
  EXPECT_EQ(read.camera.cy, file.camera.cy);
  EXPECT_EQ(read.depth_scale, file.depth_scale);
  EXPECT_EQ(read.name, file.name);
  EXPECT_EQ(read.noise, file.noise);
  EXPECT_TRUE(read.extra.empty());
}

TEST_F(CameraJsonTest, UnknownKeysAreKept) {
  json content = goodJson();
  content["source"] = "somewhere";
  content["same_plane_group"] = {{1, 2}, {3, 4}};
  content["nothing"] = nullptr;
  content["nested"] = {{"a", {{"b", 1.5}}}};
  const CameraFile file = read(content);
  EXPECT_EQ(file.extra.size(), 4u);
  writeCameraJson(path("b.json"), file);
  EXPECT_EQ(json::parse(test::bytesOf(path("b.json"))), content);
}

TEST_F(CameraJsonTest, PlanesMayBeANumberOrAList) {
  json content = goodJson();
  content["planes"] = 7;
  EXPECT_EQ(read(content).extra["planes"], 7);
  content["planes"] = {{{"id", 1}}, {{"id", 2}}};
  EXPECT_EQ(read(content).extra["planes"].size(), 2u);
}

TEST_F(CameraJsonTest, NameAndNoiseAreOptional) {
  const CameraFile file = read(goodJson());
  EXPECT_EQ(file.name, "");
  EXPECT_FALSE(file.noise.has_value());
}

TEST_F(CameraJsonTest, WholeNumberWrittenWithAPointIsFine) {
  json content = goodJson();
  content["width"] = 640.0;
  EXPECT_EQ(read(content).camera.width, 640);
}

TEST_F(CameraJsonTest, ByteOrderMarkIsFine) {
  EXPECT_EQ(readCameraJson(write("a.json", "\xef\xbb\xbf" + goodJson().dump())).camera.height, 480);
}

TEST_F(CameraJsonTest, MissingFile) {
  test::expectInputError([&] { readCameraJson(path("no.json")); }, path("no.json"), "file", "does not exist");
}
TEST_F(CameraJsonTest, FolderInsteadOfFile) {
  test::expectInputError([&] { readCameraJson(folder()); }, folder(), "file", "is a folder");
}
TEST_F(CameraJsonTest, DeviceInsteadOfFile) {
  test::expectInputError([] { readCameraJson("/dev/zero"); }, "/dev/zero", "file", "regular");
}
TEST_F(CameraJsonTest, Empty) {
  expectRefused(std::string(), "file", "is empty");
}
TEST_F(CameraJsonTest, BlanksOnly) {
  expectRefused(std::string(" \n\t"), "JSON", "");
}
TEST_F(CameraJsonTest, NotJson) {
  expectRefused(std::string("fx = 525\nfy = 525\n"), "JSON", "parse error");
}
TEST_F(CameraJsonTest, BinaryFile) {
  expectRefused(std::string("\x89PNG\r\n\x1a\n\0\0", 10), "JSON", "");
}
TEST_F(CameraJsonTest, InvalidUtf8) {
  expectRefused(std::string("{\"a\": \"\xff\xfe\"}"), "JSON", "");
}
TEST_F(CameraJsonTest, ArrayInsteadOfObject) {
  expectRefused(std::string("[640, 480]"), "JSON", "not an object");
}
TEST_F(CameraJsonTest, NumberInsteadOfObject) {
  expectRefused(std::string("640"), "JSON", "not an object");
}
TEST_F(CameraJsonTest, AKeyTwiceInOneObject) {
  std::string twice = goodJson().dump();
  expectRefused(twice.insert(1, R"("fx": 1.0, )"), "fx", "occurs twice");
  json content = goodJson();
  content["mine"] = json::parse(R"({"fx": 1, "below": [{"fx": 2}, {"fx": 3}]})");
  EXPECT_EQ(read(content).extra["mine"], content["mine"]) << "each object has keys of its own";
}
TEST_F(CameraJsonTest, AByteThatIsZero) {
  expectRefused(goodJson().dump() + std::string(1, '\0') + "{\"fx\": 5,,,", "JSON", "has a byte that is zero");
}
TEST_F(CameraJsonTest, TextBehindTheObject) {
  expectRefused(goodJson().dump() + "}", "JSON", "");
}

TEST_F(CameraJsonTest, CutAnywhere) {
  const std::string whole = goodJson().dump();
  for (std::size_t size = 1; size < whole.size(); ++size) expectRefused(whole.substr(0, size), "JSON", "");
}

TEST_F(CameraJsonTest, NestedAMillionTimes) {
  expectRefused(std::string(1000000, '['), "JSON", "nested too deeply");
  std::string objects;
  for (int i = 0; i < 200000; ++i) objects += "{\"a\":";
  expectRefused(objects, "JSON", "nested too deeply");
}

TEST_F(CameraJsonTest, MoreThanSixteenMebibytes) {
  std::string text = goodJson().dump();
  text += std::string((16u << 20) + 1 - text.size(), ' ');
  expectRefused(text, "file", "16 MiB");
  text.pop_back();
  EXPECT_EQ(readCameraJson(write("a.json", text)).camera.width, 640);
}

TEST_F(CameraJsonTest, ZeroFx) {
  expectRefused(with("fx", "0"), "fx", "positive");
}
TEST_F(CameraJsonTest, NegativeFx) {
  expectRefused(with("fx", "-525"), "fx", "positive");
}
TEST_F(CameraJsonTest, ACameraBeyondAnyReal) {
  expectRefused(with("fx", "1e-300"), "camera", "[0.001, 1e6] pixels");
  expectRefused(with("cy", "1e300"), "camera", "[-1e6, 1e6] pixels");
}
TEST_F(CameraJsonTest, ZeroFy) {
  expectRefused(with("fy", "0.0"), "fy", "positive");
}
TEST_F(CameraJsonTest, NegativeFy) {
  expectRefused(with("fy", "-480"), "fy", "positive");
}
TEST_F(CameraJsonTest, ZeroDepthScale) {
  expectRefused(with("depth_scale", "0"), "depth_scale", "positive");
}
TEST_F(CameraJsonTest, NegativeDepthScale) {
  expectRefused(with("depth_scale", "-1"), "depth_scale", "positive");
}
TEST_F(CameraJsonTest, HugeDepthScale) {
  expectRefused(with("depth_scale", "1e300"), "depth_scale", "1000");
}
TEST_F(CameraJsonTest, FractionOfAWidth) {
  expectRefused(with("width", "640.5"), "width", "whole number");
}
TEST_F(CameraJsonTest, ZeroWidth) {
  expectRefused(with("width", "0"), "width", "from 1 to 16384");
}
TEST_F(CameraJsonTest, NegativeHeight) {
  expectRefused(with("height", "-480"), "height", "from 1 to 16384");
}
TEST_F(CameraJsonTest, WidthTooLarge) {
  expectRefused(with("width", "16385"), "width", "from 1 to 16384");
}
TEST_F(CameraJsonTest, HeightTooLarge) {
  expectRefused(with("height", "1e30"), "height", "from 1 to 16384");
}
TEST_F(CameraJsonTest, WidthThatWrapsThirtyTwoBits) {
  expectRefused(with("width", "4294967936"), "width", "16384");
}
TEST_F(CameraJsonTest, TooManyPixels) {
  json content = goodJson();
  content["width"] = content["height"] = 16384;
  expectRefused(content, "width", "64000000 pixels");
}
TEST_F(CameraJsonTest, NoiseOfTheWrongType) {
  expectRefused(with("noise", "3"), "noise", "is not a text");
}
TEST_F(CameraJsonTest, NameOfTheWrongType) {
  expectRefused(with("name", "[]"), "name", "is not a text");
}

class CameraKeyTest : public CameraJsonTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(CameraKeyTest, Missing) {
  json content = goodJson();
  content.erase(GetParam());
  expectRefused(content, GetParam(), "is missing");
}
TEST_P(CameraKeyTest, Text) {
  expectRefused(with(GetParam(), "\"640\""), GetParam(), "is not a number");
}
TEST_P(CameraKeyTest, Boolean) {
  expectRefused(with(GetParam(), "true"), GetParam(), "is not a number");
}
TEST_P(CameraKeyTest, Null) {
  expectRefused(with(GetParam(), "null"), GetParam(), "is not a number");
}
TEST_P(CameraKeyTest, List) {
  expectRefused(with(GetParam(), "[1]"), GetParam(), "is not a number");
}
TEST_P(CameraKeyTest, Object) {
  expectRefused(with(GetParam(), "{}"), GetParam(), "is not a number");
}
TEST_P(CameraKeyTest, Infinite) {
  expectRefused(with(GetParam(), "1e999"), "JSON", "1e999");
}
TEST_P(CameraKeyTest, NotANumberWord) {
  expectRefused(with(GetParam(), "NaN"), "JSON", "parse error");
}

INSTANTIATE_TEST_SUITE_P(Camera, CameraKeyTest,
                         ::testing::Values("width", "height", "fx", "fy", "cx", "cy", "depth_scale"),
                         [](const auto& case_info) { return std::string(case_info.param); });

TEST_F(CameraJsonTest, NothingUnreadableIsWritten) {
  CameraFile file;
  file.camera = {640, 480, 525.0, 525.0, 320.0, 240.0};
  const auto refused = [&](const std::string& field, const std::string& part) {
    test::expectError<OutputError>([&] { writeCameraJson(path("a.json"), file); }, path("a.json"), field, part);
  };
  file.camera.fx = std::numeric_limits<double>::quiet_NaN();
  refused("camera", "fx");
  file.camera.fx = 525.0;
  file.camera.width = 0;
  refused("camera", "size");
  file.camera.width = 640;
  file.depth_scale = 0.0;
  refused("depth_scale", "positive");
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace epcc
