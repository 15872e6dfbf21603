// SPDX-License-Identifier: BSD-3-Clause
// Seeded random numbers that do not depend on the standard library's distributions.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace epcc {

/// One stream of random numbers. std::mt19937_64 is fixed by the standard, std::normal_distribution is not.
class SceneRandom {
 public:
  /// Streams of one seed are independent of each other.
  SceneRandom(std::uint64_t seed, std::uint64_t stream) : generator_(mixed(mixed(seed) + stream)) {}

  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(generator_() >> 11) * 0x1.0p-53; }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Standard normal, by Marsaglia's polar method.
  double normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    double a = 0.0, b = 0.0, s = 0.0;
    do {
      a = uniform(-1.0, 1.0);
      b = uniform(-1.0, 1.0);
      s = a * a + b * b;
    } while (s >= 1.0 || s == 0.0);
    const double factor = std::sqrt(-2.0 * std::log(s) / s);
    spare_ = b * factor;
    has_spare_ = true;
    return a * factor;
  }

 private:
  // The finaliser of SplitMix64: neighbouring seeds give unrelated streams.
  static std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31);
  }

  std::mt19937_64 generator_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace epcc
