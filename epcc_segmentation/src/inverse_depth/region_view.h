// SPDX-License-Identifier: BSD-3-Clause
// One region's sums for the quadric that fits its residuals.
#pragma once

#include <Eigen/Core>

#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/plane_moments.h"

namespace epcc {

/// What a quadratic surface w(u, v) explains of a region's residuals from its plane; squares in sigma^2 across the
/// surface.
struct Bending {
  double curvature = 0.0;  ///< largest principal curvature, absolute, 1/m
  double gain = 0.0;       ///< residual sum of squares that the quadratic terms take away
  double rss = 0.0;        ///< residual sum of squares of the plane
};

/// A region in the camera's coordinates u = x/z, v = y/z about its middle (u0, v0). On a scan, whose rays go all
/// around, in those of a camera turned about the scan's axis until it looks at the region.
class RegionView {
 public:
  RegionView(const PlaneMoments& region, bool turned);

  bool isOnGrid(int row) const { return row % stride_ == 0; }
  /// Pixels [begin, end) of a row, those on the grid.
  void addRun(const InverseDepthImage& image, int row, int begin, int end);
  /// Adds the pixels of another view of the region.
  RegionView& operator+=(const RegionView& other);
  Bending bending() const;

 private:
  /// Weighted sums over pixels of one v.
  struct Sums {
    double u[5] = {};         ///< of u^i
    double residual[3] = {};  ///< of residual u^i
    double rss = 0.0;

    void add(double x, double error, double weight) {
      const double xx = x * x, wx = weight * x, wxx = weight * xx, we = weight * error;
      u[0] += weight;
      u[1] += wx;
      u[2] += wxx;
      u[3] += wxx * x;
      u[4] += wxx * xx;
      residual[0] += we;
      residual[1] += we * x;
      residual[2] += we * xx;
      rss += we * error;
    }
  };

  void addPlanarRun(const InverseDepthImage& image, int row, int first, int end, double v);
  void addOfScan(const InverseDepthImage& image, int row, int column, double along);
  void add(const Sums& sums, double v);

  double sine_ = 0.0, cosine_ = 1.0, u0_ = 0.0, v0_ = 0.0, rss_ = 0.0;
  Eigen::Vector3d q_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();  // q in the turned camera: the plane's normal / distance
  double slope_factor_ = 1.0;
  int stride_ = 1;
  double products_[5][5] = {};   // [i][j]: sum of u^i v^j
  double residuals_[3][3] = {};  // the same times the residual
};

}  // namespace epcc
