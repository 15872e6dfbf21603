// SPDX-License-Identifier: BSD-3-Clause
// S5: crease votes, then passes over the frontier.
#include "inverse_depth/boundary_refinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "parallel_for.h"

namespace epcc {

namespace {

constexpr std::size_t kPart = 256;  // pixels of the frontier: what is noted of them stays in the cache
constexpr std::size_t kPartsWorthThreads = 4;

class Refiner {
 public:
  Refiner(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
          RefinementMemory& memory, int threads)
      : image_(image),
        parameters_(parameters.expert.refinement),
        threads_(threads),
        labels_(map.labels.data()),
        words_(wordsOf(image.width)),
        memory_(memory),
        frontier_(memory.frontier),
        moves_(map.moves) {
    moves_.begin(map.regions.size());
    memory_.parts.resize(static_cast<std::size_t>(std::max(1, threads)));
    for (Part& part : memory_.parts) {
      part.choices.resize(kPart);
      part.candidates.resize(4 * kPart + 1);
      part.at_crease.resize(4 * kPart + 1);
      part.changed.resize(kPart + 1);
    }
    memory_.planes.assign(map.regions.size() + 1, RefinedPlane());
    for (std::size_t k = 0; k < map.regions.size(); ++k) {
      if (map.regions[k].n <= 0.0) continue;
      const RegionPlane plane(map.regions[k]);
      memory_.planes[k + 1] = {plane.q.x(), plane.q.y(), plane.q.z(), 1.0 / std::sqrt(plane.slope_factor)};
    }
  }

  void run() {
    sweepBorders();
    memory_.creases.count(parameters_);
    for (int pass = 0; pass < parameters_.passes; ++pass) {
      listFrontier();
      if (memory_.frontier_count == 0) break;
      use_creases_ = pass < parameters_.crease_passes;
      refineFrontier();
    }
  }

 private:
  using Pixel = RefinementMemory::Pixel;
  using Choice = RefinementMemory::Choice;
  using Candidate = RefinementMemory::Candidate;
  using Part = RefinementMemory::Part;

  const RefinedPlane& planeOf(std::int32_t label) const { return memory_.planes[static_cast<std::size_t>(label)]; }
  double planeAt(std::int32_t label, int row, int column) const {
    const RefinedPlane& plane = planeOf(label);
    return plane.x * image_.across[static_cast<std::size_t>(column)] +
           plane.y * image_.along[static_cast<std::size_t>(row)] +
           plane.z * image_.forward[static_cast<std::size_t>(column)];
  }

  // ---- borders ----
  // One sweep over the image: where two labels meet, the pixels that see another label join the frontier and the crease
  // is voted.
  void sweepBorders() {
    memory_.creases.clear();
    memory_.borders.resize(image_.width);
    memory_.upper_labelled.assign(words_, 0);
    memory_.next.assign(words_ * static_cast<std::size_t>(image_.height), 0);
    memory_.has_next.assign(static_cast<std::size_t>(image_.height), 1);
    for (int row = 0; row < image_.height; ++row) {
      memory_.borders.mark(labels_, image_.width, image_.height, row);
      markFrontier(row);
      voteCreases(row);
      std::swap(memory_.borders.labelled, memory_.upper_labelled);
    }
  }

  // Of a row by its neighbours to the left, to the right and above, and of the row above by this one.
  void markFrontier(int row) {
    const auto& [left, above, labelled] = memory_.borders;
    std::uint64_t* here = memory_.next.data() + words_ * static_cast<std::size_t>(row);
    for (std::size_t word = 0; word < words_; ++word) {
      here[word] = (left[word] & fromLeft(labelled, word)) | (fromRight(left, word) & fromRight(labelled, word)) |
                   (above[word] & memory_.upper_labelled[word]);
      if (row > 0) (here - words_)[word] |= above[word] & labelled[word];
    }
  }

  void voteCreases(int row) {
    const auto& [left, above, labelled] = memory_.borders;
    memory_.list.clear(image_.width);
    for (std::size_t word = 0; word < left.size(); ++word)
      memory_.list.add(left[word] & labelled[word] & fromLeft(labelled, word), word);
    for (const int column : memory_.list) voteCrease(row, column - 1, row, column);
    memory_.list.clear(image_.width);
    for (std::size_t word = 0; word < left.size(); ++word)
      memory_.list.add(above[word] & labelled[word] & memory_.upper_labelled[word], word);
    for (const int column : memory_.list) voteCrease(row - 1, column, row, column);
  }

  /// Votes on both sides of the border between two pixels, the second one step down or to the right.
  void voteCrease(int row, int column, int other_row, int other_column) {
    const int down = parameters_.crease_vote_pixels * (other_row - row);
    const int right = parameters_.crease_vote_pixels * (other_column - column);
    const std::int32_t label = labels_[image_.index(row, column)];
    const std::int32_t other = labels_[image_.index(other_row, other_column)];
    vote(label, other, row - down, column - right);
    vote(other, label, other_row + down, other_column + right);
  }

