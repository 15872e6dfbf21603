// SPDX-License-Identifier: BSD-3-Clause
// S5: crease votes, then passes over the frontier.
#include "inverse_depth/boundary_refinement.h"

#include <array>
#include <cmath>

#include "inverse_depth/region_contacts.h"

namespace epcc {

namespace {

/// What the refinement knows of a region.
struct RefinedPlane {
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  double inverse_slope = 1.0;  ///< 1 / sqrt(slope factor)
  bool usable = false;
};

enum class Crease { Unknown, Convex, Concave };

class Refiner {
 public:
  Refiner(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
          RefinementMemory& memory)
      : image_(image),
        parameters_(parameters.expert.refinement),
        labels_(map.labels),
        planes_(map.regions.size() + 1),
        frontier_(memory.frontier),
        queued_(memory.queued),
        changes_(memory.changes) {
    for (std::size_t k = 0; k < map.regions.size(); ++k) {
      if (map.regions[k].n <= 0.0) continue;
      const RegionPlane plane(map.regions[k]);
      planes_[k + 1] = {plane.q, 1.0 / std::sqrt(plane.slope_factor), true};
    }
  }

  void run() {
    sweepBorders();
    countVotes();
    for (int pass = 0; pass < parameters_.passes && !frontier_.empty(); ++pass) {
      use_creases_ = pass < parameters_.crease_passes;
      refineFrontier();
    }
  }

 private:
  using Change = RefinementMemory::Change;
  struct Pixel {
    int row, column;
    double w, weight, inverse_sigma;
  };

  int width() const { return image_.width; }
  int height() const { return image_.height; }

  double planeAt(std::int32_t label, int row, int column) const {
    const Eigen::Vector3d& q = planes_[static_cast<std::size_t>(label)].q;
    return q.x() * image_.across[static_cast<std::size_t>(column)] +
           q.y() * image_.along[static_cast<std::size_t>(row)] +
           q.z() * image_.forward[static_cast<std::size_t>(column)];
  }

  /// Residual of a pixel on a region's plane, in sigma across the surface.
  double error(std::int32_t label, const Pixel& pixel) const {
    return std::abs(pixel.w - planeAt(label, pixel.row, pixel.column)) * pixel.inverse_sigma *
           planes_[static_cast<std::size_t>(label)].inverse_slope;
  }

  template <typename Visit>
  void forEachNeighbour(int row, int column, const Visit& visit) const {
    const std::size_t pixel = image_.index(row, column);
    if (column > 0) visit(pixel - 1);
    if (column + 1 < width()) visit(pixel + 1);
    if (row > 0) visit(pixel - width());
    if (row + 1 < height()) visit(pixel + width());
  }

  // ---- borders ----
  // One sweep over the image: where two labels meet, the pixels join the frontier and the crease is voted.
  void sweepBorders() {
    frontier_.clear();
    queued_.assign(labels_.size(), 0);
    const auto step = static_cast<std::size_t>(width());
    for (int row = 0; row < height(); ++row) {
      const std::size_t start = image_.index(row, 0);
      const std::int32_t* here = labels_.data() + start;
      const std::int32_t* below = row + 1 < height() ? here + step : here;  // no border under the last row
      for (std::size_t column = 0; column < step; ++column) {
        const std::size_t pixel = start + column;
        if (column + 1 < step && here[column] != here[column + 1]) {
          meet(pixel, pixel + 1);
          voteCrease(pixel, pixel + 1, row, static_cast<int>(column), 0, 1);
        }
        if (here[column] != below[column]) {
          meet(pixel, pixel + step);
          voteCrease(pixel, pixel + step, row, static_cast<int>(column), 1, 0);
        }
      }
    }
    for (const std::size_t pixel : frontier_) queued_[pixel] = 0;
  }

  void meet(std::size_t a, std::size_t b) {
    if (labels_[b] != 0) enqueue(a);
    if (labels_[a] != 0) enqueue(b);
  }

  void enqueue(std::size_t pixel) {
    if (queued_[pixel] != 0 || !(image_.w[pixel] > 0.0f)) return;
    queued_[pixel] = 1;
    frontier_.push_back(pixel);
  }

  // ---- creases ----
  // On a convex edge the surface is the farther of the two planes (the smaller w), in a concave corner the nearer.
  struct Votes {
    int convex = 0, concave = 0;
  };

  /// Votes on both sides of the border between pixels a and b, b one step down or to the right of (row, column).
  void voteCrease(std::size_t a, std::size_t b, int row, int column, int down, int right) {
    const std::int32_t label_a = labels_[a];
    const std::int32_t label_b = labels_[b];
    if (label_a == 0 || label_b == 0) return;
    const int back = parameters_.crease_vote_pixels;
    const int forth = back + 1;
    vote(label_a, label_b, row - back * down, column - back * right);
    vote(label_b, label_a, row + forth * down, column + forth * right);
  }

