// SPDX-License-Identifier: BSD-3-Clause
// NumPy label arrays for an image of 4x3 pixels.
#include "datasets/files/npy_labels.h"
#include "tests/datasets/files/npy_bytes.h"
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

bool runNpy(const std::uint8_t* data, std::size_t size) {
  return takesFile(data, size, [](const std::string& path) {
    const LabelImage labels = readNpyLabels(path, 4, 3);
    require(labels.width == 4 && labels.height == 3 && labels.data.size() == 12, "sizes agree");
  });
}

std::vector<std::string> npySeeds() {
  return {test::npyFile(test::npyHeader("<f8", "(3, 4)"), test::rawBytes(std::vector<double>(12, 7.0))),
          test::npyFile(test::npyHeader("<f4", "(12,)"), test::rawBytes(std::vector<float>(12, 65535.0F))),
          test::npyFile(test::npyHeader("|u1", "(3L, 4L)"), std::string(12, '\3')),
          test::npyFile(test::npyHeader("<i8", "(3, 4)"), test::rawBytes(std::vector<std::int64_t>(12, 1))),
          test::npyFile(test::npyHeader("<u2", "(3, 4)"), test::rawBytes(std::vector<std::uint16_t>(12, 9)))};
}

}  // namespace

const FuzzTarget kNpy{runNpy, npySeeds};

}  // namespace epcc::fuzz