  void vote(std::int32_t own, std::int32_t other, int row, int column) {
    if (row < 0 || row >= image_.height || column < 0 || column >= image_.width) return;
    if (labels_[image_.index(row, column)] != own) return;
    memory_.creases.add(own, other, planeAt(own, row, column) < planeAt(other, row, column));
  }

  // ---- frontier ----
  // All decisions of a pass are made from the labels before it: their order is of no importance. Which way a pixel
  // decides is hard to predict, so that each question is put to all of them before the next one.
  void refineFrontier() {
    const std::size_t parts = (memory_.frontier_count + kPart - 1) / kPart;
    memory_.changes.resize(std::max(memory_.changes.size(), memory_.frontier_count));
    memory_.change_counts.assign(parts, 0);
    const int threads = parts < kPartsWorthThreads ? 1 : threads_;
    sharedFor(static_cast<int>(parts), threads, [&](int thread, int begin, int end) {
      Part& memory = memory_.parts[static_cast<std::size_t>(thread)];
      for (auto part = static_cast<std::size_t>(begin); part < static_cast<std::size_t>(end); ++part)
        memory_.change_counts[part] = refinePart(kPart * part, memory);
    });
    for (std::size_t part = 0; part < parts; ++part)
      applyChanges(memory_.changes.data() + kPart * part, memory_.change_counts[part]);
  }

  /// Returns how many pixels change.
  std::size_t refinePart(std::size_t begin, Part& part) {
    const Pixel* pixels = frontier_.data() + begin;
    listCandidates(pixels, std::min(kPart, memory_.frontier_count - begin), part);
    measureCandidates(pixels, part);
    askCreases(part);
    return choose(pixels, part, memory_.changes.data() + begin);
  }

  /// From bits to pixels with a depth, row by row.
  void listFrontier() {
    std::size_t count = 0;
    for (int row = 0; row < image_.height; ++row) {
      if (memory_.has_next[static_cast<std::size_t>(row)] == 0) continue;
      memory_.has_next[static_cast<std::size_t>(row)] = 0;
      std::uint64_t* bits = memory_.next.data() + words_ * static_cast<std::size_t>(row);
      memory_.list.clear(image_.width);
      for (std::size_t word = 0; word < words_; ++word) {
        memory_.list.add(bits[word], word);
        bits[word] = 0;
      }
      frontier_.resize(std::max(frontier_.size(), count + static_cast<std::size_t>(image_.width) + 1));
      const auto first = static_cast<std::int32_t>(image_.index(row, 0));
      const float* w = image_.w.data() + first;
      for (const int column : memory_.list) {
        frontier_[count] = {first + column, row, column};
        count += w[column] > 0.0f ? 1 : 0;
      }
    }
    memory_.frontier_count = count;
  }

  // The labels of the four neighbours, but none twice running. Each is written down and the count decides whether it
  // stays. Beyond the image is the pixel itself.
  void listCandidates(const Pixel* pixels, std::size_t pixel_count, Part& part) const {
    const std::ptrdiff_t line = image_.width;
    const auto last_column = static_cast<unsigned>(image_.width - 2),
               last_row = static_cast<unsigned>(image_.height - 2);
    Choice* choice = part.choices.data();
    Candidate* candidate = part.candidates.data();
    for (std::size_t k = 0; k < pixel_count; ++k) {
      const Pixel pixel = pixels[k];
      const std::int32_t* label = labels_ + pixel.index;
      const std::int32_t current = *label;
      choice[k] = {current, current, 0.0};
      std::ptrdiff_t left = -1, right = 1, up = -line, down = line;
      const bool inside =
          static_cast<unsigned>(pixel.column - 1) < last_column && static_cast<unsigned>(pixel.row - 1) < last_row;
      if (!inside) {
        if (pixel.column == 0) left = 0;
        if (pixel.column + 1 == image_.width) right = 0;
        if (pixel.row == 0) up = 0;
        if (pixel.row + 1 == image_.height) down = 0;
      }
      std::int32_t last = 0;
      const auto offer = [&](std::int32_t other) {
        candidate->choice = static_cast<std::int32_t>(k);
        candidate->label = other;
        const int counts = (other != 0) & (other != current) & (other != last);
        last ^= (last ^ other) & -counts;  // no branch
        candidate += counts;
      };
      offer(label[left]);
      offer(label[right]);
      offer(label[up]);
      offer(label[down]);
    }
    part.candidate_count = static_cast<std::size_t>(candidate - part.candidates.data());
  }

