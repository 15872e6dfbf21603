// SPDX-License-Identifier: BSD-3-Clause
// Membership row by row, then the pixels along the edges between samples of different labels.
#include "inverse_depth/full_resolution.h"

#include <algorithm>
#include <cmath>

#include "parallel_for.h"

namespace epcc {

namespace {

constexpr std::size_t kEnoughQuestions = 512;  // they fill vectors, and their pixels are still in the cache

void toSingle(const std::vector<double>& values, std::vector<float>& single) {
  single.resize(values.size());
  std::transform(values.begin(), values.end(), single.begin(), [](double value) { return static_cast<float>(value); });
}

/// Asks the pixels on both sides of the edges between samples of different labels.
class BorderEdges {
 public:
  BorderEdges(const InverseDepthImage& image, const RegionMap& map, const GridSteps& steps, int probe,
              const PixelPlane* planes, const RaysOfPixels& rays, BorderMemory& memory)
      : image_(image),
        samples_(map.labels.data()),
        rows_(sampleCount(image.height, steps.along)),
        columns_(sampleCount(image.width, steps.across)),
        steps_(steps),
        probe_(probe),
        planes_(planes),
        rays_(rays),
        memory_(memory) {}

  /// Finds the edges between neighbours of one row of samples, and the runs of blocks between them.
  BlockRuns findBeside(int row) {
    memory_.borders.assign(wordsOf(columns_), 0);
    markLeftBorders(samples_, columns_, rows_, row, memory_.borders);
    memory_.run_begins.assign(1, 0);
    memory_.run_labels.assign(1, sampleAt({row, 0}));
    for (const int column : listed()) {
      memory_.run_begins.push_back(column * steps_.across);
      memory_.run_labels.push_back(sampleAt({row, column}));
    }
    memory_.run_begins.push_back(image_.width);
    for (const std::int32_t label : memory_.run_labels) memory_.rows[static_cast<std::size_t>(label)].add(row);
    return {static_cast<int>(memory_.run_labels.size()), memory_.run_begins.data(), memory_.run_labels.data()};
  }

  /// Those that were found: of the blocks' pixels those of the half at the edge.
  void askBeside(int row) {
    for (const int column : memory_.places) {
      const Edge edge = edgeBetween({row, column - 1}, {row, column}, {0, 1});
      const int middle = column * steps_.across;
      ask(edge.first, row * steps_.along, rowEnd(row), middle - steps_.across / 2, middle);
      ask(edge.second, row * steps_.along, rowEnd(row), middle, middle + steps_.across / 2);
    }
  }

  /// Edges between a row of samples and the one above.
  void askAbove(int row) {
    memory_.borders.assign(wordsOf(columns_), 0);
    markUpperBorders(samples_, columns_, row, memory_.borders);
    for (const int column : listed()) {
      const Edge edge = edgeBetween({row - 1, column}, {row, column}, {1, 0});
      const int middle = row * steps_.along;
      ask(edge.first, middle - steps_.along / 2, middle, column * steps_.across, columnEnd(column));
      ask(edge.second, middle, middle + steps_.along / 2, column * steps_.across, columnEnd(column));
    }
  }

 private:
  struct Place {
    int row, column;
  };
  struct Edge {
    BorderQuestions::Question first, second;
  };

  const PixelList& listed() {
    memory_.places.clear(columns_);
    for (std::size_t word = 0; word < memory_.borders.size(); ++word) memory_.places.add(memory_.borders[word], word);
    return memory_.places;
  }

  int rowEnd(int row) const { return row + 1 < rows_ ? (row + 1) * steps_.along : image_.height; }
  int columnEnd(int column) const { return column + 1 < columns_ ? (column + 1) * steps_.across : image_.width; }

  std::int32_t sampleAt(const Place& place) const {
    if (place.row < 0 || place.row >= rows_ || place.column < 0 || place.column >= columns_) return 0;
    return samples_[static_cast<std::ptrdiff_t>(place.row) * columns_ + place.column];
  }

  float planeAt(std::int32_t label, const Place& sample) const {
    const PixelPlane& plane = planes_[label];
    const int row = std::min(sample.row * steps_.along + steps_.along / 2, image_.height - 1);
    const int column = std::min(sample.column * steps_.across + steps_.across / 2, image_.width - 1);
    return plane.across * rays_.across[column] + plane.along * rays_.along[row] + plane.forward * rays_.forward[column];
  }

  // Both planes are linear in the image, and so is their difference: it changes its sign along the crease. What lies a
  // few samples to both sides of the border says whether there is one.
  Edge edgeBetween(const Place& first, const Place& second, const Place& step) const {
    const std::int32_t a = sampleAt(first), b = sampleAt(second);
    Edge edge{{a, b, 0.0f}, {b, a, 0.0f}};
    const Place back{first.row - probe_ * step.row, first.column - probe_ * step.column};
    const Place forth{second.row + probe_ * step.row, second.column + probe_ * step.column};
    if (a == 0 || b == 0 || sampleAt(back) != a || sampleAt(forth) != b) return edge;
    const float here = planeAt(a, back) - planeAt(b, back);
    const float there = planeAt(a, forth) - planeAt(b, forth);
    if (here * there >= 0.0f) return edge;
    edge.first.side = here;
    edge.second.side = -there;
    return edge;
  }

  void ask(const BorderQuestions::Question& question, int row_begin, int row_end, int column_begin, int column_end) {
    if (question.other != 0) memory_.questions.add(question, row_begin, row_end, column_begin, column_end);
  }

