// SPDX-License-Identifier: BSD-3-Clause
// Depth images, 16-bit grey PNG.
#include "datasets/files/labelled_frame.h"
#include "datasets/files/png_io.h"
#include "tests/datasets/files/png_bytes.h"
#include "tests/fuzz/file_run.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

bool runDepthPng(const std::uint8_t* data, std::size_t size) {
  return takesFile(data, size, [](const std::string& path) {
    const auto image = readGray16(path);
    require(image.width > 0 && image.height > 0, "an image has pixels");
    require(image.data.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
            "sizes agree");
    LabelledFrame frame;
    takeDepth(image, frame);
    require(frame.depth.data.size() == image.data.size(), "each value is a depth");
  });
}

std::vector<std::string> depthPngSeeds() {
  test::PngRecipe interlaced;
  interlaced.width = 11;
  interlaced.height = 9;
  interlaced.interlace = 1;
  interlaced.before_image = test::pngChunk("gAMA", test::bigEndian32(45455)) + test::pngChunk("sBIT", "\x0c") +
                            test::pngChunk("tRNS", std::string("\0\1", 2)) +
                            test::pngChunk("tEXt", std::string("a\0b", 3));
  interlaced.scan_lines = test::adam7ScanLines(std::vector<std::uint16_t>(99, 1234), interlaced.width);
  return {test::pngBytes(test::grayRecipe()), test::pngBytes(interlaced)};
}

}  // namespace

const FuzzTarget kDepthPng{runDepthPng, depthPngSeeds};

}  // namespace epcc::fuzz
