// SPDX-License-Identifier: BSD-3-Clause
// A degree in radians.
#pragma once

namespace epcc {

constexpr double kDegree = 0.017453292519943295;

}  // namespace epcc
