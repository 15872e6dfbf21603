// SPDX-License-Identifier: BSD-3-Clause
// S5: crease votes, then passes over the frontier.
#include "inverse_depth/boundary_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace epcc {

namespace {

class Refiner {
 public:
  Refiner(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
          RefinementMemory& memory)
      : image_(image),
        parameters_(parameters.expert.refinement),
        labels_(map.labels.data()),
        memory_(memory),
        frontier_(memory.frontier),
        changes_(memory.changes) {
    memory_.planes.assign(map.regions.size() + 1, RefinedPlane());
    for (std::size_t k = 0; k < map.regions.size(); ++k) {
      if (map.regions[k].n <= 0.0) continue;
      const RegionPlane plane(map.regions[k]);
      memory_.planes[k + 1] = {plane.q.x(), plane.q.y(), plane.q.z(), 1.0 / std::sqrt(plane.slope_factor)};
    }
    if (memory_.queued.size() != map.labels.size()) memory_.queued.assign(map.labels.size(), 0);
  }

  void run() {
    sweepBorders();
    memory_.creases.count(parameters_);
    for (int pass = 0; pass < parameters_.passes && !frontier_.empty(); ++pass) {
      use_creases_ = pass < parameters_.crease_passes;
      refineFrontier();
    }
  }

 private:
  using Pixel = RefinementMemory::Pixel;

  const RefinedPlane& planeOf(std::int32_t label) const { return memory_.planes[static_cast<std::size_t>(label)]; }
  double planeAt(std::int32_t label, Pixel pixel) const {
    const RefinedPlane& plane = planeOf(label);
    return plane.x * image_.across[static_cast<std::size_t>(pixel.column)] +
           plane.y * image_.along[static_cast<std::size_t>(pixel.row)] +
           plane.z * image_.forward[static_cast<std::size_t>(pixel.column)];
  }

  // ---- borders ----
  // One sweep over the image: where two labels meet, the pixels that see another label join the frontier and the crease
  // is voted.
  void sweepBorders() {
    frontier_.clear();
    memory_.creases.clear();
    for (RowBorders* borders : {&memory_.borders, &memory_.upper}) borders->resize(image_.width);
    const std::size_t words = memory_.borders.left.size();
    for (RowBits* bits : {&memory_.frontier_bits, &memory_.upper_frontier}) bits->assign(words, 0);
    for (int row = 0; row < image_.height; ++row) {
      std::swap(memory_.borders, memory_.upper);
      std::swap(memory_.frontier_bits, memory_.upper_frontier);
      memory_.borders.mark(labels_, image_.width, image_.height, row);
      markFrontier();
      voteCreases(row);
      if (row > 0) listFrontier(row - 1, memory_.upper_frontier);
    }
    if (image_.height > 0) listFrontier(image_.height - 1, memory_.frontier_bits);
  }

  // Of a row by its neighbours to the left, to the right and above, and of the row above by this one.
  void markFrontier() {
    const auto& [left, above, labelled] = memory_.borders;
    for (std::size_t word = 0; word < left.size(); ++word) {
      memory_.frontier_bits[word] = (left[word] & fromLeft(labelled, word)) |
                                    (fromRight(left, word) & fromRight(labelled, word)) |
                                    (above[word] & memory_.upper.labelled[word]);
      memory_.upper_frontier[word] |= above[word] & labelled[word];
    }
  }

  void voteCreases(int row) {
    const auto& [left, above, labelled] = memory_.borders;
    memory_.list.clear(image_.width);
    for (std::size_t word = 0; word < left.size(); ++word)
      memory_.list.add(left[word] & labelled[word] & fromLeft(labelled, word), word);
    for (const int column : memory_.list) voteCrease({row, column - 1}, {row, column});
    memory_.list.clear(image_.width);
    for (std::size_t word = 0; word < left.size(); ++word)
      memory_.list.add(above[word] & labelled[word] & memory_.upper.labelled[word], word);
    for (const int column : memory_.list) voteCrease({row - 1, column}, {row, column});
  }

  void listFrontier(int row, const RowBits& bits) {
    const float* w = image_.w.data() + image_.index(row, 0);
    memory_.list.clear(image_.width);
    for (std::size_t word = 0; word < bits.size(); ++word) memory_.list.add(bits[word], word);
    for (const int column : memory_.list)
      if (w[column] > 0.0f) frontier_.push_back({row, column});
  }

  /// Votes on both sides of the border between a and b, b one step down or to the right.
  void voteCrease(Pixel a, Pixel b) {
    const int down = parameters_.crease_vote_pixels * (b.row - a.row);
    const int right = parameters_.crease_vote_pixels * (b.column - a.column);
    const std::int32_t label_a = labels_[image_.index(a.row, a.column)];
    const std::int32_t label_b = labels_[image_.index(b.row, b.column)];
    vote(label_a, label_b, {a.row - down, a.column - right});
    vote(label_b, label_a, {b.row + down, b.column + right});
  }

  void vote(std::int32_t own, std::int32_t other, Pixel pixel) {
    if (pixel.row < 0 || pixel.row >= image_.height || pixel.column < 0 || pixel.column >= image_.width) return;
    if (labels_[image_.index(pixel.row, pixel.column)] != own) return;
    memory_.creases.add(own, other, planeAt(own, pixel) < planeAt(other, pixel));
  }

