// SPDX-License-Identifier: BSD-3-Clause
// S1: what lines grow from, and that every vector unit grows those of a plain loop over one scan line, bit for bit.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "epcc_segmentation/vector_unit.h"
#include "inverse_depth/line_growing.h"
#include "inverse_depth/line_strips.h"
#include "tests/support/sanitized.h"

namespace {

using epcc::GrownLine;
using epcc::InverseDepthImage;
using epcc::InverseDepthParameters;

// ---- the plain form ----

struct Grown {
  std::vector<GrownLine> lines;
  std::vector<std::int32_t> segment_of;
};

struct Sample {
  int position;
  float x, w, weight;
};

/// Algorithm 1 over one scan line, in the arithmetic of the kernel.
class PlainLineGrowing {
 public:
  explicit PlainLineGrowing(const InverseDepthParameters& parameters)
      : k2_(static_cast<float>(parameters.line_k_max) * static_cast<float>(parameters.line_k_max)),
        min_samples_(parameters.expert.lines.min_samples),
        reach_(parameters.expert.lines.max_gap_pixels + 1) {}

  Grown grow(const std::vector<Sample>& samples) {
    grown_ = Grown();
    grown_.segment_of.assign(samples.size(), -1);
    buffer_.clear();
    active_ = false;
    for (const Sample& sample : samples) {
      if (!(sample.w > 0.0f)) continue;
      if (active_ && sample.position - line_.last > reach_) emit();
      if (active_ && isOnLine(sample)) {
        add(sample);
        buffer_.clear();
        continue;
      }
      if (!buffer_.empty() && sample.position - buffer_.back().position > reach_) buffer_.clear();
      buffer_.push_back(sample);
      if (static_cast<int>(buffer_.size()) > min_samples_) buffer_.erase(buffer_.begin());
      if (static_cast<int>(buffer_.size()) == min_samples_) startLine();
    }
    if (active_) emit();
    return grown_;
  }

 private:
  bool isOnLine(const Sample& s) const {
    const float residual = (s.w - line_.mean_w) * line_.sxx - (s.x - line_.mean_x) * line_.sxw;
    return residual * residual * s.weight <= k2_ * (line_.sxx * line_.sxx);
  }
  void add(const Sample& s) {
    const float dx = s.x - line_.mean_x;
    const float dw = s.w - line_.mean_w;
    const float sum = line_.weight + s.weight;
    const float r = s.weight / sum;
    const float g = line_.weight * r;
    line_.weight = sum;
    line_.mean_x += r * dx;
    line_.mean_w += r * dw;
    line_.sxx += g * dx * dx;
    line_.sxw += g * dx * dw;
    ++line_.n;
    line_.last = s.position;
    own(s);
  }
  void startLine() {
    const Sample& now = buffer_.back();
    float one = 0, sx = 0, sw = 0, xx = 0, xw = 0, ww = 0;
    for (auto s = buffer_.rbegin(); s != buffer_.rend(); ++s) {
      const float dx = s->x - now.x;
      const float dw = s->w - now.w;
      one += s->weight;
      sx += s->weight * dx;
      sw += s->weight * dw;
      xx += s->weight * dx * dx;
      xw += s->weight * dx * dw;
      ww += s->weight * dw * dw;
    }
    const float mx = sx / one, mw = sw / one;
    const float sxx = xx - sx * mx, sxw = xw - sx * mw, sww = ww - sw * mw;
    const float max_rss = static_cast<float>(min_samples_ - 2) * k2_;
    if (!(sxx > 1e-12f * one) || !(sww * sxx - sxw * sxw <= max_rss * sxx)) return;
    if (active_) emit();
    active_ = true;
    line_ = {buffer_.front().position, now.position, min_samples_, one, now.x + mx, now.w + mw, sxx, sxw};
    for (const Sample& s : buffer_) own(s);
    buffer_.clear();
  }
  void own(const Sample& s) {
    grown_.segment_of[static_cast<std::size_t>(s.position)] = static_cast<std::int32_t>(grown_.lines.size());
  }
  void emit() {
    grown_.lines.push_back(line_);
    active_ = false;
  }