  const InverseDepthImage& image_;
  const std::int32_t* samples_;
  int rows_, columns_;
  GridSteps steps_;
  int probe_;  // samples between the border and what lies to its sides
  const PixelPlane* planes_;
  const RaysOfPixels& rays_;
  BorderMemory& memory_;
};

}  // namespace

void FullResolution::takePlanes(const std::vector<PlaneMoments>& regions) {
  planes_.assign(regions.size() + 1, PixelPlane());
  for (std::size_t k = 0; k < regions.size(); ++k) {
    if (regions[k].n <= 0.0) continue;
    const RegionPlane plane(regions[k]);
    planes_[k + 1] = {static_cast<float>(plane.q.x()), static_cast<float>(plane.q.y()), static_cast<float>(plane.q.z()),
                      static_cast<float>(plane.slope_factor), static_cast<float>(1.0 / std::sqrt(plane.slope_factor))};
  }
}

void FullResolution::label(const InverseDepthImage& image, const InverseDepthNoise& noise, const RegionMap& map,
                           const GridSteps& steps, const InverseDepthParameters::Refinement& rule, int threads,
                           std::vector<std::int32_t>& labels) {
  labels.resize(image.w.size());
  toSingle(image.across, across_);
  toSingle(image.along, along_);
  toSingle(image.forward, forward_);
  takePlanes(map.regions);
  toSingle(image.measured_scale, scale_);
  const RaysOfPixels rays{across_.data(), along_.data(), forward_.data()};
  const BorderPixels pixels{image.w.data(),
                            rays,
                            scale_.data(),
                            image.width,
                            planes_.data(),
                            &noise,
                            static_cast<float>(rule.max_residual),
                            static_cast<float>(rule.flip_gain),
                            static_cast<float>(rule.crease_range),
                            static_cast<float>(rule.crease_slack)};
  const int sample_columns = sampleCount(image.width, steps.across);
  const int sample_rows = sampleCount(image.height, steps.along);
  const int side = static_cast<int>(std::lround(steps.side()));
  const int probe = std::max(1, (rule.crease_vote_pixels + side / 2) / side);
  border_memory_.resize(static_cast<std::size_t>(std::max(1, threads)));
  for (BorderMemory& memory : border_memory_) {  // none is to grow because a thread had nothing to do so far
    memory.pixels.assign(planes_.size(), 0);
    memory.rows.assign(planes_.size(), RowSpan());
    memory.borders.resize(wordsOf(sample_columns));
    memory.places.clear(sample_columns);
    memory.run_begins.reserve(static_cast<std::size_t>(sample_columns) + 1);
    memory.run_labels.reserve(static_cast<std::size_t>(sample_columns));
    const auto pixels_of_row = static_cast<std::size_t>(sample_columns) * static_cast<std::size_t>(steps.area());
    memory.questions.makeRoomFor(kEnoughQuestions + pixels_of_row);
    memory.questions.clear();  // of a frame that memory did not suffice for
  }
  begins_part_.assign(static_cast<std::size_t>(sample_rows), 0);
  // Each pixel faces one block beside it and one above or below it, and is asked once about each, in this order.
  const auto decide = [&](BorderMemory& memory, bool last) {
    if (last || memory.questions.count() >= kEnoughQuestions)
      decideBorderPixels(pixels, memory.questions, labels.data(), memory.pixels.data());
  };
  sharedFor(sample_rows, threads, [&](int thread, int begin, int end) {
    BorderMemory& memory = border_memory_[static_cast<std::size_t>(thread)];
    BorderEdges edges(image, map, steps, probe, planes_.data(), rays, memory);
    begins_part_[static_cast<std::size_t>(begin)] = 1;
    for (int sample_row = begin; sample_row < end; ++sample_row) {
      const int row_end = sample_row + 1 < sample_rows ? (sample_row + 1) * steps.along : image.height;
      const BlockRuns runs = edges.findBeside(sample_row);
      for (int row = sample_row * steps.along; row < row_end; ++row)
        labelMembers({image.w.data() + image.index(row, 0), rays.across, rays.forward, rays.along[row],
                      scale_[static_cast<std::size_t>(row)], image.planar_rows, image.width, runs, planes_.data(),
                      &noise, pixels.max_residual * pixels.max_residual},
                     labels.data() + image.index(row, 0), memory.pixels.data());
      edges.askBeside(sample_row);
      decide(memory, sample_row + 1 == end);
    }
    for (int sample_row = begin + 1; sample_row < end; ++sample_row) {
      edges.askAbove(sample_row);
      decide(memory, sample_row + 1 == end);
    }
  });
  BorderMemory& memory = border_memory_.front();
  BorderEdges edges(image, map, steps, probe, planes_.data(), rays, memory);
  for (int sample_row = 1; sample_row < sample_rows; ++sample_row) {
    if (begins_part_[static_cast<std::size_t>(sample_row)] == 0) continue;
    edges.askAbove(sample_row);
    decide(memory, false);
  }
  decide(memory, true);
  for (std::size_t thread = 1; thread < border_memory_.size(); ++thread)
    for (std::size_t k = 0; k < planes_.size(); ++k) memory.pixels[k] += border_memory_[thread].pixels[k];
  listRows(steps, image.height);
}

// A border moves by half a block at most.
void FullResolution::listRows(const GridSteps& steps, int height) {
  pixel_rows_.assign(planes_.size(), RowSpan());
  const int last_block = sampleCount(height, steps.along) - 1;
  for (std::size_t k = 0; k < pixel_rows_.size(); ++k) {
    RowSpan samples;
    for (const BorderMemory& memory : border_memory_) samples.add(memory.rows[k]);
    if (samples.begin >= samples.end) continue;
    const int end = samples.end > last_block ? height : samples.end * steps.along + steps.along / 2;
    pixel_rows_[k] = {std::max(0, samples.begin * steps.along - steps.along / 2), std::min(height, end)};
  }
}

}  // namespace epcc
