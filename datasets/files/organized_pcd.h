// SPDX-License-Identifier: BSD-3-Clause
// Organized PCD clouds in, labelled clouds out.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace epcc {

struct OrganizedCloud {
  int width = 0;
  int height = 0;
  std::vector<float> xyz;    ///< 3 a point, row-major; NaN = invalid, never infinite
  std::vector<float> label;  ///< one a point if a label field was asked for, else empty
  std::array<double, 7> viewpoint{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};  ///< as in PcdHeader
};

/// Reads an organized cloud with fields x, y, z of any type, in any unit. `label_field` names one
/// more field of any type, which must then exist. Line ends may be CR LF. Everything that is wrong with the file is an
/// InputError.
OrganizedCloud readOrganizedPcd(const std::string& path, const std::string& label_field = "");

/// Writes fields x y z label, organized, binary_compressed. xyz has 3 values a point.
void writeLabelledPcd(const std::string& path, int width, int height, const std::vector<float>& xyz,
                      const std::vector<std::uint32_t>& labels);

}  // namespace epcc