  // ---- frontier ----
  // All decisions of a pass are made from the labels before it: their order is of no importance.
  void refineFrontier() {
    changes_.clear();
    for (const Pixel pixel : frontier_) {
      const std::int32_t label = bestLabel(pixel);
      if (label != labels_[image_.index(pixel.row, pixel.column)]) changes_.push_back({pixel, label});
    }
    frontier_.clear();
    for (const RefinementMemory::Change& change : changes_) {
      const auto [row, column] = change.pixel;
      labels_[image_.index(row, column)] = change.label;
      enqueue({row, column});
      if (column > 0) enqueue({row, column - 1});
      if (column + 1 < image_.width) enqueue({row, column + 1});
      if (row > 0) enqueue({row - 1, column});
      if (row + 1 < image_.height) enqueue({row + 1, column});
    }
    for (const Pixel pixel : frontier_) memory_.queued[image_.index(pixel.row, pixel.column)] = 0;
  }

  void enqueue(Pixel pixel) {
    const std::size_t index = image_.index(pixel.row, pixel.column);
    if (memory_.queued[index] != 0 || !(image_.w[index] > 0.0f)) return;
    memory_.queued[index] = 1;
    frontier_.push_back(pixel);
  }

  /// A pixel as its candidates see it.
  struct View {
    double w, inverse_sigma, across, along, forward;

    double planeAt(const RefinedPlane& plane) const { return plane.x * across + plane.y * along + plane.z * forward; }
    /// Residual on a plane, in sigma across the surface.
    double error(const RefinedPlane& plane) const {
      return std::abs(w - planeAt(plane)) * inverse_sigma * plane.inverse_slope;
    }
  };

  std::int32_t bestLabel(Pixel pixel) const {
    const std::size_t index = image_.index(pixel.row, pixel.column);
    const std::int32_t* label = labels_ + index;
    const std::int32_t current = *label;
    // Neighbours are seldom predictable: each is written down and the count decides whether it stays. Beyond the image
    // is the pixel itself.
    const std::int32_t neighbours[4] = {label[pixel.column > 0 ? -1 : 0], label[pixel.column + 1 < image_.width ? 1 : 0],
                                        label[pixel.row > 0 ? -image_.width : 0],
                                        label[pixel.row + 1 < image_.height ? image_.width : 0]};
    std::array<std::int32_t, 6> others = {};  // [0] is none
    std::size_t count = 0;
    for (const std::int32_t other : neighbours) {
      const bool counts = (other != 0) & (other != current) & (other != others[count]);
      others[count + 1] = other;
      count += counts ? 1 : 0;
    }
    if (count == 0) return current;

    const View view = {static_cast<double>(image_.w[index]), std::sqrt(static_cast<double>(image_.weight[index])),
                       image_.across[static_cast<std::size_t>(pixel.column)],
                       image_.along[static_cast<std::size_t>(pixel.row)],
                       image_.forward[static_cast<std::size_t>(pixel.column)]};
    return current == 0 ? nearestPlane(view, others.data() + 1, count) : betterPlane(current, view, others.data() + 1, count);
  }

  /// An unlabelled pixel joins the plane with the smallest residual.
  std::int32_t nearestPlane(const View& view, const std::int32_t* others, std::size_t count) const {
    std::int32_t best = 0;
    double least = parameters_.max_residual;
    for (std::size_t k = 0; k < count; ++k) {
      if (others[k] == best) continue;
      const double error = view.error(planeOf(others[k]));
      if (error < least) least = error, best = others[k];
    }
    return best;
  }

  /// A labelled one changes sides if the crease says so or, where it does not know, for a gain in its residual.
  std::int32_t betterPlane(std::int32_t current, const View& view, const std::int32_t* others,
                           std::size_t count) const {
    const RefinedPlane& plane = planeOf(current);
    const double error = view.error(plane);
    double least = error;
    std::int32_t best = current;
    for (std::size_t k = 0; k < count; ++k) {
      const std::int32_t other = others[k];
      if (other == best) continue;
      const double other_error = view.error(planeOf(other));
      switch (creaseDecision(current, other, view, error, other_error)) {
        case Decision::Keep:
          continue;
        case Decision::Flip:
          least = std::min(least, other_error), best = other;
          continue;
        case Decision::Residual:
          break;
      }
      if (other_error < error - parameters_.flip_gain && (best == current || other_error < least))
        least = other_error, best = other;
    }
    return best;
  }

  enum class Decision { Keep, Flip, Residual };
  Decision creaseDecision(std::int32_t current, std::int32_t other, const View& view, double current_error,
                          double other_error) const {
    if (!use_creases_) return Decision::Residual;
    if (current_error > parameters_.crease_range || other_error > parameters_.crease_range) return Decision::Residual;
    const double difference = view.planeAt(planeOf(current)) - view.planeAt(planeOf(other));
    if (std::abs(difference) * view.inverse_sigma > parameters_.crease_range) return Decision::Residual;
    const Crease kind = memory_.creases.kindOf(current, other);
    if (kind == Crease::Unknown) return Decision::Residual;
    const bool current_is_surface = kind == Crease::Convex ? difference <= 0.0 : difference >= 0.0;
    if (current_is_surface) return Decision::Keep;
    return other_error < current_error + parameters_.crease_slack ? Decision::Flip : Decision::Keep;
  }

  const InverseDepthImage& image_;
  const InverseDepthParameters::Refinement& parameters_;
  std::int32_t* labels_;
  RefinementMemory& memory_;
  std::vector<Pixel>& frontier_;
  std::vector<RefinementMemory::Change>& changes_;
  bool use_creases_ = true;
};

}  // namespace

void refineBoundaries(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
                      RefinementMemory& memory) {
  Refiner(image, parameters, map, memory).run();
}

}  // namespace epcc
