// SPDX-License-Identifier: BSD-3-Clause
// Depth images of any caller: types, scales and strides give the planes of the plain image; unusable ones say why.
#include "epcc_segmentation/depth_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "epcc_segmentation/plane_extractor.h"
#include "tests/support/rendered_room.h"

namespace epcc {
namespace {

constexpr int kViewColumns = 160;
constexpr int kViewRows = 120;

/// A corner of a room in whole millimetres, with holes.
class DepthViewTest : public ::testing::Test {
 protected:
  DepthViewTest() : room_(test::renderRoom(test::cornerPlanes(), test::testCamera(kViewColumns, kViewRows))) {
    for (std::size_t i = 0; i < room_.depth.size(); ++i) {
      const double units = i % 97 == 0 ? 0.0 : std::round(1000.0 * static_cast<double>(room_.depth[i]));
      units_.push_back(static_cast<std::uint16_t>(units));
      metres_.push_back(static_cast<float>(units * 0.001));
    }
  }
  const PinholeCamera& camera() const { return room_.camera; }

  static PlaneSegmentation segmented(const DepthFrame& frame) {
    EXPECT_EQ(frame.problem(), "");
    PlaneExtractor extractor(Parameters(), SensorModel::axial(0.002, 0.0));
    PlaneSegmentation result;
    EXPECT_TRUE(extractor.extract(frame, result)) << extractor.error();
    EXPECT_EQ(result.planes.size(), 3u);
    return result;
  }
  PlaneSegmentation expected() const { return segmented(DepthFrame::fromDepth(metres_.data(), camera())); }

  /// The rows of an image, `stride` bytes apart, as the bytes of a sensor_msgs/Image.
  template <typename T>
  static std::vector<std::uint8_t> padded(const std::vector<T>& image, std::size_t stride) {
    std::vector<std::uint8_t> bytes(stride * kViewRows, 0xFF);
    for (std::size_t row = 0; row < kViewRows; ++row)
      std::memcpy(&bytes[row * stride], &image[row * kViewColumns], kViewColumns * sizeof(T));
    return bytes;
  }

