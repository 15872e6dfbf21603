// SPDX-License-Identifier: BSD-3-Clause
// Sun rasters of the SegComp comparison.
#include "datasets/files/sun_raster.h"
#include "tests/datasets/files/segcomp_files.h"
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

bool runSegcomp(const std::uint8_t* data, std::size_t size) {
  return takesFile(data, size, [](const std::string& path) {
    const LabelImage labels = readSegcompLabels(path);
    require(isSunRaster(path), "what is read is recognised");
    require(labels.width > 0 && labels.height > 0, "an image has pixels");
    require(labels.data.size() == static_cast<std::size_t>(labels.width) * static_cast<std::size_t>(labels.height),
            "sizes agree");
    for (const std::uint16_t label : labels.data)
      require(label == 0 || (label >= 10 && label < 256), "labels are planes");
  });
}

std::vector<std::string> segcompSeeds() {
  test::SunRecipe recipe;
  recipe.width = 7;
  recipe.height = 6;
  recipe.map_length = 9;
  test::SunRecipe even;
  even.width = 4;
  even.height = 3;
  even.type = 1;
  return {test::sunHeader(recipe) + std::string(9 + 8 * 6, '\x0b'), test::sunHeader(even) + std::string(4 * 3, '\x09')};
}

}  // namespace

const FuzzTarget kSegcomp{runSegcomp, segcompSeeds};

}  // namespace epcc::fuzz
