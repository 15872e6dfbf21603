// SPDX-License-Identifier: BSD-3-Clause
// Label images of other programs: gaps, ignore, pixels without depth, files that do not fit.
#include "baselines/imported_labels_segmenter.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "datasets/files/png_io.h"
#include "tests/baselines/baseline_frames.h"

namespace epcc::test {
namespace {

class ImportedLabels : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "/imported_labels_" + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  bool segment() {
    ImportedLabelsSegmenter segmenter("other", folder_);
    const bool done = segmenter.segment(inputOf(room_), result_);
    error_ = segmenter.error();
    return done;
  }
  std::string path() const { return folder_ + "/room_labels.png"; }

  std::string folder_, error_;
  RenderedRoom room_ = renderRoom(cornerPlanes(), testCamera(64, 48));
  PlaneSegmentation result_;
};

TEST_F(ImportedLabels, TakesGapsIgnoreAndLabelsWithoutDepth) {
  LabelImage image(64, 48);
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    // Ids 1, 900 and 65534 for the three planes.
    const std::uint16_t ids[] = {0, 1, 900, 65534};
    image.data[i] = ids[room_.labels[i]];
  }
  for (int column = 0; column < 64; ++column) image.at(0, column) = kIgnoreLabel;
  for (int column = 0; column < 64; ++column) room_.depth[static_cast<std::size_t>(64 + column)] = 0.0f;
  writeGray16(path(), image);
  ASSERT_TRUE(segment()) << error_;
  EXPECT_EQ(result_.planes.size(), 3u);
  for (std::size_t i = 0; i < 2 * 64; ++i) EXPECT_EQ(result_.labels[i], 0);
  for (std::int32_t truth = 1; truth <= 3; ++truth) EXPECT_GT(bestCoverage(room_, result_, truth), 0.8);
  const auto truth = cornerPlanes();
  for (std::size_t i = 2 * 64; i < result_.labels.size(); ++i) {
    ASSERT_GT(result_.labels[i], 0);
    const Plane& plane = result_.planes[static_cast<std::size_t>(result_.labels[i] - 1)];
    ASSERT_LT((plane.coefficients - truth[static_cast<std::size_t>(room_.labels[i] - 1)]).norm(), 1e-4);
  }
}

TEST_F(ImportedLabels, ImageWithoutLabelsHasNoPlanes) {
  writeGray16(path(), LabelImage(64, 48));
  EXPECT_TRUE(segment()) << error_;
  EXPECT_TRUE(result_.planes.empty());
}

TEST_F(ImportedLabels, MissingFileIsAnError) {
  EXPECT_FALSE(segment());
  EXPECT_NE(error_.find("room_labels.png"), std::string::npos) << error_;
}

TEST_F(ImportedLabels, WrongSizeIsAnError) {
  for (const auto& size : {std::pair<int, int>{48, 64}, {64, 47}, {65, 48}}) {
    writeGray16(path(), LabelImage(size.first, size.second, 1));
    EXPECT_FALSE(segment());
    EXPECT_NE(error_.find("64x48"), std::string::npos) << error_;
    EXPECT_EQ(result_.labels, std::vector<std::int32_t>(64 * 48, 0));
  }
}

TEST_F(ImportedLabels, EightBitImageIsAnError) {
  writeRgb(path(), ColorImage(64, 48));
  EXPECT_FALSE(segment());
  EXPECT_NE(error_.find("room_labels.png"), std::string::npos) << error_;
}

TEST_F(ImportedLabels, DamagedFileIsAnError) {
  std::ofstream(path()) << "not a picture";
  EXPECT_FALSE(segment());
  EXPECT_FALSE(error_.empty());
}

TEST_F(ImportedLabels, FrameWithoutNameIsAnError) {
  ImportedLabelsSegmenter segmenter("other", folder_);
  EXPECT_FALSE(segmenter.segment({room_.frame(), mildSensor(), ""}, result_));
  EXPECT_NE(segmenter.error().find("name"), std::string::npos);
  EXPECT_EQ(segmenter.name(), "other");
}

}  // namespace
}  // namespace epcc::test
