// SPDX-License-Identifier: BSD-3-Clause
// S5: crease votes, then passes over the frontier.
#include "inverse_depth/boundary_refinement.h"

#include <array>
#include <cmath>
#include <unordered_map>

#include "inverse_depth/region_merging.h"

namespace epcc {

namespace {

/// What the refinement knows of a region.
struct RefinedPlane {
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  double inverse_slope_factor = 1.0;
  bool usable = false;
};

enum class Crease { Unknown, Convex, Concave };

std::uint64_t pairKey(std::int32_t a, std::int32_t b) {
  const auto low = static_cast<std::uint32_t>(std::min(a, b));
  const auto high = static_cast<std::uint32_t>(std::max(a, b));
  return (static_cast<std::uint64_t>(high) << 32) | low;
}

class Refiner {
 public:
  Refiner(const InverseDepthImage& image, const RefinementParameters& parameters, RegionMap& map)
      : image_(image), parameters_(parameters), labels_(map.labels), planes_(map.regions.size() + 1) {
    for (std::size_t k = 0; k < map.regions.size(); ++k) {
      const PlaneMoments& region = map.regions[k];
      if (region.n <= 0.0) continue;
      RefinedPlane& plane = planes_[k + 1];
      plane.q = region.fit(weakRidge(region)).q;
      plane.inverse_slope_factor = 1.0 / slopeFactor(plane.q, region.meanW());
      plane.usable = true;
    }
  }

  void run() {
    voteCreases();
    collectFrontier();
    for (int pass = 0; pass < parameters_.passes && !frontier_.empty(); ++pass) {
      use_creases_ = pass < parameters_.crease_passes;
      refineFrontier();
    }
  }

 private:
  struct Change {
    std::size_t pixel;
    std::int32_t label;
  };

  int width() const { return image_.width; }
  int height() const { return image_.height; }

  double planeAt(std::int32_t label, int row, int column) const {
    const Eigen::Vector3d& q = planes_[static_cast<std::size_t>(label)].q;
    return q.x() * image_.across[static_cast<std::size_t>(column)] +
           q.y() * image_.along[static_cast<std::size_t>(row)] +
           q.z() * image_.forward[static_cast<std::size_t>(column)];
  }

  /// Squared residual of a pixel on a region's plane, in squared sigma across the surface.
  double squaredError(std::int32_t label, int row, int column, double w, double variance) const {
    const double r = w - planeAt(label, row, column);
    return r * r / variance * planes_[static_cast<std::size_t>(label)].inverse_slope_factor;
  }

  template <typename Visit>
  void forEachNeighbour(int row, int column, const Visit& visit) const {
    const std::size_t pixel = static_cast<std::size_t>(row) * width() + column;
    if (column > 0) visit(pixel - 1);
    if (column + 1 < width()) visit(pixel + 1);
    if (row > 0) visit(pixel - width());
    if (row + 1 < height()) visit(pixel + width());
  }

  // ---- creases ----
  // On a convex edge the surface is the farther of the two planes (the smaller w), in a concave corner the nearer.
  void voteCreases() {
    struct Votes {
      int convex = 0, concave = 0;
    };
    std::unordered_map<std::uint64_t, Votes> votes;
    const int reach = parameters_.crease_vote_pixels;
    const auto vote = [&](std::int32_t own, std::int32_t other, int row, int column) {
      if (row < 0 || row >= height() || column < 0 || column >= width()) return;
      if (labels_[static_cast<std::size_t>(row) * width() + column] != own) return;
      Votes& v = votes[pairKey(own, other)];
      (planeAt(own, row, column) < planeAt(other, row, column) ? v.convex : v.concave)++;
    };
    for (int row = 0; row < height(); ++row)
      for (int column = 0; column < width(); ++column) {
        const std::size_t pixel = static_cast<std::size_t>(row) * width() + column;
        const std::int32_t here = labels_[pixel];
        if (here == 0) continue;
        const std::int32_t right = column + 1 < width() ? labels_[pixel + 1] : 0;
        if (right != 0 && right != here) {
          vote(here, right, row, column - reach);
          vote(right, here, row, column + 1 + reach);
        }
        const std::int32_t below = row + 1 < height() ? labels_[pixel + width()] : 0;
        if (below != 0 && below != here) {
          vote(here, below, row - reach, column);
          vote(below, here, row + 1 + reach, column);
        }
      }
    for (const auto& [pair, v] : votes) {
      const int total = v.convex + v.concave;
      if (total < parameters_.crease_min_votes) continue;
      if (v.convex >= parameters_.crease_agreement * total) creases_[pair] = Crease::Convex;
      if (v.concave >= parameters_.crease_agreement * total) creases_[pair] = Crease::Concave;
    }
  }

