// SPDX-License-Identifier: BSD-3-Clause
// "I/N" on the command line: share I of N, counted from 1.
#include "eval/batch/shard.h"

namespace epcc {

namespace {

constexpr std::size_t kMaxShards = 1000000;

/// 0 for anything but one to seven digits.
std::size_t wholeNumber(const std::string& text) {
  if (text.empty() || text.size() > 7 || text.find_first_not_of("0123456789") != std::string::npos) return 0;
  return std::stoul(text);
}

}  // namespace

std::optional<Shard> parseShard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const Shard shard{wholeNumber(text.substr(0, slash)), wholeNumber(text.substr(slash + 1))};
  if (shard.number < 1 || shard.number > shard.count || shard.count > kMaxShards) return std::nullopt;
  return shard;
}

}  // namespace epcc
