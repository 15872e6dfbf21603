// SPDX-License-Identifier: BSD-3-Clause
// Damages files at random, the same way each time for the same seed.
#pragma once

#include <random>
#include <string>

namespace epcc::test {

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}
  /// One to four damages: bits flipped, bytes set, cut, inserted, doubled or removed, numbers and words replaced.
  std::string operator()(std::string bytes);
  /// True once in `n` times.
  bool oneIn(std::size_t n) { return below(n) == 0; }

 private:
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_() % end); }
  void damage(std::string& bytes);
  void replaceNumber(std::string& bytes);
  void replaceWord(std::string& bytes);

  std::mt19937_64 random_;
};

}  // namespace epcc::test
