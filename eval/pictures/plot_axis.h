// SPDX-License-Identifier: BSD-3-Clause
// One axis of a plot: its round numbers, and values to pixels.
#pragma once

#include <string>
#include <vector>

namespace epcc {

/// Distance of ticks on an axis of this length: 1, 2 or 5 times a power of ten, four to ten of them.
double tickStep(double length);

/// From one tick to another, such that no value is outside. A linear axis contains 0; a logarithmic one has its ticks
/// at 1, 2 and 5 times powers of ten, or at powers of ten alone beyond four of them.
class PlotAxis {
 public:
  PlotAxis(bool log, const std::vector<double>& values);

  /// Whether the value is finite and, on a logarithmic axis, positive.
  static bool canShow(bool log, double value);

  std::vector<double> ticks() const;
  std::string tickText(double tick) const;
  /// Length in pixels of the longest tick text.
  int longestText(int text_scale) const;

  void setPixels(int first, int last);
  int first() const { return first_pixel_; }
  int last() const { return last_pixel_; }
  /// Pixel of a value that can be shown.
  int at(double value) const;

 private:
  double tick(int index) const;
  void fitLinear(double low, double high);
  void fitLog(double low, double high);

  bool log_;
  double step_ = 1.0;                   // of a linear axis
  int first_tick_ = 0, last_tick_ = 1;  // indices
  int tick_stride_ = 1;
  int first_pixel_ = 0, last_pixel_ = 1;
};

}  // namespace epcc
