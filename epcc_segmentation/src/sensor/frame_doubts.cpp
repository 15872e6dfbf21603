// SPDX-License-Identifier: BSD-3-Clause
// The error at the median of some depths; a sentence for each doubt.
#include "sensor/frame_doubts.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <limits>

#include "geometry/sensor_cloud.h"
#include "quantile.h"

namespace epcc {

namespace {

constexpr double kDoubtfulError = 0.1;
constexpr double kManyJumps = 0.1;
constexpr float kJump = 1.1f;
constexpr int kDoubtRowStep = 13;
constexpr int kPairsForDoubt = 100;
constexpr double kFewPixels = 0.05;
constexpr std::size_t kDepths = 500;  // sampled in an image, at least
constexpr double kManyAtLimit = 0.01;
constexpr double kStandApart = 0.9;  // of the neighbours of pixels at a limit jump
constexpr int kEdgesForDoubt = 20;

template <typename Visit>
void forSomeRows(const InverseDepthImage& image, const Visit& visit) {
  for (int row = kDoubtRowStep / 2; row < image.height; row += kDoubtRowStep)
    visit(image.w.data() + image.index(row, 0));
}

/// Of the pairs of valid neighbours in some rows whose depths differ, the share that differs by over a tenth.
double jumpShare(const InverseDepthImage& image) {
  int pairs = 0, jumps = 0;
  forSomeRows(image, [&](const float* w) {
    for (int i = 0; i + 1 < image.width; ++i) {
      const float least = std::min(w[i], w[i + 1]), most = std::max(w[i], w[i + 1]);
      pairs += ((least > 0.0f) & (most > least)) ? 1 : 0;
      jumps += ((least > 0.0f) & (most > kJump * least)) ? 1 : 0;
    }
  });
  return pairs >= kPairsForDoubt ? static_cast<double>(jumps) / pairs : 0.0;
}

/// The pixels of some rows that have exactly one depth.
struct Plateau {
  float w;
  int pixels = 0;
};

/// Whether its pixels are a tenth nearer or farther than their neighbours.
bool standsApart(const InverseDepthImage& image, const Plateau& plateau) {
  int edges = 0, jumps = 0;
  forSomeRows(image, [&](const float* w) {
    for (int i = 0; i + 1 < image.width; ++i) {
      if ((w[i] == plateau.w) == (w[i + 1] == plateau.w)) continue;
      const float least = std::min(w[i], w[i + 1]), most = std::max(w[i], w[i + 1]);
      edges += least > 0.0f ? 1 : 0;
      jumps += least > 0.0f && most > kJump * least ? 1 : 0;
    }
  });
  return edges >= kEdgesForDoubt && jumps >= kStandApart * edges;
}

}  // namespace

void doubtDepths(const InverseDepthImage& image, Doubts& doubts) {
  doubts.jump_share = doubts.limit_share = doubts.limit_depth = 0.0;
  if (image.place_of_pixel > 0.0) return;  // blocks of scattered pixels
  doubts.jump_share = jumpShare(image);
  if (!image.planar_rows) return;
  Plateau least{std::numeric_limits<float>::infinity()}, most{0.0f};
  forSomeRows(image, [&](const float* w) {
    for (int i = 0; i < image.width; ++i) {
      least.w = std::min(least.w, w[i] > 0.0f ? w[i] : least.w);
      most.w = std::max(most.w, w[i]);
    }
  });
  int valid = 0;
  forSomeRows(image, [&](const float* w) {
    for (int i = 0; i < image.width; ++i) {
      valid += w[i] > 0.0f ? 1 : 0;
      least.pixels += w[i] == least.w ? 1 : 0;
      most.pixels += w[i] == most.w ? 1 : 0;
    }
  });
  for (const Plateau& plateau : {least, most}) {
    const double share = valid > 0 ? static_cast<double>(plateau.pixels) / valid : 0.0;
    if (share < kManyAtLimit || share <= doubts.limit_share || !standsApart(image, plateau)) continue;
    doubts.limit_share = share;
    doubts.limit_depth = 1.0 / static_cast<double>(plateau.w);
  }
}

double errorShare(const InverseDepthImage& image, const SensorEstimate& measured, std::vector<double>& depths) {
  if (measured.blocks == 0) return 0.0;
  const std::size_t step = std::max<std::size_t>(1, image.w.size() / kDepths);
  depths.clear();
  depths.reserve(image.w.size() / step + 1);
  for (std::size_t i = step / 2; i < image.w.size(); i += step)
    if (image.w[i] > 0.0f) depths.push_back(1.0 / static_cast<double>(image.w[i]));
  if (depths.empty()) return 0.0;
  const double depth = quantile(depths, 0.5);
  return measured.model().sigmaZ(depth) / depth;
}

bool Doubts::any() const {
  return bytes_are_swapped || sensor_is_generic || jump_share >= kManyJumps || error_share >= kDoubtfulError ||
         scattered_share < kFewPixels || limit_share >= kManyAtLimit;
}

std::string Doubts::inWords() const {
  char text[320];
  std::string line;
  const auto say = [&line](const char* doubt) { line += (line.empty() ? "" : "; ") + std::string(doubt); };
  if (scattered_share <= 0.0) {
    say("no pixel is measured");
  } else if (scattered_share < kFewPixels) {
    std::snprintf(text, sizeof text, "only %.2g %% of the pixels are measured: small planes cannot be found",
                  100.0 * scattered_share);
    say(text);
  }
  if (bytes_are_swapped) {  // all else follows
    say("depth: the two bytes of each value are in the wrong order: swapped the values are smooth, and as they are "
        "they jump");
    return line;
  }
  if (sensor_is_generic)
    say("noise: the sensor's error could not be measured, for no part of the image is flat or none shows an error, and "
        "a generic model is used: is this a depth image, are the bytes of its values in the right order? If so, give a "
        "sensor model");
  if (error_share >= kDoubtfulError) {
    std::snprintf(text, sizeof text,
                  "noise: the measured error is %.0f %% of the depth, more than that of a sensor: is this a depth "
                  "image, are the bytes of its values in the right order, and what is its unit?",
                  100.0 * error_share);
    say(text);
  }
  if (jump_share >= kManyJumps && error_share < kDoubtfulError) {
    std::snprintf(text, sizeof text,
                  "depth: %.0f %% of the steps between neighbouring pixels are over a tenth of the depth, as in noise: "
                  "is this a depth image, and are the bytes of its values in the right order?",
                  100.0 * jump_share);
    say(text);
  }
  if (limit_share >= kManyAtLimit) {
    std::snprintf(
        text, sizeof text,
        "depth: %.2g %% of the pixels are exactly %.4g m away, one end of all depths, and stand apart from the "
        "others: do they stand for pixels without depth? If so, leave that value out",
        100.0 * limit_share, limit_depth);
    say(text);
  }
  return line;
}

Doubts Doubts::of(const DepthFrame& any_frame, const SensorEstimate& measured) {
  Doubts doubts;
  if (any_frame.empty()) return doubts;
  doubts.bytes_are_swapped = bytesAreSwapped(any_frame.wholeNumbers());
  SensorCloud cloud;
  InverseDepthImage image;
  ScatteredPixels scattered;
  image.read(inSensorFrame(any_frame, cloud));
  if (std::none_of(image.w.begin(), image.w.end(), [](float w) { return w > 0.0f; })) {
    doubts.scattered_share = 0.0;
    return doubts;
  }
  const bool is_scattered = scattered.find(image);
  std::vector<double> depths;
  doubts.sensor_is_generic = measured.blocks == 0;
  doubts.error_share = errorShare(is_scattered ? scattered.blocks() : image, measured, depths);
  doubtDepths(is_scattered ? scattered.blocks() : image, doubts);
  if (is_scattered) doubts.scattered_share = scattered.validShare();
  return doubts;
}

}  // namespace epcc
