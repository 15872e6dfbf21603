// SPDX-License-Identifier: BSD-3-Clause
// Golden-angle hues in three tones: neighbours in the palette lie far apart.
#include "eval/pictures/label_colors.h"

#include <array>
#include <cmath>

namespace epcc {
namespace {

constexpr double kGoldenAngle = 137.50776405;  // degrees
constexpr double kFirstHue = 210.0;            // the largest plane is blue

struct Tone {
  double saturation;
  double value;
};
constexpr std::array<Tone, 3> kTones = {{{0.85, 1.0}, {0.55, 1.0}, {0.95, 0.72}}};

std::uint8_t channel(double value) {
  return static_cast<std::uint8_t>(std::lround(255.0 * value));
}

// One channel of the HSV colour; shift is 5, 3, 1 for red, green, blue.
std::uint8_t hsvChannel(double hue, const Tone& tone, int shift) {
  const double k = std::fmod(shift + hue / 60.0, 6.0);
  const double dip = std::fmax(0.0, std::fmin(std::fmin(k, 4.0 - k), 1.0));
  return channel(tone.value * (1.0 - tone.saturation * dip));
}

}  // namespace

Rgb labelColor(std::int32_t label) {
  if (label <= 0) return Rgb{0, 0, 0};
  if (label == kIgnoreLabel) return Rgb{128, 128, 128};
  const double hue = std::fmod(kFirstHue + kGoldenAngle * (label - 1), 360.0);
  // Five labels bring the hue back near its start (5 x 137.5 = 687.5): the tone changes with every fifth label.
  const Tone& tone = kTones[static_cast<std::size_t>((label - 1) / 5) % kTones.size()];
  return Rgb{hsvChannel(hue, tone, 5), hsvChannel(hue, tone, 3), hsvChannel(hue, tone, 1)};
}

}  // namespace epcc