  float k2_;
  int min_samples_;
  int reach_;
  bool active_ = false;
  GrownLine line_;
  std::vector<Sample> buffer_;
  Grown grown_;
};

// ---- images ----

InverseDepthImage emptyImage(int width, int height) {
  InverseDepthImage image;
  image.width = width;
  image.height = height;
  image.w.assign(static_cast<std::size_t>(width) * height, 0.0f);
  image.weight.assign(image.w.size(), 1.0f);
  for (int i = 0; i < width; ++i) image.across.push_back(0.004 * (i - 0.4 * width));
  for (int i = 0; i < height; ++i) image.along.push_back(0.005 * (i - 0.3 * height));
  image.forward.assign(static_cast<std::size_t>(width), 1.0);
  return image;
}

/// Planes that meet in steps and creases, with noise, outliers and holes of all lengths, along rows or along columns.
InverseDepthImage randomImage(int width, int height, unsigned seed) {
  InverseDepthImage image = emptyImage(width, height);
  std::mt19937 generator(seed);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(generator); };
  const double sigma = uniform(1e-4, 3e-3), outliers = uniform(0.0, 0.3), holes = uniform(0.0, 0.05);
  int hole = 0, face = 0;
  double w0 = 0.0, wu = 0.0, wv = 0.0;
  const bool along_columns = seed % 2 == 1;
  for (int line = 0; line < (along_columns ? width : height); ++line)
    for (int i = 0; i < (along_columns ? height : width); ++i) {
      const int row = along_columns ? i : line, column = along_columns ? line : i;
      const std::size_t pixel = image.index(row, column);
      if (face-- <= 0) {
        face = static_cast<int>(uniform(1.0, 200.0));
        w0 = uniform(0.2, 0.9);
        wu = uniform(-0.3, 0.3);
        wv = uniform(-0.3, 0.3);
      }
      if (hole-- <= 0) hole = uniform(0.0, 1.0) < holes ? static_cast<int>(uniform(1.0, 15.0)) : 0;
      double w = w0 + wu * image.across[static_cast<std::size_t>(column)] +
                 wv * image.along[static_cast<std::size_t>(row)] + uniform(-1.5, 1.5) * sigma;
      if (uniform(0.0, 1.0) < outliers) w += uniform(-0.1, 0.1);
      image.w[pixel] = hole > 0 || w <= 0.0 ? 0.0f : static_cast<float>(w);
      image.weight[pixel] = static_cast<float>(uniform(0.5, 2.0) / (sigma * sigma));
    }
  return image;
}

epcc::LineStrips stripsOf(const InverseDepthImage& image, bool columns, const InverseDepthParameters& parameters) {
  epcc::LineStrips strips(columns);
  epcc::StripMemory memory;
  memory.growing.configure(parameters);
  strips.begin(image, parameters);
  for (int strip = strips.strips() - 1; strip >= 0; --strip) strips.grow(image, strip, memory);
  return strips;
}

void expectEqual(const InverseDepthImage& image, const InverseDepthParameters& parameters) {
  PlainLineGrowing plain(parameters);
  for (const bool columns : {true, false}) {
    const epcc::LineStrips strips = stripsOf(image, columns, parameters);
    ASSERT_EQ(strips.scanLines(), columns ? image.width : image.height);
    for (int line = 0; line < strips.scanLines(); ++line) {
      std::vector<Sample> samples;
      std::vector<std::int32_t> segment_of;
      const std::vector<double>& x = columns ? image.along : image.across;
      for (int i = 0; i < static_cast<int>(x.size()); ++i) {
        const std::size_t pixel = columns ? image.index(i, line) : image.index(line, i);
        samples.push_back({i, static_cast<float>(x[static_cast<std::size_t>(i)]), image.w[pixel], image.weight[pixel]});
        segment_of.push_back(strips.segmentOf()[pixel]);
      }
      const Grown expected = plain.grow(samples);
      ASSERT_EQ(segment_of, expected.segment_of) << "line " << line << " of " << (columns ? "columns" : "rows");
      ASSERT_EQ(strips.lineCount(line), static_cast<int>(expected.lines.size()));
      static_assert(sizeof(GrownLine) == 32, "no padding");
      if (expected.lines.empty()) continue;
      ASSERT_EQ(std::memcmp(strips.lines(line), expected.lines.data(), sizeof(GrownLine) * expected.lines.size()), 0);
    }
  }
}

class LineGrowingOnEveryUnit : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_TRUE(epcc::setVectorUnit(GetParam())); }
  void TearDown() override { epcc::setVectorUnit(before_); }

 private:
  std::string before_ = epcc::vectorUnit();
};

TEST_P(LineGrowingOnEveryUnit, EqualsThePlainFormForAllSizes) {
  unsigned seed = 0;
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{
           {1, 1}, {1, 90}, {90, 1}, {5, 7}, {31, 33}, {32, 64}, {64, 32}, {67, 45}, {97, 130}, {160, 120}})
    for (int k = 0; k < 4; ++k) {
      SCOPED_TRACE(testing::Message() << width << "x" << height << " seed " << seed);
      expectEqual(randomImage(width, height, seed++), InverseDepthParameters());
    }
}

