// SPDX-License-Identifier: BSD-3-Clause
// Names, checks and help texts of the options of epcc_scene.
#include "eval/scene/scene_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "datasets/files/image.h"
#include "datasets/files/text_lines.h"
#include "datasets/rendered/camera_path.h"
#include "datasets/support/input_error.h"
#include "datasets/support/joined.h"
#include "datasets/support/number_text.h"
#include "eval/program/command_line.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/number_range.h"

namespace epcc {
namespace {

constexpr const char* kDescription =
    "Renders labelled frames of rooms made of planes, with exact labels and plane coefficients.\n"
    "SCENE: a near desk (5 planes), b boxes on a desk (11), c larger room (9), d corridor (9), or all.";
constexpr const char* kFooter =
    "Exit codes: 0 done, 2 wrong usage, 3 an input could not be used, 4 an output could not be written.";
constexpr std::uint64_t kMaxSeeds = 100000;

// The options as typed.
struct RawOptions {
  std::string scene, seed, seeds, count;
  std::string noise = "none";
  std::optional<int> width, height;
  std::optional<double> fx, fy, cx, cy;
  std::string lasting;
  std::optional<std::size_t> frames;
  std::optional<double> rate;
};

bool readNumber(const std::string& text, std::uint64_t& value) {
  const auto number = wholeNumberFrom(text);
  value = number.value_or(value);
  return number.has_value();
}

std::string badNumber(const std::string& option, const std::string& text) {
  return option + ": '" + text + "' is not a whole number from 0 to 2^64 - 1";
}

// Empty, or what is wrong.
std::string setSeeds(const RawOptions& raw, SceneCommandOptions& options) {
  if (!raw.seeds.empty()) {
    const std::size_t colon = raw.seeds.find(':');
    const bool fine = colon != std::string::npos && readNumber(raw.seeds.substr(0, colon), options.first_seed) &&
                      readNumber(raw.seeds.substr(colon + 1), options.last_seed);
    if (!fine) return "--seeds: '" + raw.seeds + "' is not FIRST:LAST with two whole numbers";
    if (options.last_seed < options.first_seed) return "--seeds: the last seed is smaller than the first";
  } else {
    if (!raw.seed.empty() && !readNumber(raw.seed, options.first_seed)) return badNumber("--seed", raw.seed);
    std::uint64_t count = 1;
    if (!raw.count.empty() && !readNumber(raw.count, count)) return badNumber("--count", raw.count);
    if (count == 0) return "--count: at least 1 frame";
    if (count - 1 > std::numeric_limits<std::uint64_t>::max() - options.first_seed)
      return "--count: the last seed is larger than 2^64 - 1";
    options.last_seed = options.first_seed + (count - 1);
  }
  if (options.last_seed - options.first_seed >= kMaxSeeds) return "more than " + std::to_string(kMaxSeeds) + " seeds";
  return {};
}

std::string setCamera(const RawOptions& raw, SceneCommandOptions& options) {
  PinholeCamera camera = sceneCamera();
  const int width = raw.width.value_or(camera.width), height = raw.height.value_or(camera.height);
  if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide ||
      static_cast<long>(width) * height > kMaxPixels)
    return "--width, --height: the image must have 1 to 16384 pixels a side and at most 64 million";
  camera = sceneCamera(width, height);
  camera.fx = raw.fx.value_or(camera.fx);
  camera.fy = raw.fy.value_or(camera.fx);
  camera.cx = raw.cx.value_or(camera.cx);
  camera.cy = raw.cy.value_or(camera.cy);
  options.scene.camera = camera;
  const std::string problem = camera.validate();
  return problem.empty() ? problem : "camera: " + problem;
}

std::string setScenes(const RawOptions& raw, SceneCommandOptions& options) {
  if (raw.scene.empty()) return "SCENE is required: a, b, c, d or all";
  const std::vector<std::string> names = sceneNames();
  if (raw.scene == "all")
    options.scenes = names;
  else if (std::find(names.begin(), names.end(), raw.scene) != names.end())
    options.scenes = {raw.scene};
  else
    return "unknown scene '" + raw.scene + "'; use a, b, c, d or all";
  if (!options.path.empty() && (options.scenes.size() > 1 || options.last_seed != options.first_seed))
    return "--path takes one SCENE and one --seed";
  return options.out.empty() ? "--out is required" : "";
}

// SHARE or SHARE,LENGTH
std::string setLasting(const std::string& text, SceneCommandOptions& options) {
  if (text.empty()) return {};
  const std::vector<std::string_view> fields = fieldsOf(text);
  const auto share = numberFrom(fields[0]), length = fields.size() == 2 ? numberFrom(fields[1]) : std::nullopt;
  if (!share || fields.size() > 2 || (fields.size() == 2 && !length))
    return "--lasting: '" + text + "' is not SHARE or SHARE,LENGTH";
  options.lasting.share = *share;
  if (length) options.lasting.length = *length;
  if (!(*share >= 0.0 && *share <= 1.0)) return "--lasting: the share must be 0 to 1";
  if (!(options.lasting.length >= 0.001 && options.lasting.length <= 100.0))
    return "--lasting: the length must be 0.001 to 100 metres";
  if (options.noise.kind == NoiseKind::None) return "--lasting: there is no error without --noise";
  return {};
}

std::string setPath(const RawOptions& raw, SceneCommandOptions& options) {
  const std::string problem = setLasting(raw.lasting, options);
  if (!problem.empty()) return problem;
  if (options.path.empty()) {
    for (const auto& [given, name] :
         {std::pair(raw.frames.has_value(), "--frames"), std::pair(raw.rate.has_value(), "--rate"),
          std::pair(!raw.lasting.empty(), "--lasting")})
      if (given) return std::string(name) + " needs --path";
    return {};
  }
  options.frames = raw.frames.value_or(0);
  options.rate = raw.rate.value_or(options.rate);
  const std::vector<std::string> names = pathNames();
  const bool is_built_in = std::find(names.begin(), names.end(), options.path) != names.end();
  if (!is_built_in && options.path.find('.') == std::string::npos && options.path.find('/') == std::string::npos)
    return "--path: '" + options.path + "' is none of " + joined(names) + ", nor a FILE.txt";
  return {};
}

std::string setOptions(const RawOptions& raw, SceneCommandOptions& options) {
  std::string problem = setSeeds(raw, options);
  if (!problem.empty()) return problem;
  std::string why;
  const auto noise = parseNoise(raw.noise, &why);
  if (!noise) return "--noise: " + why;
  options.noise = *noise;
  problem = setCamera(raw, options);
  if (problem.empty()) problem = setPath(raw, options);
  if (!problem.empty()) return problem;
  if (!options.measure.empty())
    return raw.scene.empty() ? "" : "--measure-noise takes the place of SCENE, give one of them";
  return setScenes(raw, options);
}

void addOptions(CLI::App& app, RawOptions& raw, SceneCommandOptions& options) {
  app.add_option("SCENE", raw.scene, "a, b, c, d or all");
  app.add_option("--out", options.out, "folder that receives SCENE_SEED_depth.png, _labels.png and .json")
      ->type_name("DIR");
  auto* seed = app.add_option("--seed", raw.seed, "arrangement, camera pose and noise (default 0)")->type_name("N");
  auto* count = app.add_option("--count", raw.count, "number of seeds from --seed on (default 1)")->type_name("N");
  app.add_option("--seeds", raw.seeds, "both included")->type_name("FIRST:LAST")->excludes(seed)->excludes(count);
  app.add_option("--noise", raw.noise,
                 "none (default) | white:SENSOR | stereo | stereo-registered; SENSOR is a preset, A,B,L or "
                 "poly:K1,K2,K3; stereo-registered is depth warped to a finer colour grid")
      ->type_name("NOISE");
  app.add_option("--path", options.path,
                 "a sequence instead of single frames, along a way of the camera: " + joined(pathNames()) +
                     ", or a trajectory as TUM's, which is moved to begin at the scene's camera; frames get their pose "
                     "and timestamp, and the folder groundtruth.txt")
      ->type_name("NAME|FILE.txt");
  app.add_option("--frames", raw.frames, "of the path (300, or all of FILE.txt, which may have fewer)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--rate", raw.rate, "frames a second (30)")->type_name("HZ")->check(within(0.01, 10000.0));
  app.add_option("--lasting", raw.lasting,
                 "share of the error's variance that stays with the scene instead of being drawn anew for each frame, "
                 "and how far it reaches, metres (0; 0.1)")
      ->type_name("SHARE[,LENGTH]");
  app.add_option("--width", raw.width, "pixels (default 480)");
  app.add_option("--height", raw.height, "pixels (default 270)");
  app.add_option("--fx", raw.fx, "focal length, pixels (default: half the width)");
  app.add_option("--fy", raw.fy, "focal length, pixels (default: fx)");
  app.add_option("--cx", raw.cx, "principal point, pixels (default: the image's centre)");
  app.add_option("--cy", raw.cy, "principal point, pixels");
  app.add_option("--measure-noise", options.measure,
                 "folder of real labelled frames: print size and autocorrelation of their noise and of the stereo "
                 "noise on the same planes")
      ->type_name("DIR");
}

}  // namespace

std::optional<int> parseSceneOptions(int argc, const char* const* argv, SceneCommandOptions& options, std::ostream& out,
                                     std::ostream& err) {
  CLI::App app(kDescription, "epcc_scene");
  app.footer(presetLine("A preset SENSOR") + kFooter);
  app.set_version_flag("--version", versionText("epcc_scene"));
  app.set_help_flag("-h,--help", "print this help and exit");
  RawOptions raw;
  addOptions(app, raw, options);
  return parseCommandLine(app, argc, argv, out, err, [&] {
    const std::string problem = setOptions(raw, options);
    require(problem.empty(), problem);
  });
}

}  // namespace epcc
