// SPDX-License-Identifier: BSD-3-Clause
// Most damages to a PNG file get their checksums mended, or none would come further than these.
#include <algorithm>
#include <cstdint>
#include <string>

#include "tests/datasets/files/png_bytes.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, max_size);
  if (seed % 8 == 0) return mutated;
  std::string bytes(reinterpret_cast<const char*>(data), mutated);
  epcc::test::repairChecksums(bytes);
  std::copy(bytes.begin(), bytes.end(), data);
  return mutated;
}