TEST_P(LineGrowingOnEveryUnit, EqualsThePlainFormForAllParameters) {
  for (const int min_samples : {3, 4, 6, 17, 100})
    for (const int max_gap : {0, 1, 5, 40, 1000})
      for (const double k_max : {0.3, 1.5, 20.0}) {
        InverseDepthParameters parameters;
        parameters.line_k_max = k_max;
        parameters.expert.lines.min_samples = min_samples;
        parameters.expert.lines.max_gap_pixels = max_gap;
        SCOPED_TRACE(testing::Message() << min_samples << " samples, gap " << max_gap << ", k " << k_max);
        for (int seed = 0; seed < epcc::test::repeats(2); ++seed)
          expectEqual(randomImage(130, 111, static_cast<unsigned>(seed)), parameters);
      }
}

INSTANTIATE_TEST_SUITE_P(Units, LineGrowingOnEveryUnit, ::testing::ValuesIn(epcc::vectorUnits()),
                         [](const auto& unit) { return unit.param; });

// ---- what becomes a line ----

Grown grow(const std::vector<float>& w, double sigma_w) {
  InverseDepthImage image = emptyImage(1, static_cast<int>(w.size()));
  image.w = w;
  image.weight.assign(w.size(), static_cast<float>(1.0 / (sigma_w * sigma_w)));
  const epcc::LineStrips strips = stripsOf(image, true, InverseDepthParameters());
  return {{strips.lines(0), strips.lines(0) + strips.lineCount(0)}, strips.segmentOf()};
}

std::vector<float> ramp(int count, double start, double slope) {
  std::vector<float> w;
  for (int i = 0; i < count; ++i) w.push_back(static_cast<float>(start + slope * i));
  return w;
}

TEST(LineGrowing, ARampIsOneLineThatOwnsEveryPixel) {
  const auto grown = grow(ramp(100, 0.5, 0.001), 1e-4);
  ASSERT_EQ(grown.lines.size(), 1u);
  EXPECT_EQ(grown.lines[0].first, 0);
  EXPECT_EQ(grown.lines[0].last, 99);
  EXPECT_EQ(grown.lines[0].n, 100);
  EXPECT_NEAR(grown.lines[0].sxw / grown.lines[0].sxx, 0.2, 1e-5);
  for (const auto id : grown.segment_of) EXPECT_EQ(id, 0);
}

TEST(LineGrowing, AStepAndACornerStartNewLines) {
  auto w = ramp(40, 0.5, 0.0);
  for (const float value : ramp(40, 0.55, 0.0)) w.push_back(value);
  for (const float value : ramp(40, 0.55, 0.002)) w.push_back(value);
  const auto grown = grow(w, 5e-4);
  ASSERT_EQ(grown.lines.size(), 3u);
  EXPECT_EQ(grown.lines[0].last, 39);
  EXPECT_EQ(grown.lines[1].first, 40);
  EXPECT_NEAR(grown.lines[2].first, 80, 3);
}

TEST(LineGrowing, UpToFiveMissingPixelsAreBridgedSixAreNot) {
  for (const int gap : {5, 6}) {
    auto w = ramp(100, 0.5, 0.0);
    for (int i = 50; i < 50 + gap; ++i) w[static_cast<std::size_t>(i)] = 0.0f;
    EXPECT_EQ(grow(w, 1e-4).lines.size(), gap == 5 ? 1u : 2u) << gap;
  }
}

TEST(LineGrowing, OutliersBelongToNoLine) {
  auto w = ramp(100, 0.5, 0.0);
  for (int i = 10; i < 100; i += 13) w[static_cast<std::size_t>(i)] = 0.9f;
  const auto grown = grow(w, 1e-4);
  ASSERT_EQ(grown.lines.size(), 1u);
  for (int i = 10; i < 100; i += 13) EXPECT_EQ(grown.segment_of[static_cast<std::size_t>(i)], -1);
}

TEST(LineGrowing, FiveSamplesAreNoLine) {
  EXPECT_TRUE(grow(ramp(5, 0.5, 0.0), 1e-4).lines.empty());
  EXPECT_EQ(grow(ramp(6, 0.5, 0.0), 1e-4).lines.size(), 1u);
  EXPECT_TRUE(grow({}, 1e-4).lines.empty());
}

}  // namespace
