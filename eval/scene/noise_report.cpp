// SPDX-License-Identifier: BSD-3-Clause
// Measures real frames, lays stereo noise on the planes fitted to them, and measures those the same way.
#include "eval/scene/noise_report.h"

#include <cstdio>

#include "datasets/noise/noise_measurement.h"
#include "datasets/noise/sensor_noise.h"
#include "datasets/support/input_error.h"

namespace epcc {
namespace {

constexpr std::uint64_t kSeeds = 5;  // simulated frames for each real one

std::vector<LabelledFrame> simulated(const std::vector<LabelledFrame>& real, const NoiseOptions& noise) {
  std::vector<LabelledFrame> frames;
  for (const LabelledFrame& frame : real) {
    const LabelledFrame flat = flattened(frame);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      frames.push_back(flat);
      applyNoise(frames.back(), noise, seed + kSeeds * frames.size());
    }
  }
  return frames;
}

std::string amplitudeTable(const NoiseFigures& real, const NoiseFigures& rendered) {
  std::string text = "| depth (m) | real (mm) | simulated (mm) | ratio | real pixels |\n|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < real.rms.size(); ++i) {
    if (real.pixels[i] == 0) continue;
    char line[120];
    std::snprintf(line, sizeof line, "| %.1f-%.1f | %.1f | %.1f | %.2f | %ld |\n", kNoiseDepths[i], kNoiseDepths[i + 1],
                  1e3 * real.rms[i], 1e3 * rendered.rms[i], rendered.rms[i] / real.rms[i], real.pixels[i]);
    text += line;
  }
  return text;
}

template <typename Values>
std::string correlationRow(const char* title, const Values& values) {
  std::string row = std::string("| ") + title;
  for (const double value : values) {
    char cell[32];
    std::snprintf(cell, sizeof cell, " | %.2f", value);
    row += cell;
  }
  return row + " |\n";
}

std::string correlationTable(const NoiseFigures& real, const NoiseFigures& rendered) {
  std::string head = "| autocorrelation at lag (px)", rule = "|---";
  for (const int lag : kNoiseLags) {
    head += " | " + std::to_string(lag);
    rule += "|---";
  }
  return head + " |\n" + rule + "|\n" + correlationRow("rows, real", real.along_rows) +
         correlationRow("rows, simulated", rendered.along_rows) + correlationRow("columns, real", real.along_columns) +
         correlationRow("columns, simulated", rendered.along_columns);
}

std::string section(const std::string& name, const std::vector<LabelledFrame>& frames) {
  if (frames.empty()) return {};
  const NoiseFigures real = measureNoise(frames), rendered = measureNoise(simulated(frames, *parseNoise(name)));
  char head[160];
  std::snprintf(head, sizeof head, "### %s: %zu frames, %d planes, outliers real %.1f %%, simulated %.1f %%\n\n",
                name.c_str(), frames.size(), real.planes, 100.0 * real.outlier_share, 100.0 * rendered.outlier_share);
  return head + amplitudeTable(real, rendered) + '\n' + correlationTable(real, rendered) + '\n';
}

}  // namespace

std::string noiseReport(const std::string& folder) {
  std::vector<LabelledFrame> registered, native;
  for (const std::string& name : listLabelledFrames(folder)) {
    LabelledFrame frame = readLabelledFrame(folder, name);
    if (frame.labels.empty()) continue;
    (frame.camera.noise == "realsense-registered" ? registered : native).push_back(std::move(frame));
  }
  if (registered.empty() && native.empty()) throw InputError(folder, "frames", "no labelled frame");
  return section("stereo-registered", registered) + section("stereo", native);
}

}  // namespace epcc
