// SPDX-License-Identifier: BSD-3-Clause
// A view on one organized range measurement: pinhole depth image, organized cloud or spherical scan.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/depth_view.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/projection.h"
#include "epcc_segmentation/status.h"

namespace epcc {

/// Pinhole intrinsics in pixels; frame x right, y down, z forward. Pixel centres at whole numbers.
struct PinholeCamera {
  int width = 0;    ///< columns of the image
  int height = 0;   ///< rows of the image
  double fx = 0.0;  ///< focal length along the rows, pixels; [0.001, 1e6]
  double fy = 0.0;  ///< focal length along the columns, pixels; [0.001, 1e6]
  double cx = 0.0;  ///< column of the optical axis, pixels; (width - 1) / 2 is the middle of the image
  double cy = 0.0;  ///< row of the optical axis, pixels; (height - 1) / 2 is the middle of the image

  /// Empty if usable, else what is wrong in words.
  EPCC_CORE_EXPORT std::string validate() const;
};

/// A view on a depth image, an organized cloud or a scan, row by row: nothing is copied, and the data must outlive it.
/// Cheap to copy.
///
/// The algorithm works in a *scan frame* in which every scan line is a column: across (x), along the
/// scan line (y), forward (z). scanPoint() gives a point in it, fromScan() turns it back; transposed() gives the view
/// whose columns are this view's rows (Sec. 7.2 of the paper).
///
/// A view that cannot be used (no data, a camera of another size, ...) is empty(): status() and problem() say why.
class EPCC_CORE_EXPORT DepthFrame {
 public:
  /// Depth image of floats, metres unless the view's scale says otherwise, of the camera's size. Unusable where the
  /// view is empty (Status::EmptyCloud), of another size (SizeMismatch), or the camera invalid (InvalidCamera).
  static DepthFrame fromDepth(const DepthView<float>& depth, const PinholeCamera& camera);
  /// The same of 16-bit values, millimetres unless the view's scale says otherwise.
  static DepthFrame fromDepth(const DepthView<std::uint16_t>& depth, const PinholeCamera& camera);
  /// Depth image in metres, camera.width * camera.height adjoining values; <= 0, NaN and Inf are invalid.
  static DepthFrame fromDepth(const float* depth, const PinholeCamera& camera);
  /// Organized cloud: x, y, z at `xyz + stride * (row * width + column)`, stride in floats.
  /// Perspective clouds are in the camera frame (x right, y down, z forward; backward ones x right, y up, z back);
  /// spherical ones x forward, y left, z up.
  static DepthFrame fromPoints(const float* xyz, std::size_t stride, int width, int height, Projection projection);
  /// Organized cloud of any frame, unit and order of pixels, as findGeometry() found it; the geometry must outlive the
  /// view, too. Unusable if none was found.
  static DepthFrame fromPoints(const float* xyz, std::size_t stride, int width, int height,
                               const CloudGeometry& geometry);

  /// The depth image read in another way; of a cloud CloudOptions say it. Unusable (InvalidParameters) unless
  /// 0 <= min_depth < max_depth.
  DepthFrame readAs(const DepthOptions& options) const;
  /// Pixels with mask[row * width + column] == 0 count as invalid; nullptr: none.
  DepthFrame masked(const std::uint8_t* mask) const;
  /// Rows become columns, x and y change places.
  DepthFrame transposed() const;
  /// Of a scanner's cloud: the last column adjoins the first.
  DepthFrame closedRound() const;

  /// Columns of this view; 0 if it is empty.
  int width() const noexcept { return width_; }
  /// Rows of this view; 0 if it is empty.
  int height() const noexcept { return height_; }
  /// Whether the view cannot be used.
  bool empty() const noexcept { return width_ <= 0 || height_ <= 0; }
  /// Ok, or why the view is empty.
  Status status() const noexcept { return status_; }
  /// The same in words; empty if there is nothing wrong.
  std::string problem() const { return problem_; }
  /// How its pixels see the world; of a cloud with a geometry() how its sensor does.
  Projection projection() const noexcept { return projection_; }
  /// Whether it is a depth image with a camera, and not a cloud.
  bool isPinhole() const noexcept { return depth_ != nullptr; }
  /// Whether rows and columns are exchanged, see transposed().
  bool isTransposed() const noexcept { return transposed_; }
  /// Whether the last column adjoins the first, see closedRound().
  bool closesRound() const noexcept { return closes_round_; }
  /// How a cloud is turned into the sensor's frame before it is segmented; null if it is in it.
  const CloudGeometry* geometry() const noexcept { return geometry_; }

  /// Index of the pixel in row-major arrays of width x height (labels, masks, points), also from a transposed view.
  std::size_t index(int row, int column) const noexcept {
    return static_cast<std::size_t>(row) * row_stride_ + static_cast<std::size_t>(column) * column_stride_;
  }

