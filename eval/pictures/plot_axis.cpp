// SPDX-License-Identifier: BSD-3-Clause
// Ticks are counted: from the first index to the last one.
#include "eval/pictures/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "eval/pictures/bitmap_font.h"

namespace epcc {
namespace {

constexpr double kRounding = 1e-9;  // relative, of quotients and powers
constexpr int kDigits = 3;          // 1, 2, 5
constexpr int kFourDecades = 4 * kDigits;

int decadeOf(int index) {
  return (index >= 0 ? index : index - kDigits + 1) / kDigits;
}

/// ..., 0.5, 1, 2, 5, 10, 20, ...: number 0 is 1.
double roundNumber(int index) {
  constexpr double kDigit[kDigits] = {1.0, 2.0, 5.0};
  return kDigit[index - kDigits * decadeOf(index)] * std::pow(10.0, decadeOf(index));
}

/// Index of the largest round number that is not above the value.
int roundDown(double value) {
  int index = kDigits * static_cast<int>(std::floor(std::log10(value)));
  while (roundNumber(index + 1) <= value * (1.0 + kRounding)) ++index;
  return index;
}

}  // namespace

double tickStep(double length) {
  if (!(length > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double step : {0.1, 0.2, 0.5})
    if (length <= 10.0 * step * power * (1.0 + kRounding)) return step * power;
  return power;
}

PlotAxis::PlotAxis(bool log, const std::vector<double>& values) : log_(log) {
  std::vector<double> shown;
  for (const double value : values)
    if (canShow(log, value)) shown.push_back(value);
  if (shown.empty()) return;
  const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
  if (log)
    fitLog(*low, *high);
  else
    fitLinear(std::min(*low, 0.0), std::max(*high, 0.0));
}

void PlotAxis::fitLinear(double low, double high) {
  step_ = tickStep(high - low);
  first_tick_ = static_cast<int>(std::floor(low / step_ + kRounding));
  last_tick_ = std::max(first_tick_ + 1, static_cast<int>(std::ceil(high / step_ - kRounding)));
}

void PlotAxis::fitLog(double low, double high) {
  first_tick_ = last_tick_ = roundDown(low);
  while (last_tick_ == first_tick_ || roundNumber(last_tick_) < high * (1.0 - kRounding)) ++last_tick_;
  if (last_tick_ - first_tick_ <= kFourDecades) return;
  tick_stride_ = kDigits;
  first_tick_ = kDigits * decadeOf(first_tick_);
  last_tick_ = kDigits * decadeOf(last_tick_ + kDigits - 1);
}

bool PlotAxis::canShow(bool log, double value) {
  return std::isfinite(value) && (!log || value > 0.0);
}

double PlotAxis::tick(int index) const {
  return log_ ? roundNumber(index) : index * step_;
}

std::vector<double> PlotAxis::ticks() const {
  std::vector<double> result;
  for (int index = first_tick_; index <= last_tick_; index += tick_stride_) result.push_back(tick(index));
  return result;
}

std::string PlotAxis::tickText(double tick) const {
  char text[32];
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step_) - kRounding)));
  if (log_)
    std::snprintf(text, sizeof text, "%.3g", tick);
  else
    std::snprintf(text, sizeof text, "%.*f", decimals, tick);
  return text;
}

int PlotAxis::longestText(int text_scale) const {
  int longest = 0;
  for (const double tick : ticks()) longest = std::max(longest, textLength(tickText(tick), text_scale));
  return longest;
}

void PlotAxis::setPixels(int first, int last) {
  first_pixel_ = first;
  last_pixel_ = last;
}

int PlotAxis::at(double value) const {
  const auto scaled = [this](double v) { return log_ ? std::log10(v) : v; };
  const double low = scaled(tick(first_tick_)), high = scaled(tick(last_tick_));
  return first_pixel_ +
         static_cast<int>(std::lround((scaled(value) - low) / (high - low) * (last_pixel_ - first_pixel_)));
}

}  // namespace epcc