  void vote(std::int32_t own, std::int32_t other, int row, int column) {
    if (row < 0 || row >= height() || column < 0 || column >= width()) return;
    if (labels_[image_.index(row, column)] != own) return;
    Votes& v = votes_of_[RegionPair(own, other)];
    (planeAt(own, row, column) < planeAt(other, row, column) ? v.convex : v.concave)++;
  }

  void countVotes() {
    for (const auto& [pair, v] : votes_) {
      const int total = v.convex + v.concave;
      if (total < parameters_.crease_min_votes) continue;
      if (v.convex >= parameters_.crease_agreement * total) creases_[pair] = Crease::Convex;
      if (v.concave >= parameters_.crease_agreement * total) creases_[pair] = Crease::Concave;
    }
  }

  // ---- frontier ----
  void refineFrontier() {
    changes_.clear();
    for (const std::size_t pixel : frontier_) {
      const std::int32_t label = bestLabel(pixel);
      if (label != labels_[pixel]) changes_.push_back({pixel, label});
    }
    for (const Change& change : changes_) labels_[change.pixel] = change.label;
    frontier_.clear();
    for (const Change& change : changes_) {
      enqueue(change.pixel);
      forEachNeighbour(static_cast<int>(change.pixel / width()), static_cast<int>(change.pixel % width()),
                       [this](std::size_t pixel) { enqueue(pixel); });
    }
    for (const std::size_t pixel : frontier_) queued_[pixel] = 0;
  }

  std::int32_t bestLabel(std::size_t index) {
    const std::int32_t current = labels_[index];
    Pixel pixel;
    pixel.row = static_cast<int>(index / width());
    pixel.column = static_cast<int>(index % width());
    std::array<std::int32_t, 4> others;
    std::size_t count = 0;
    forEachNeighbour(pixel.row, pixel.column, [&](std::size_t n) {
      const std::int32_t other = labels_[n];
      if (other != 0 && other != current && planes_[static_cast<std::size_t>(other)].usable) others[count++] = other;
    });
    if (count == 0) return current;
    pixel.w = static_cast<double>(image_.w[index]);
    pixel.weight = static_cast<double>(image_.weight[index]);
    pixel.inverse_sigma = std::sqrt(pixel.weight);
    const double current_error = current != 0 ? error(current, pixel) : parameters_.max_residual;
    double least = current_error;
    std::int32_t best = current;
    for (std::size_t k = 0; k < count; ++k) {
      const std::int32_t other = others[k];
      if (other == best) continue;
      const double e = error(other, pixel);
      if (current == 0) {
        if (e < least) least = e, best = other;
        continue;
      }
      switch (creaseDecision(current, other, pixel, current_error, e)) {
        case Decision::Keep:
          continue;
        case Decision::Flip:
          least = std::min(least, e), best = other;
          continue;
        case Decision::Residual:
          break;
      }
      if (e < current_error - parameters_.flip_gain && (best == current || e < least)) least = e, best = other;
    }
    return best;
  }

  enum class Decision { Keep, Flip, Residual };
  Decision creaseDecision(std::int32_t current, std::int32_t other, const Pixel& pixel, double current_error,
                          double other_error) {
    if (!use_creases_) return Decision::Residual;
    if (current_error > parameters_.crease_range || other_error > parameters_.crease_range) return Decision::Residual;
    const double difference = planeAt(current, pixel.row, pixel.column) - planeAt(other, pixel.row, pixel.column);
    if (difference * difference * pixel.weight > parameters_.crease_range * parameters_.crease_range)
      return Decision::Residual;
    const Crease kind = crease_of_[RegionPair(current, other)];
    if (kind == Crease::Unknown) return Decision::Residual;
    const bool current_is_surface = kind == Crease::Convex ? difference <= 0.0 : difference >= 0.0;
    if (current_is_surface) return Decision::Keep;
    return other_error < current_error + parameters_.crease_slack ? Decision::Flip : Decision::Keep;
  }

  const InverseDepthImage& image_;
  const InverseDepthParameters::Refinement& parameters_;
  std::vector<std::int32_t>& labels_;
  std::vector<RefinedPlane> planes_;
  RegionPairs<Votes> votes_;
  RegionPairLookup<Votes> votes_of_{votes_};
  RegionPairs<Crease> creases_;
  RegionPairLookup<Crease> crease_of_{creases_};
  std::vector<std::size_t>& frontier_;
  std::vector<std::uint8_t>& queued_;
  std::vector<Change>& changes_;
  bool use_creases_ = true;
};

}  // namespace

void refineBoundaries(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
                      RefinementMemory& memory) {
  Refiner(image, parameters, map, memory).run();
}

}  // namespace epcc
