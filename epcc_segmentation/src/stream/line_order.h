// SPDX-License-Identifier: BSD-3-Clause
// Which scan line of a stream comes next: what is lost, late or given twice.
#pragma once

#include <cmath>
#include <cstdint>

namespace epcc {

/// The order of scan lines by their index, or by the azimuth that it follows from.
class LineOrder {
 public:
  void begin(double azimuth_step) {
    azimuth_step_ = azimuth_step;
    started_ = false;
  }
  bool isStarted() const { return started_; }
  std::int64_t last() const { return last_; }
  /// Lines between the last one and this; negative: it comes late or twice.
  std::int64_t lostBefore(std::int64_t index) const { return started_ ? index - last_ - 1 : 0; }
  /// The index of a column at an azimuth: by the nearest whole number of steps behind the last one, and before it if
  /// that is nearer.
  std::int64_t indexAt(double azimuth) const {
    if (!started_) return 0;
    constexpr double kTurn = 2.0 * 3.14159265358979323846;
    const double turned = std::remainder((azimuth - azimuth_) * (azimuth_step_ > 0.0 ? 1.0 : -1.0), kTurn);
    return last_ + std::llround(turned / std::abs(azimuth_step_));
  }
  void take(std::int64_t index, double azimuth) {
    last_ = index;
    azimuth_ = azimuth;
    started_ = true;
  }

 private:
  double azimuth_step_ = 0.0;
  bool started_ = false;
  std::int64_t last_ = 0;
  double azimuth_ = 0.0;
};

}  // namespace epcc