  Crease crease(std::int32_t a, std::int32_t b) const {
    const auto found = creases_.find(pairKey(a, b));
    return found == creases_.end() ? Crease::Unknown : found->second;
  }

  // ---- frontier ----
  void collectFrontier() {
    queued_.assign(labels_.size(), 0);
    for (int row = 0; row < height(); ++row)
      for (int column = 0; column < width(); ++column) {
        const std::size_t pixel = static_cast<std::size_t>(row) * width() + column;
        if (!(image_.w[pixel] > 0.0f)) continue;
        bool border = false;
        forEachNeighbour(row, column,
                         [&](std::size_t n) { border |= labels_[n] != 0 && labels_[n] != labels_[pixel]; });
        if (border) frontier_.push_back(pixel);
      }
  }

  void refineFrontier() {
    changes_.clear();
    for (const std::size_t pixel : frontier_) {
      const std::int32_t label = bestLabel(pixel);
      if (label != labels_[pixel]) changes_.push_back({pixel, label});
    }
    for (const Change& change : changes_) labels_[change.pixel] = change.label;
    frontier_.clear();
    const auto enqueue = [this](std::size_t pixel) {
      if (queued_[pixel] != 0 || !(image_.w[pixel] > 0.0f)) return;
      queued_[pixel] = 1;
      frontier_.push_back(pixel);
    };
    for (const Change& change : changes_) {
      enqueue(change.pixel);
      forEachNeighbour(static_cast<int>(change.pixel / width()), static_cast<int>(change.pixel % width()), enqueue);
    }
    for (const std::size_t pixel : frontier_) queued_[pixel] = 0;
  }

  std::int32_t bestLabel(std::size_t pixel) const {
    const int row = static_cast<int>(pixel / width());
    const int column = static_cast<int>(pixel % width());
    const double w = static_cast<double>(image_.w[pixel]);
    const double variance = image_.variance(w, row);
    const std::int32_t current = labels_[pixel];
    double error = parameters_.max_residual;
    if (current != 0) error = std::sqrt(squaredError(current, row, column, w, variance));
    const double current_error = error;
    std::int32_t best = current;
    forEachNeighbour(row, column, [&](std::size_t n) {
      const std::int32_t other = labels_[n];
      if (other == 0 || other == current || other == best || !planes_[static_cast<std::size_t>(other)].usable) return;
      const double e = std::sqrt(squaredError(other, row, column, w, variance));
      if (current == 0) {
        if (e < error) error = e, best = other;
        return;
      }
      switch (creaseDecision(current, other, row, column, current_error, e, variance)) {
        case Decision::Keep:
          return;
        case Decision::Flip:
          error = std::min(error, e), best = other;
          return;
        case Decision::Residual:
          break;
      }
      if (e < current_error - parameters_.flip_gain && (best == current || e < error)) error = e, best = other;
    });
    return best;
  }

  enum class Decision { Keep, Flip, Residual };
  Decision creaseDecision(std::int32_t current, std::int32_t other, int row, int column, double current_error,
                          double other_error, double variance) const {
    if (!use_creases_) return Decision::Residual;
    const Crease kind = crease(current, other);
    if (kind == Crease::Unknown) return Decision::Residual;
    const double difference = planeAt(current, row, column) - planeAt(other, row, column);
    if (difference * difference > parameters_.crease_range * parameters_.crease_range * variance)
      return Decision::Residual;
    if (current_error > parameters_.crease_range || other_error > parameters_.crease_range) return Decision::Residual;
    const bool current_is_surface = kind == Crease::Convex ? difference <= 0.0 : difference >= 0.0;
    if (current_is_surface) return Decision::Keep;
    return other_error < current_error + parameters_.crease_slack ? Decision::Flip : Decision::Keep;
  }

  const InverseDepthImage& image_;
  const RefinementParameters& parameters_;
  std::vector<std::int32_t>& labels_;
  std::vector<RefinedPlane> planes_;
  std::unordered_map<std::uint64_t, Crease> creases_;
  std::vector<std::size_t> frontier_;
  std::vector<std::uint8_t> queued_;
  std::vector<Change> changes_;
  bool use_creases_ = true;
};

}  // namespace

void refineBoundaries(const InverseDepthImage& image, const RefinementParameters& parameters, RegionMap& map) {
  Refiner(image, parameters, map).run();
}

}  // namespace epcc
