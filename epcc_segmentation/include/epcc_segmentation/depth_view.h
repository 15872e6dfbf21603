// SPDX-License-Identifier: BSD-3-Clause
// A view on any caller's depth image: cv::Mat, sensor_msgs/Image (16UC1, 32FC1), the buffers of RealSense and Kinect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

namespace epcc {

/// Largest scale of depths, metres a unit: one that no sensor has is a mistake.
constexpr double kMaxDepthScale = 1000.0;

/// How the values of a depth image are to be read, where it is not as DepthView says.
struct DepthOptions {
  bool is_distance = false;       ///< values are lengths of the rays, as some renderers write them, instead of depths
  std::optional<double> invalid;  ///< one more value of the image, in its units, that stands for nothing measured
  double min_depth = 0.0;         ///< nearer depths are invalid, metres
  double max_depth = std::numeric_limits<double>::infinity();  ///< farther depths are invalid, metres
};

/// Depth image of height x width values in the caller's memory, row by row. Nothing is copied or owned: the memory must
/// outlive the call that reads it. T is float (metres unless `scale` says otherwise; <= 0, NaN and Inf are invalid) or
/// std::uint16_t (millimetres unless `scale` says otherwise; 0 is invalid, and so is 65535, beyond which there is no
/// number).
///
///     // cv::Mat m, CV_16UC1 in millimetres
///     DepthView<std::uint16_t>{m.ptr<std::uint16_t>(), m.cols, m.rows, (std::ptrdiff_t)m.step}
///     // sensor_msgs::Image i, 32FC1
///     DepthView<float>{(const float*)i.data.data(), (int)i.width, (int)i.height, i.step}
///     // rs2::depth_frame f
///     DepthView<std::uint16_t>{(const std::uint16_t*)f.get_data(), f.get_width(), f.get_height(),
///                              f.get_stride_in_bytes(), f.get_units()}
template <typename T>
struct DepthView {
  static_assert(std::is_same<T, float>::value || std::is_same<T, std::uint16_t>::value, "depths are float or uint16");

  const T* data = nullptr;  ///< the value in row 0, column 0
  int width = 0;            ///< pixels
  int height = 0;           ///< pixels
  /// Bytes from the start of a row to that of the next; 0: rows adjoin. Need not be a multiple of sizeof(T); negative
  /// for images stored bottom up, whose `data` is then the last row of the memory.
  std::ptrdiff_t row_stride = 0;
  /// Metres per unit, at most kMaxDepthScale.
  double scale = std::is_same<T, float>::value ? 1.0 : 0.001;
};

}  // namespace epcc
