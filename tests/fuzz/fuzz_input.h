// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as numbers, one after the other; behind the end they are 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>

namespace epcc::fuzz {

class FuzzInput {
 public:
  FuzzInput(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  std::uint8_t byte() { return at_ == end_ ? std::uint8_t{0} : *at_++; }
  /// True for one value of a byte in `n`.
  bool oneIn(int n) { return byte() % n == n - 1; }
  /// From `low` to `high`, fewer than 65536 numbers.
  int number(int low, int high) {
    const int two = raw<std::uint16_t>();
    return low + two % (high - low + 1);
  }
  /// From -4 to 4 in steps of 1/32.
  double small() { return raw<std::int8_t>() / 32.0; }

  template <typename T>
  T raw() {
    T value{};
    std::uint8_t bytes[sizeof value];
    for (std::uint8_t& one : bytes) one = byte();
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

  /// Any number: ordinary ones, those at the limits, and none.
  double anyNumber() {
    switch (byte() % 4) {
      case 0:
        return odd(byte());
      case 1:
        return raw<double>();
      case 2:
        return 1e-3 * raw<std::int16_t>();
      default:
        return small();
    }
  }

  static double odd(std::uint8_t which) {
    using Limits = std::numeric_limits<double>;
    using Floats = std::numeric_limits<float>;
    static constexpr double kOdd[] = {0.0,
                                      -0.0,
                                      1.0,
                                      -1.0,
                                      Limits::quiet_NaN(),
                                      Limits::infinity(),
                                      -Limits::infinity(),
                                      Limits::denorm_min(),
                                      Limits::min(),
                                      Limits::max(),
                                      Limits::lowest(),
                                      Floats::denorm_min(),
                                      Floats::min(),
                                      Floats::max(),
                                      Floats::lowest(),
                                      1e-38,
                                      1e-30,
                                      1e-15,
                                      1e-9,
                                      1e-6,
                                      1e-3,
                                      1e3,
                                      1e6,
                                      1e9,
                                      1e15,
                                      1e19,
                                      1e30,
                                      -1e30,
                                      65535.0,
                                      2147483647.0,
                                      4294967296.0,
                                      9223372036854775808.0};
    return kOdd[which % std::size(kOdd)];
  }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

}  // namespace epcc::fuzz
