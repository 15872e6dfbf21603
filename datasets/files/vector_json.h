// SPDX-License-Identifier: BSD-3-Clause
// Vectors as lists of numbers.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace epcc {

/// Of an Eigen vector of doubles, or of a column of a matrix.
template <typename Vector>
nlohmann::json vectorJson(const Vector& vector) {
  return std::vector<double>(vector.data(), vector.data() + vector.size());
}

}  // namespace epcc
