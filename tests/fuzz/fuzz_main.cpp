// SPDX-License-Identifier: BSD-3-Clause
// What libFuzzer calls, for the target EPCC_FUZZ_TARGET; `PROGRAM --write-seeds FOLDER` writes the seeds and ends.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/fuzz/targets.h"

namespace {

void writeSeeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : epcc::fuzz::EPCC_FUZZ_TARGET.seeds()) {
    std::ofstream file(folder / ("seed" + std::to_string(number++)), std::ios::binary);
    if (!(file << seed).flush()) std::exit(1);
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (*argc != 3 || std::strcmp((*argv)[1], "--write-seeds") != 0) return 0;
  writeSeeds((*argv)[2]);
  std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  epcc::fuzz::EPCC_FUZZ_TARGET.run(data, size);
  return 0;
}
