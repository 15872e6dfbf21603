// SPDX-License-Identifier: BSD-3-Clause
// Covariances that are symmetric to the last bit.
#pragma once

#include <Eigen/Core>

namespace epcc {

/// (M + M^T) / 2. A T C T^T that is symmetric on paper is not when it was rounded: where its terms cancel, as those of
/// a far plane seen from another origin do, by many times the rounding of what is left.
template <typename Derived>
typename Derived::PlainObject symmetricPart(const Eigen::MatrixBase<Derived>& product) {
  const typename Derived::PlainObject m = product;
  return 0.5 * (m + m.transpose());
}

}  // namespace epcc
