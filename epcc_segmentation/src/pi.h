// SPDX-License-Identifier: BSD-3-Clause
// Pi, which C++17 does not name.
#pragma once

namespace epcc {

constexpr double kPi = 3.14159265358979323846;

}  // namespace epcc