  /// Point in the scan frame, metres. False for an invalid pixel. Of a cloud with a geometry() it is the scan frame of
  /// its sensor, pixel by pixel in the cloud's own order.
  bool scanPoint(int row, int column, Eigen::Vector3d& point) const;
  /// A point of the scan frame in the sensor's own frame, or the cloud's.
  Eigen::Vector3d fromScan(const Eigen::Vector3d& scan_point) const;
  /// Point in the sensor's own frame, or the cloud's, metres. False for an invalid pixel.
  bool point(int row, int column, Eigen::Vector3d& point) const;
  /// Of a pinhole frame (isPinhole()): writes the width() depths of a row in metres, 0 for invalid pixels.
  void depthRow(int row, float* depth) const;
  /// Of a pinhole frame: the slope u = (c - cx)/fx of the rays of a column, x/z; v of the image's row if transposed.
  double pinholeAcross(int column) const {
    return transposed_ ? (column - camera_.cy) / camera_.fy : (column - camera_.cx) / camera_.fx;
  }
  /// Of a pinhole frame: the slope v = (r - cy)/fy of the rays of a row, y/z; u of the image's column if transposed.
  double pinholeAlong(int row) const {
    return transposed_ ? (row - camera_.cx) / camera_.fx : (row - camera_.cy) / camera_.fy;
  }
  /// Of a depth image of 16-bit values: the image itself, also from a transposed view. Of any other frame its data is
  /// null.
  DepthView<std::uint16_t> wholeNumbers() const;
  /// Of a cloud: x, y, z of pixel i at points() + pointStride() * i with i = index(); null of a depth image.
  const float* points() const noexcept { return xyz_; }
  /// Of a cloud: floats from a point to the next.
  std::size_t pointStride() const noexcept { return point_stride_; }
  /// What masked() was given, 0 at pixels that count as invalid; null if there is none.
  const std::uint8_t* mask() const noexcept { return mask_; }
  /// The measured value of a point of the scan frame: z, or the range.
  double measuredDepth(const Eigen::Vector3d& scan_point) const {
    return isPerspective(projection_) ? scan_point.z() : scan_point.norm();
  }

 private:
  static constexpr std::uint16_t kNoDepth = 65535;

  DepthFrame() = default;
  template <typename T>
  static DepthFrame ofView(const DepthView<T>& depth, const PinholeCamera& camera);
  void setSize(int width, int height);
  template <typename T>
  void readRow(int row, float* depth) const;
  static DepthFrame unusable(Status status, const char* problem);
  bool sensorPoint(int row, int column, double& x, double& y, double& z) const;
  bool posedPoint(int row, int column, double& x, double& y, double& z) const;
  /// Metres: it may be invalid.
  float depthAt(int row, int column) const {
    const float depth = storedDepth(row, column);
    return has_options_ ? asRead(row, column, depth) : depth;
  }
  float asRead(int row, int column, float depth) const;
  /// As the image has it.
  float storedDepth(int row, int column) const {
    const char* value = depth_ + row * depth_row_stride_ + column * depth_column_stride_;
    if (depth_is_float_) {
      float metres;
      std::memcpy(&metres, value, sizeof metres);
      return scale_ == 1.0 ? metres : static_cast<float>(metres * scale_);
    }
    std::uint16_t units;
    std::memcpy(&units, value, sizeof units);
    return units == kNoDepth ? 0.0f : static_cast<float>(units * scale_);
  }

  Status status_ = Status::EmptyCloud;
  const char* problem_ = "the frame is empty";
  const char* depth_ = nullptr;
  bool depth_is_float_ = true;
  std::ptrdiff_t depth_row_stride_ = 0;  // bytes, of this view's rows and columns
  std::ptrdiff_t depth_column_stride_ = 0;
  double scale_ = 1.0;
  bool has_options_ = false;
  DepthOptions options_;
  const float* xyz_ = nullptr;
  std::size_t point_stride_ = 0;
  const std::uint8_t* mask_ = nullptr;
  PinholeCamera camera_;  // of the untransposed image
  int width_ = 0;
  int height_ = 0;
  std::size_t row_stride_ = 0;
  std::size_t column_stride_ = 0;
  Projection projection_ = Projection::Perspective;
  bool transposed_ = false;
  bool closes_round_ = false;
  const CloudGeometry* geometry_ = nullptr;
};

// Inline, for they are called once a pixel.
inline bool DepthFrame::sensorPoint(int row, int column, double& x, double& y, double& z) const {
  const std::size_t pixel = index(row, column);
  if (mask_ != nullptr && mask_[pixel] == 0) return false;
  if (depth_ != nullptr) {
    z = static_cast<double>(depthAt(row, column));
    if (!(z > 0.0) || !std::isfinite(z)) return false;
    const int image_row = transposed_ ? column : row;
    const int image_column = transposed_ ? row : column;
    x = z * ((image_column - camera_.cx) / camera_.fx);
    y = z * ((image_row - camera_.cy) / camera_.fy);
    return true;
  }
  if (geometry_ != nullptr) return posedPoint(row, column, x, y, z);
  const float* p = xyz_ + pixel * point_stride_;
  if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return false;
  x = static_cast<double>(p[0]);
  y = static_cast<double>(p[1]);
  z = static_cast<double>(p[2]);
  if (projection_ == Projection::Spherical) return x * x + y * y + z * z > 0.0;
  return projection_ == Projection::Perspective ? z > 0.0 : z < 0.0;
}

inline bool DepthFrame::scanPoint(int row, int column, Eigen::Vector3d& point) const {
  double x, y, z;
  if (!sensorPoint(row, column, x, y, z)) return false;
  // Spherical scans: x forward, y left, z up becomes across = right, along = down, forward.
  if (projection_ == Projection::Spherical) {
    const double forward = x;
    x = -y;
    y = -z;
    z = forward;
  }
  if (projection_ == Projection::PerspectiveBackward) {
    y = -y;
    z = -z;
  }
  if (transposed_) std::swap(x, y);
  point = Eigen::Vector3d(x, y, z);
  return true;
}

inline bool DepthFrame::point(int row, int column, Eigen::Vector3d& point) const {
  double x, y, z;
  if (!sensorPoint(row, column, x, y, z)) return false;
  point = Eigen::Vector3d(x, y, z);
  if (geometry_ != nullptr) point = geometry_->pose.axes * point + geometry_->pose.origin;
  return true;
}

/// The projection of findGeometry(): what a cloud was measured with, whatever its frame is.
EPCC_CORE_EXPORT Projection detectProjection(const float* xyz, std::size_t stride, int width, int height);

}  // namespace epcc
