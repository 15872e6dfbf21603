// SPDX-License-Identifier: BSD-3-Clause
// FNV-1a: a hash that is the same on every machine, so that shards agree.
#pragma once

#include <cstdint>
#include <string>

namespace epcc {

constexpr std::uint64_t kTextHashStart = 14695981039346656037ULL;

/// Goes on from `start`: texts may be hashed one after the other.
inline std::uint64_t textHash(const std::string& text, std::uint64_t start = kTextHashStart) {
  std::uint64_t hash = start;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

}  // namespace epcc