  test::RenderedRoom room_;
  std::vector<std::uint16_t> units_;
  std::vector<float> metres_;
};

TEST_F(DepthViewTest, SixteenBitMillimetresAreTheSameImage) {
  const DepthView<std::uint16_t> view{units_.data(), kViewColumns, kViewRows};
  EXPECT_EQ(segmented(DepthFrame::fromDepth(view, camera())).labels, expected().labels);
}

TEST_F(DepthViewTest, OtherUnitsHaveAScale) {
  std::vector<float> centimetres;
  for (const float z : metres_) centimetres.push_back(100.0f * z);
  const DepthView<float> view{centimetres.data(), kViewColumns, kViewRows, 0, 0.01};
  EXPECT_EQ(segmented(DepthFrame::fromDepth(view, camera())).labels, expected().labels);

  std::vector<std::uint16_t> fifths;  // TUM RGB-D: 5000 units a metre
  for (const std::uint16_t unit : units_) fifths.push_back(static_cast<std::uint16_t>(5 * unit));
  const DepthView<std::uint16_t> tum{fifths.data(), kViewColumns, kViewRows, 0, 1.0 / 5000.0};
  EXPECT_EQ(segmented(DepthFrame::fromDepth(tum, camera())).labels, expected().labels);
}

TEST_F(DepthViewTest, RowsMayBePaddedToAnyNumberOfBytes) {
  for (const std::size_t stride : {4u * kViewColumns, 4u * kViewColumns + 4u, 4u * kViewColumns + 7u}) {
    const auto bytes = padded(metres_, stride);
    const DepthView<float> view{reinterpret_cast<const float*>(bytes.data()), kViewColumns, kViewRows,
                                static_cast<std::ptrdiff_t>(stride)};
    const PlaneSegmentation result = segmented(DepthFrame::fromDepth(view, camera()));
    EXPECT_EQ(result.labels, expected().labels) << stride;
    EXPECT_EQ(result.planes[0].coefficients, expected().planes[0].coefficients) << stride;
  }
  const auto bytes = padded(units_, 2u * kViewColumns + 3u);
  const DepthView<std::uint16_t> view{reinterpret_cast<const std::uint16_t*>(bytes.data()), kViewColumns, kViewRows,
                                      2 * kViewColumns + 3};
  EXPECT_EQ(segmented(DepthFrame::fromDepth(view, camera())).labels, expected().labels);
}

TEST_F(DepthViewTest, BothModesReadEveryView) {
  const auto bytes = padded(units_, 2u * kViewColumns + 10u);
  const DepthView<std::uint16_t> view{reinterpret_cast<const std::uint16_t*>(bytes.data()), kViewColumns, kViewRows,
                                      2 * kViewColumns + 10};
  for (const ScanDirection scan : {ScanDirection::Columns, ScanDirection::Rows}) {
    Parameters parameters = Parameters::forPaper();
    parameters.scan = scan;
    PlaneExtractor extractor(parameters, SensorModel::axial(0.002, 0.0));
    PlaneSegmentation plain, strided;
    ASSERT_TRUE(extractor.extract(DepthFrame::fromDepth(metres_.data(), camera()), plain));
    ASSERT_TRUE(extractor.extract(DepthFrame::fromDepth(view, camera()), strided));
    EXPECT_GE(plain.planes.size(), 3u);
    EXPECT_EQ(strided.labels, plain.labels);
  }
}

TEST_F(DepthViewTest, ImagesStoredBottomUpHaveANegativeStride) {
  std::vector<float> flipped;
  for (int row = kViewRows - 1; row >= 0; --row)
    flipped.insert(flipped.end(), metres_.begin() + row * kViewColumns, metres_.begin() + (row + 1) * kViewColumns);
  const DepthView<float> view{flipped.data() + (kViewRows - 1) * kViewColumns, kViewColumns, kViewRows,
                              -4 * kViewColumns};
  EXPECT_EQ(segmented(DepthFrame::fromDepth(view, camera())).labels, expected().labels);
}

TEST_F(DepthViewTest, UnusableViewsSayWhy) {
  PinholeCamera other = camera();
  other.width = 80;
  PinholeCamera no_focus = camera();
  no_focus.fx = 0.0;
  const float* data = metres_.data();
  const struct {
    DepthFrame frame;
    Status status;
    const char* words;
  } cases[] = {
      {DepthFrame::fromDepth(DepthView<float>{nullptr, kViewColumns, kViewRows}, camera()), Status::EmptyCloud,
       "empty"},
      {DepthFrame::fromDepth(DepthView<float>{data, 0, kViewRows}, camera()), Status::EmptyCloud, "empty"},
      {DepthFrame::fromDepth(DepthView<float>{data, kViewColumns, kViewRows}, other), Status::SizeMismatch, "size"},
      {DepthFrame::fromDepth(DepthView<float>{data, kViewColumns, kViewRows}, no_focus), Status::InvalidCamera, "fx"},
      {DepthFrame::fromDepth(DepthView<float>{data, kViewColumns, kViewRows, kViewColumns}, camera()),
       Status::SizeMismatch, "stride"},
      {DepthFrame::fromDepth(DepthView<float>{data, kViewColumns, kViewRows, 0, 0.0}, camera()), Status::InvalidCamera,
       "scale"},
  };
  for (const auto& bad : cases) {
    EXPECT_TRUE(bad.frame.empty());
    EXPECT_NE(bad.frame.problem().find(bad.words), std::string::npos) << bad.frame.problem();
    PlaneExtractor extractor;
    PlaneSegmentation result;
    EXPECT_FALSE(extractor.extract(bad.frame, result));
    EXPECT_EQ(extractor.status(), bad.status) << extractor.error();
    EXPECT_EQ(extractor.error(), bad.frame.problem());
  }
}

}  // namespace
}  // namespace epcc
