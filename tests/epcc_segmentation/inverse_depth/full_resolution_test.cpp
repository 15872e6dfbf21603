// SPDX-License-Identifier: BSD-3-Clause
// From the labels of samples to those of all pixels: borders, thin things, holes, threads.
#include "inverse_depth/full_resolution.h"

#include <gtest/gtest.h>

#include "inverse_depth/sample_grid.h"
#include "tests/epcc_segmentation/inverse_depth/region_fixture.h"

namespace {

using epcc::FullResolution;
using epcc::InverseDepthImage;
using epcc::InverseDepthParameters;
using epcc::RegionMap;
using epcc::test::RenderedRoom;

using Labels = std::vector<std::int32_t>;

RenderedRoom oddRoom(int width = 161, int height = 119) {
  return epcc::test::renderRoom(epcc::test::cornerPlanes(), epcc::test::testCamera(width, height));
}

/// The true labels at the samples, with the planes of the samples.
RegionMap truthOnGrid(const RenderedRoom& room, const InverseDepthImage& samples, int stride) {
  Labels labels;
  for (int row = 0; row < samples.height; ++row)
    for (int column = 0; column < samples.width; ++column)
      labels.push_back(room.labels[static_cast<std::size_t>(
          std::min(stride / 2 + row * stride, room.camera.height - 1) * room.camera.width +
          std::min(stride / 2 + column * stride, room.camera.width - 1))]);
  return epcc::test::regionsOf(samples, labels, 3);
}

Labels labelled(const RenderedRoom& room, int stride, int threads = 1,
                const epcc::SensorModel& sensor = epcc::test::kWhite) {
  const InverseDepthImage image = epcc::test::imageOf(room, sensor);
  InverseDepthImage samples;
  samples.sample(image, stride);
  samples.weigh(sensor, image.placeVariance());
  Labels labels;
  FullResolution().label(image, samples.noise, truthOnGrid(room, samples, stride), stride,
                         InverseDepthParameters().expert.refinement, threads, labels);
  return labels;
}

double disagreement(const Labels& a, const Labels& b) {
  std::size_t differ = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differ += a[i] != b[i] ? 1 : 0;
  return static_cast<double>(differ) / static_cast<double>(a.size());
}

TEST(FullResolution, CreasesAreAsSharpAsThePixels) {
  for (const int stride : {2, 3, 4}) {
    const RenderedRoom clean = oddRoom();
    EXPECT_LT(disagreement(labelled(clean, stride), clean.labels), 0.001) << stride;
  }
}

// Along a crease the planes differ by less than the error: by their residuals alone a third of the pixels would stray.
TEST(FullResolution, CreasesAreDecidedByGeometryNotByNoise) {
  for (const int stride : {2, 4}) {
    const epcc::SensorModel noise = epcc::SensorModel::axial(0.01, 0.0, 1.0);
    RenderedRoom noisy = oddRoom();
    epcc::test::addNoise(noisy, noise, 3);
    const Labels labels = labelled(noisy, stride, 1, noise);
    std::size_t strays = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) strays += labels[i] != 0 && labels[i] != noisy.labels[i] ? 1 : 0;
    EXPECT_LT(static_cast<double>(strays), 0.004 * static_cast<double>(labels.size())) << stride;
  }
}

TEST(FullResolution, AThinThingBetweenTheSamplesIsNoPartOfTheWall) {
  RenderedRoom scene = oddRoom();
  const auto width = static_cast<std::size_t>(scene.camera.width);
  for (std::size_t i = 80; i < scene.depth.size(); i += width) {  // the samples of stride 2 are the odd columns
    scene.depth[i] *= 0.7f;
    scene.labels[i] = 0;
  }
  const Labels labels = labelled(scene, 2);
  for (std::size_t i = 80; i < labels.size(); i += width) EXPECT_EQ(labels[i], 0) << i / width;
}

TEST(FullResolution, TheRowsOfALabelHoldAllItsPixels) {
  for (const int stride : {2, 3, 4})
    for (const int threads : {1, 3}) {
      const RenderedRoom room = oddRoom();
      const InverseDepthImage image = epcc::test::imageOf(room, epcc::test::kWhite);
      InverseDepthImage samples;
      samples.sample(image, stride);
      samples.weigh(epcc::test::kWhite, image.placeVariance());
      Labels labels;
      FullResolution full;
      full.label(image, samples.noise, truthOnGrid(room, samples, stride), stride,
                 InverseDepthParameters().expert.refinement, threads, labels);
      std::vector<epcc::RowSpan> seen(4);
      for (std::size_t i = 0; i < labels.size(); ++i)
        seen[static_cast<std::size_t>(labels[i])].add(static_cast<int>(i) / room.camera.width);
      ASSERT_EQ(full.pixelRows().size(), seen.size());
      for (std::size_t k = 1; k < seen.size(); ++k) {
        EXPECT_LE(full.pixelRows()[k].begin, seen[k].begin) << k;
        EXPECT_GE(full.pixelRows()[k].end, seen[k].end) << k;
        EXPECT_LE(full.pixelRows()[k].end - full.pixelRows()[k].begin, seen[k].end - seen[k].begin + 3 * stride) << k;
      }
    }
}

TEST(FullResolution, PixelsWithoutDepthHaveNoLabel) {
  RenderedRoom scene = oddRoom();
  for (std::size_t i = 0; i < scene.depth.size(); i += 3) scene.depth[i] = 0.0f;
  const Labels labels = labelled(scene, 3, 1, epcc::SensorModel::axial(1.0, 1.0, 1.0));  // 0 1/m is within this error
  for (std::size_t i = 0; i < labels.size(); i += 3) EXPECT_EQ(labels[i], 0) << i;
}

TEST(FullResolution, ThreadsChangeNothing) {
  RenderedRoom noisy = oddRoom();
  epcc::test::addNoise(noisy, epcc::test::kWhite, 5);
  EXPECT_EQ(labelled(noisy, 2, 1), labelled(noisy, 2, 3));
}

TEST(FullResolution, ImagesSmallerThanTheStride) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{3, 2}, std::pair{2, 40}, std::pair{40, 1}}) {
    const RenderedRoom tiny = oddRoom(width, height);
    EXPECT_EQ(labelled(tiny, 4).size(), tiny.labels.size());
  }
}

}  // namespace
