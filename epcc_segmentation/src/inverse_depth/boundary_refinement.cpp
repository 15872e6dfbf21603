// SPDX-License-Identifier: BSD-3-Clause
// S5: crease votes, then passes over the frontier.
#include "inverse_depth/boundary_refinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "inverse_depth/steady_borders.h"
#include "parallel_for.h"

namespace epcc {

namespace {

constexpr int kRefinedBands = 16;           // of rows, for the threads
constexpr std::size_t kPart = 256;          // pixels of a frontier: what is noted of them stays in the cache
constexpr std::size_t kWorthThreads = 100;  // changes before a pass: then it takes longer than to share it out

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
        moves_(map.moves),
        steady_(map.known > 0) {
    moves_.begin(map.regions.size());
    memory_.parts.resize(static_cast<std::size_t>(std::max(1, threads)));
    memory_.bands.resize(kRefinedBands);
    for (Part& part : memory_.parts) {
      part.borders.resize(image.width);
      part.upper_labelled.assign(words_, 0);
      part.creases.clear();
      part.list.clear(image.width);
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
    memory_.parts.front().creases.count(parameters_);
    std::size_t changes = kWorthThreads;
    for (int pass = 0; pass < parameters_.passes && changes > 0; ++pass) {
      use_creases_ = pass < parameters_.crease_passes;
      forBands(changes >= kWorthThreads ? threads_ : 1, [&](Band& band, int begin, int end, Part& part) {
        listFrontier(begin, end, part.list, band);
        refineFrontier(band, part);
      });
      changes = applyChanges();
    }
  }

 private:
  using Pixel = RefinementMemory::Pixel;
  using Choice = RefinementMemory::Choice;
  using Candidate = RefinementMemory::Candidate;
  using Band = RefinementMemory::Band;
  using Part = RefinementMemory::Part;

  const RefinedPlane& planeOf(std::int32_t label) const { return memory_.planes[static_cast<std::size_t>(label)]; }
  double planeAt(std::int32_t label, int row, int column) const {
    const RefinedPlane& plane = planeOf(label);
    return plane.x * image_.across[static_cast<std::size_t>(column)] +
           plane.y * image_.along[static_cast<std::size_t>(row)] +
           plane.z * image_.forward[static_cast<std::size_t>(column)];
  }

  /// Calls work(band, first row, end row, the thread's memory).
  template <typename Work>
  void forBands(int threads, const Work& work) {
    sharedFor(kRefinedBands, threads, [&](int thread, int first, int end) {
      for (int k = first; k < end; ++k)
        work(memory_.bands[static_cast<std::size_t>(k)], image_.height * k / kRefinedBands,
             image_.height * (k + 1) / kRefinedBands, memory_.parts[static_cast<std::size_t>(thread)]);
    });
  }

  // ---- borders ----
  // One sweep over the image: where two labels meet, the pixels that see another label join the frontier and the crease
  // is voted. Votes are counted: whose they are is of no importance.
  void sweepBorders() {
    memory_.next.resize(words_ * static_cast<std::size_t>(image_.height));
    memory_.has_next.assign(static_cast<std::size_t>(image_.height), 1);
    forBands(threads_, [this](Band&, int begin, int end, Part& part) { sweepBand(begin, end, part); });
    CreaseVotes& all = memory_.parts.front().creases;
    for (std::size_t thread = 1; thread < memory_.parts.size(); ++thread) all += memory_.parts[thread].creases;
    for (Part& part : memory_.parts) part.creases.makeRoomAs(all);  // in the next frame any thread may see them
  }

  void sweepBand(int begin, int end, Part& part) {
    if (begin > 0) markLabelled(labels_, image_.width, begin - 1, part.upper_labelled);
    for (int row = begin; row < end; ++row) {
      part.borders.mark(labels_, image_.width, image_.height, row);
      markFrontier(row, part);
      if (row > begin) markFrontierAbove(row, part);
      voteCreases(row, part);
      std::swap(part.borders.labelled, part.upper_labelled);
    }
    if (begin == end || end == image_.height) return;
    part.borders.mark(labels_, image_.width, image_.height, end);
    markFrontierAbove(end, part);
  }

  std::uint64_t* nextOf(int row) { return memory_.next.data() + words_ * static_cast<std::size_t>(row); }

  // Of a row by its neighbours to the left, to the right and above.
  void markFrontier(int row, const Part& part) {
    const auto& [left, above, labelled] = part.borders;
    std::uint64_t* here = nextOf(row);
    for (std::size_t word = 0; word < words_; ++word)
      here[word] = (left[word] & fromLeft(labelled, word)) | (fromRight(left, word) & fromRight(labelled, word)) |
                   (above[word] & part.upper_labelled[word]);
  }

  // Of the row above by this one.
  void markFrontierAbove(int row, const Part& part) {
    std::uint64_t* upper = nextOf(row - 1);
    for (std::size_t word = 0; word < words_; ++word)
      upper[word] |= part.borders.above[word] & part.borders.labelled[word];
  }

  void voteCreases(int row, Part& part) const {
    const auto& [left, above, labelled] = part.borders;
    part.list.clear(image_.width);
    for (std::size_t word = 0; word < words_; ++word)
      part.list.add(left[word] & labelled[word] & fromLeft(labelled, word), word);
    for (const int column : part.list) voteCrease(row, column - 1, row, column, part.creases);
    part.list.clear(image_.width);
    for (std::size_t word = 0; word < words_; ++word)
      part.list.add(above[word] & labelled[word] & part.upper_labelled[word], word);
    for (const int column : part.list) voteCrease(row - 1, column, row, column, part.creases);
  }

  /// Votes on both sides of the border between two pixels, the second one step down or to the right.
  void voteCrease(int row, int column, int other_row, int other_column, CreaseVotes& votes) const {
    const int down = parameters_.crease_vote_pixels * (other_row - row);
    const int right = parameters_.crease_vote_pixels * (other_column - column);
    const std::int32_t label = labels_[image_.index(row, column)];
    const std::int32_t other = labels_[image_.index(other_row, other_column)];
    vote(label, other, row - down, column - right, votes);
    vote(other, label, other_row + down, other_column + right, votes);
  }

  void vote(std::int32_t own, std::int32_t other, int row, int column, CreaseVotes& votes) const {
    if (row < 0 || row >= image_.height || column < 0 || column >= image_.width) return;
    if (labels_[image_.index(row, column)] != own) return;
    votes.add(own, other, planeAt(own, row, column) < planeAt(other, row, column));
  }

  // ---- frontier ----
  // All decisions of a pass are made from the labels before it: their order is of no importance. Which way a pixel
  // decides is hard to predict, so that each question is put to all of them before the next one.
  void refineFrontier(Band& band, Part& part) const {
    band.changes.resize(std::max(band.changes.size(), band.frontier_count));
    band.change_count = 0;
    for (std::size_t begin = 0; begin < band.frontier_count; begin += kPart) {
      const Pixel* pixels = band.frontier.data() + begin;
      listCandidates(pixels, std::min(kPart, band.frontier_count - begin), part);
      measureCandidates(pixels, part);
      askCreases(part);
      if (steady_) askNeighbours(image_, labels_, parameters_.flip_gain, pixels, part);
      band.change_count += choose(pixels, part, band.changes.data() + band.change_count);
    }
  }

  /// From bits to pixels with a depth, row by row.
  void listFrontier(int begin, int end, PixelList& list, Band& band) {
    std::size_t count = 0;
    for (int row = begin; row < end; ++row) {
      std::uint8_t& has_next = memory_.has_next[static_cast<std::size_t>(row)];
      if (has_next == 0) continue;
      has_next = 0;
      std::uint64_t* bits = nextOf(row);
      list.clear(image_.width);
      for (std::size_t word = 0; word < words_; ++word) {
        list.add(bits[word], word);
        bits[word] = 0;
      }
      band.frontier.resize(std::max(band.frontier.size(), count + static_cast<std::size_t>(image_.width) + 1));
      Pixel* frontier = band.frontier.data();
      const auto first = static_cast<std::int32_t>(image_.index(row, 0));
      const float* w = image_.w.data() + first;
      for (const int column : list) {
        frontier[count] = {first + column, row, column};
        count += w[column] > 0.0f ? 1 : 0;
      }
    }
    band.frontier_count = count;
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
    Candidate* const candidates = part.candidates.data();
    Choice* const choices = part.choices.data();
    std::size_t* const at_crease = part.at_crease.data();
    const std::size_t candidate_count = part.candidate_count;
    const double range = parameters_.crease_range;
    std::size_t count = 0;
    for (std::size_t k = 0; k < candidate_count; ++k) {
      Candidate& candidate = candidates[k];
      const Pixel pixel = pixels[candidate.choice];
      Choice& choice = choices[candidate.choice];
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
      const bool near = (choice.current != 0) & (candidate.error <= range) & (candidate.other_error <= range) &
                        (std::abs(candidate.difference) * inverse_sigma <= range);
      at_crease[count] = k;
      count += near ? 1 : 0;
    }
    part.at_crease_count = use_creases_ ? count : 0;
  }

  // On a crease the geometry decides which of two planes is the surface, unless that costs too much.
  void askCreases(Part& part) const {
    for (std::size_t i = 0; i < part.at_crease_count; ++i) {
      Candidate& candidate = part.candidates[part.at_crease[i]];
      const Choice& choice = part.choices[static_cast<std::size_t>(candidate.choice)];
      const Crease kind = memory_.parts.front().creases.kindOf(choice.current, candidate.label);
      const bool current_is_surface =
          kind == Crease::Convex ? candidate.difference <= 0.0 : candidate.difference >= 0.0;
      const bool cheap = candidate.other_error < candidate.error + parameters_.crease_slack;
      const Verdict verdict = (!current_is_surface & cheap) ? Verdict::Flip : Verdict::Keep;
      candidate.verdict = kind == Crease::Unknown ? Verdict::Residual : verdict;
    }
  }

  std::size_t choose(const Pixel* pixels, Part& part, RefinementMemory::Change* changes) const {
    static constexpr double kOffer[2] = {std::numeric_limits<double>::infinity(), 0.0};
    std::int32_t* changed = part.changed.data();
    const double flip_gain = parameters_.flip_gain;
    const Candidate* const candidates = part.candidates.data();
    Choice* const choices = part.choices.data();
    const std::size_t candidate_count = part.candidate_count;
    for (std::size_t k = 0; k < candidate_count; ++k) {
      const Candidate& candidate = candidates[k];
      Choice& choice = choices[candidate.choice];
      const double gain = choice.current != 0 ? flip_gain : 0.0;
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

  // The pixels that changed and those beside them are the next frontier. Returns how many changed.
  std::size_t applyChanges() {
    std::size_t count = 0;
    for (const Band& band : memory_.bands) {
      for (std::size_t k = 0; k < band.change_count; ++k) applyChange(band.changes[k]);
      count += band.change_count;
    }
    return count;
  }

  void applyChange(const RefinementMemory::Change& change) {
    const auto [index, row, column] = change.pixel;
    moves_.move(image_, row, column, labels_[index], change.label);
    labels_[index] = change.label;
    lookAgainAt(row, column);
    if (column > 0) lookAgainAt(row, column - 1);
    if (column + 1 < image_.width) lookAgainAt(row, column + 1);
    if (row > 0) lookAgainAt(row - 1, column);
    if (row + 1 < image_.height) lookAgainAt(row + 1, column);
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
  MomentMoves& moves_;
  bool use_creases_ = true;
  bool steady_ = false;  // the labels are those of earlier frames
};

}  // namespace

void refineBoundaries(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
                      RefinementMemory& memory, int threads) {
  Refiner(image, parameters, map, memory, threads).run();
  map.applyMoves(image);
}

}  // namespace epcc
