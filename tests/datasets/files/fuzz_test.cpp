// SPDX-License-Identifier: BSD-3-Clause
// Damaged files are read or refused with an InputError, nothing else. EPCC_FUZZ_ITERATIONS sets how many of each kind.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>

#include "datasets/files/camera_json.h"
#include "datasets/files/npy_labels.h"
#include "datasets/files/organized_pcd.h"
#include "datasets/files/png_io.h"
#include "datasets/files/sun_raster.h"
#include "tests/datasets/files/mutator.h"
#include "tests/datasets/files/npy_bytes.h"
#include "tests/datasets/files/pcd_text.h"
#include "tests/datasets/files/png_bytes.h"
#include "tests/datasets/files/segcomp_files.h"
#include "tests/support/expect_errors.h"
#include "tests/support/memory_file.h"

namespace epcc {
namespace {

long iterations() {
  const char* given = std::getenv("EPCC_FUZZ_ITERATIONS");
  const long count = given == nullptr ? 0 : std::atol(given);
  return count > 0 ? count : 2000;
}

class FuzzTest : public test::TempFolderTest {
 protected:
  using Read = std::function<void(const std::string& file)>;
  using Repair = std::function<void(test::Mutator&, std::string& bytes)>;

  /// Reads `good` damaged in many ways. Both outcomes must occur, or the damage is not worth the time.
  void fuzz(const std::string& good, const Read& read, const Repair& repair = {}) const {
    const test::MemoryFile memory;
    const std::string& file = memory.path();
    ASSERT_TRUE(memory.fill(good));
    ASSERT_NO_THROW(read(file));
    long accepted = 0, refused = 0;
    for (long i = 0; i < iterations(); ++i) {
      test::Mutator mutate(static_cast<std::uint64_t>(i));
      std::string bytes = mutate(good);
      if (repair) repair(mutate, bytes);
      ASSERT_TRUE(memory.fill(bytes));
      try {
        read(file);
        ++accepted;
      } catch (const InputError& error) {
        test::expectOneLine(error.what());
        ++refused;
      } catch (const std::exception& error) {
        ADD_FAILURE() << "iteration " << i << ": " << error.what();
      }
      if (HasFailure()) return;
    }
    EXPECT_GT(accepted, 0);
    EXPECT_GT(refused, 0);
    RecordProperty("accepted", std::to_string(accepted));
    RecordProperty("refused", std::to_string(refused));
  }

  static void readPng(const std::string& file) {
    const auto image = readGray16(file);
    ASSERT_EQ(image.data.size(), static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  }
  static void readPcd(const std::string& file) {
    const auto cloud = readOrganizedPcd(file);
    ASSERT_EQ(cloud.xyz.size(), 3u * static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height));
    for (const float value : cloud.xyz) ASSERT_FALSE(std::isinf(value));
  }
  static void readLabelledPcd(const std::string& file) {
    const auto cloud = readOrganizedPcd(file, "label");
    ASSERT_EQ(3 * cloud.label.size(), cloud.xyz.size());
  }
  static void repairPng(test::Mutator& mutate, std::string& bytes) {
    if (!mutate.oneIn(4)) test::repairChecksums(bytes);
  }
};

TEST_F(FuzzTest, Png) {
  fuzz(test::pngBytes(test::grayRecipe()), readPng, repairPng);
}

TEST_F(FuzzTest, InterlacedPngWithChunks) {
  test::PngRecipe recipe;
  recipe.width = 11;
  recipe.height = 9;
  recipe.interlace = 1;
  recipe.before_image = test::pngChunk("gAMA", test::bigEndian32(45455)) + test::pngChunk("sBIT", "\x0c") +
                        test::pngChunk("tRNS", std::string("\0\1", 2)) + test::pngChunk("tEXt", std::string("a\0b", 3));
  recipe.scan_lines = test::adam7ScanLines(std::vector<std::uint16_t>(99, 1234), recipe.width);
  fuzz(test::pngBytes(recipe), readPng, repairPng);
}

TEST_F(FuzzTest, CameraJson) {
  const nlohmann::json good = {
      {"width", 640}, {"height", 480},        {"fx", 525.5}, {"fy", 524.5},          {"cx", 319.5},
      {"cy", 239.5},  {"depth_scale", 0.001}, {"name", "a"}, {"noise", "kinect-v1"}, {"planes", {{{"id", 1}}}}};
  fuzz(good.dump(1), [](const std::string& file) {
    const CameraFile camera = readCameraJson(file);
    ASSERT_EQ(camera.camera.validate(), "");
    ASSERT_TRUE(camera.extra.is_object());
  });
}

TEST_F(FuzzTest, AsciiPcd) {
  fuzz(test::asciiPcd(), readPcd);
}
TEST_F(FuzzTest, BinaryPcd) {
  fuzz(test::binaryPcd(), readPcd);
}
TEST_F(FuzzTest, CompressedPcd) {
  fuzz(test::compressedPcd(), readPcd);
}

TEST_F(FuzzTest, CompressedPcdWithBackReferences) {
  std::vector<float> xyz;
  for (int i = 0; i < 12 * 10; ++i)
    xyz.insert(xyz.end(), {static_cast<float>(i % 12), static_cast<float>(i / 12), 1.0f});
  epcc::writeLabelledPcd(path("good"), 12, 10, xyz, std::vector<std::uint32_t>(120, 3));
  const std::string good = test::bytesOf(path("good"));
  // Half of the damages hit the payload alone, which is what the header's checks would keep from being reached.
  const std::size_t header = good.find("binary_compressed\n") + 18;
  fuzz(good, readLabelledPcd, [&](test::Mutator& mutate, std::string& bytes) {
    if (!mutate.oneIn(2)) return;
    std::string payload = mutate(good.substr(header + 8));
    bytes = good.substr(0, header);
    test::append(bytes, static_cast<std::uint32_t>(payload.size()));
    bytes += good.substr(header + 4, 4) + payload;
  });
}

TEST_F(FuzzTest, LabelPngOfColours) {
  test::PngRecipe recipe;
  recipe.width = 6;
  recipe.height = 5;
  recipe.bit_depth = 8;
  recipe.color_type = 2;
  for (int row = 0; row < 5; ++row) recipe.scan_lines += std::string(1, '\0') + std::string(18, static_cast<char>(row));
  const auto read = [](const std::string& file) {
    for (const std::uint16_t label : readLabelPng(file).data) ASSERT_NE(label, kIgnoreLabel);
  };
  fuzz(test::pngBytes(recipe), read, repairPng);
}

TEST_F(FuzzTest, SunRaster) {
  test::SunRecipe recipe;
  recipe.width = 7;
  recipe.height = 6;
  recipe.map_length = 9;
  fuzz(test::sunHeader(recipe) + std::string(9 + 8 * 6, '\x0b'),
       [](const std::string& file) { ASSERT_FALSE(readSegcompLabels(file).empty()); });
}

TEST_F(FuzzTest, NpyLabels) {
  fuzz(test::npyFile(test::npyHeader("<f8", "(3, 4)"), test::rawBytes(std::vector<double>(12, 7.0))),
       [](const std::string& file) { ASSERT_EQ(readNpyLabels(file, 4, 3).data.size(), 12U); });
}

}  // namespace
}  // namespace epcc
