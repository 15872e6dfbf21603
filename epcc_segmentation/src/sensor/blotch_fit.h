// SPDX-License-Identifier: BSD-3-Clause
// The blotches and the grain that explain what quadrics in parts of a block leave of its error.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sensor/block_quadrics.h"

namespace epcc {

/// Polynomials of degree 0, 1, 2 on `side` pixels, one a column.
Eigen::MatrixXd orthonormalPolynomials(int side);
/// exp(-d^2 / (2 length^2)) of pixels d apart on a line; length 0 is white.
Eigen::MatrixXd correlationMatrix(double length, int side);

/// Share of the variance of an error with correlation exp(-r^2 / (2 length^2)) that a quadric fitted to side x side
/// pixels leaves; length 0 is white.
double keptByQuadric(double length, int side);

/// An error of blotches and of grain that differs from pixel to pixel.
struct Blotches {
  double length = 0.0;    ///< radius, pixels
  double fitted = 0.0;    ///< share of the error's variance by the fit
  double share = 0.0;     ///< the same, without what grain may look like; the rest is grain
  double variance = 1.0;  ///< of the error, over the mean square that a quadric leaves of it in a block

  /// Pixels per independent sample: 2 pi effectiveLength()^2.
  double area() const;
  /// Of blotches alone that cover as many pixels a sample; 0.4 if there is grain alone.
  double effectiveLength() const;
};

/// What quadrics in blocks of one size and in their parts leave of blotches of all lengths, found once and for all.
class BlotchTable {
 public:
  explicit BlotchTable(int block_size);
  /// kept: see BlockResiduals. Least squares on kept = W kept(0) + C kept(length), W, C >= 0, and the same of the
  /// block itself, which keeps 1.
  Blotches fit(const std::array<double, kScales - 1>& kept) const;

 private:
  struct Entry {
    double length;
    std::array<double, kScales> kept;
  };
  std::array<double, kScales> white_;
  std::vector<Entry> entries_;
};

/// Of the two sizes that are measured, 16 and 32 pixels.
const BlotchTable& blotchTable(int block_size);

}  // namespace epcc