  void measureCandidates(const Pixel* pixels, Part& part) const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < part.candidate_count; ++k) {
      Candidate& candidate = part.candidates[k];
      const Pixel pixel = pixels[candidate.choice];
      Choice& choice = part.choices[static_cast<std::size_t>(candidate.choice)];
      const auto index = static_cast<std::size_t>(pixel.index);
      const auto w = static_cast<double>(image_.w[index]);
      const double inverse_sigma = std::sqrt(static_cast<double>(image_.weight[index]));
      const double on_current = planeAt(choice.current, pixel.row, pixel.column);
      const double on_other = planeAt(candidate.label, pixel.row, pixel.column);
      const double error = std::abs(w - on_current) * inverse_sigma * planeOf(choice.current).inverse_slope;
      candidate.error = choice.current != 0 ? error : parameters_.max_residual;
      candidate.other_error = std::abs(w - on_other) * inverse_sigma * planeOf(candidate.label).inverse_slope;
      candidate.difference = on_current - on_other;
      candidate.verdict = Verdict::Residual;
      choice.least = candidate.error;
      const double range = parameters_.crease_range;
      const bool near = (choice.current != 0) & (candidate.error <= range) & (candidate.other_error <= range) &
                        (std::abs(candidate.difference) * inverse_sigma <= range);
      part.at_crease[count] = k;
      count += near ? 1 : 0;
    }
    part.at_crease_count = use_creases_ ? count : 0;
  }

  // On a crease the geometry decides which of two planes is the surface, unless that costs too much.
  void askCreases(Part& part) const {
    for (std::size_t i = 0; i < part.at_crease_count; ++i) {
      Candidate& candidate = part.candidates[part.at_crease[i]];
      const Choice& choice = part.choices[static_cast<std::size_t>(candidate.choice)];
      const Crease kind = memory_.creases.kindOf(choice.current, candidate.label);
      const bool current_is_surface =
          kind == Crease::Convex ? candidate.difference <= 0.0 : candidate.difference >= 0.0;
      const bool cheap = candidate.other_error < candidate.error + parameters_.crease_slack;
      const Verdict verdict = !current_is_surface & cheap ? Verdict::Flip : Verdict::Keep;
      candidate.verdict = kind == Crease::Unknown ? Verdict::Residual : verdict;
    }
  }

  std::size_t choose(const Pixel* pixels, Part& part, RefinementMemory::Change* changes) const {
    static constexpr double kOffer[2] = {std::numeric_limits<double>::infinity(), 0.0};
    std::int32_t* changed = part.changed.data();
    for (std::size_t k = 0; k < part.candidate_count; ++k) {
      const Candidate& candidate = part.candidates[k];
      Choice& choice = part.choices[static_cast<std::size_t>(candidate.choice)];
      const double gain = choice.current != 0 ? parameters_.flip_gain : 0.0;
      const bool better = (candidate.other_error < candidate.error - gain) & (candidate.other_error < choice.least);
      const bool flips = (candidate.verdict == Verdict::Flip) | ((candidate.verdict == Verdict::Residual) & better);
      *changed = candidate.choice;
      changed += static_cast<int>(flips) & static_cast<int>(choice.best == choice.current);
      choice.best ^= (choice.best ^ candidate.label) & -static_cast<std::int32_t>(flips);
      choice.least = std::min(choice.least, candidate.other_error + kOffer[flips]);
    }
    const std::int32_t* const first = part.changed.data();
    for (const std::int32_t* k = first; k != changed; ++k)
      changes[k - first] = {pixels[*k], part.choices[static_cast<std::size_t>(*k)].best};
    return static_cast<std::size_t>(changed - first);
  }

  // The pixels that changed and those beside them are the next frontier.
  void applyChanges(const RefinementMemory::Change* changes, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const auto [index, row, column] = changes[k].pixel;
      moves_.move(image_, row, column, labels_[index], changes[k].label);
      labels_[index] = changes[k].label;
      lookAgainAt(row, column);
      if (column > 0) lookAgainAt(row, column - 1);
      if (column + 1 < image_.width) lookAgainAt(row, column + 1);
      if (row > 0) lookAgainAt(row - 1, column);
      if (row + 1 < image_.height) lookAgainAt(row + 1, column);
    }
  }

  void lookAgainAt(int row, int column) {
    const auto bit = static_cast<std::size_t>(column);
    memory_.has_next[static_cast<std::size_t>(row)] = 1;
    memory_.next[words_ * static_cast<std::size_t>(row) + bit / 64] |= std::uint64_t{1} << bit % 64;
  }

  const InverseDepthImage& image_;
  const InverseDepthParameters::Refinement& parameters_;
  int threads_;
  std::int32_t* labels_;
  std::size_t words_;  // of a row's bits
  RefinementMemory& memory_;
  std::vector<Pixel>& frontier_;
  MomentMoves& moves_;
  bool use_creases_ = true;
};

}  // namespace

void refineBoundaries(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
                      RefinementMemory& memory, int threads) {
  Refiner(image, parameters, map, memory, threads).run();
  map.applyMoves(image);
}

}  // namespace epcc
