// SPDX-License-Identifier: BSD-3-Clause
// Every pair that may be one is tested; the best is joined first.
#include "laser/laser_line_joining.h"

#include <algorithm>

namespace epcc {
namespace {

constexpr double kMostExcess = 18.4;    // of the squared errors: chi squared with two degrees of freedom, 1 in 10 000
constexpr double kMostUncertain = 4.0;  // sigma of one's prediction of the other, in sigma of a range
constexpr double kBehind = 5.0;         // sigma: no stray point
constexpr int kFewestAdopted = 4;       // beams
constexpr double kInFront = 8.0;        // sigma, of what hides a short piece

struct Pair {
  std::size_t first, second;
  GrownLaserLine joined;
  double excess;
};

class Joining {
 public:
  Joining(const std::vector<LaserSample>& samples, const LaserScan& scan, const SensorModel& noise,
          const LaserLineParameters& parameters, bool circle)
      : samples_(samples), scan_(scan), noise_(noise), parameters_(parameters), circle_(circle) {}

  /// The samples from i on in steps of `step` that are a short piece of the line, whose last sample on this side is
  /// `end`. Advances i behind what it looked at; false at the end of what can be hidden.
  bool nextPiece(const GrownLaserLine& grown, const std::vector<char>& taken, int end, int step, int& i, int& looked,
                 std::vector<int>& piece) const {
    piece.clear();
    const int n = static_cast<int>(samples_.size());
    const auto inside = [&](int k) { return circle_ ? (k % n + n) % n : k; };
    const auto valid = [&](int k) { return circle_ || (k >= 0 && k < n); };
    const double most = 2.0 * parameters_.k_max * parameters_.k_max;
    // Few beams prove little: they are no farther on than what is known of the line is long.
    const Eigen::Vector2d last = grown.line.point(samples_[end].direction);
    const Eigen::Vector2d other =
        grown.line.point(samples_[step > 0 ? grown.members.front() : grown.members.back()].direction);
    const double reach = std::min(parameters_.max_hidden, (last - other).norm());
    for (; valid(i) && looked < n && piece.empty(); i += step, ++looked) {
      const int k = inside(i);
      const double range = grown.line.range(samples_[k].direction);
      if (!(range > 0.0) || (grown.line.point(samples_[k].direction) - last).norm() > reach) return false;
      if (!isHiding(grown.line, samples_[k])) continue;
      for (int next = i + step; valid(next); next += step) {
        const int candidate = inside(next);
        RangeError error;
        if (taken[static_cast<std::size_t>(candidate)] || !rangeError(grown.line, samples_[candidate], error) ||
            error.squared > most * error.variance || !predicts(grown.line, candidate))
          break;
        piece.push_back(candidate);
      }
      if (static_cast<int>(piece.size()) < kFewestAdopted) piece.clear();
      if (piece.empty()) continue;
      const int from = samples_[step > 0 ? end : piece.front()].beam,
                to = samples_[step > 0 ? piece.front() : end].beam;
      if (!isHidden(grown.line, from, to)) return false;
    }
    return !piece.empty();
  }

  /// Whether `second`, whose beams follow those of `first`, goes on with it.
  bool test(const GrownLaserLine& first, const GrownLaserLine& second, Pair& pair) const {
    if (!predicts(first.line, second.members.front()) || !predicts(second.line, first.members.back())) return false;
    if (!mayBeOne(first, second)) return false;
    pair.joined.members = first.members;
    pair.joined.members.insert(pair.joined.members.end(), second.members.begin(), second.members.end());
    pair.joined.line = first.members.size() > second.members.size() ? first.line : second.line;
    const double together = fitRangeLine(samples_, pair.joined.members, noise_, pair.joined.line);
    if (together < 0.0) return false;
    const double apart = errors(first) + errors(second);
    const double freedom = static_cast<double>(pair.joined.members.size()) - 4.0;
    // A noise model that is too small must not keep one wall in pieces.
    pair.excess = (together - apart) / std::max(1.0, apart / std::max(1.0, freedom));
    return pair.excess <= kMostExcess &&
           isHidden(pair.joined.line, samples_[first.members.back()].beam, samples_[second.members.front()].beam);
  }

 private:
  double errors(const GrownLaserLine& grown) const {
    RangeLine line = grown.line;
    return std::max(0.0, fitRangeLine(samples_, grown.members, noise_, line));
  }

  /// Whether the middle of the second is where the first may go on: a quick look before lines are fitted.
  bool mayBeOne(const GrownLaserLine& first, const GrownLaserLine& second) const {
    const LaserSample& middle = samples_[second.members[second.members.size() / 2]];
    RangeError error;
    if (!rangeError(first.line, middle, error)) return false;
    constexpr double kSigmas = 6.0;
    const double variance = error.variance + first.line.rangeVariance(middle.direction);
    return error.squared <= kSigmas * kSigmas * variance;
  }

  bool isHiding(const RangeLine& line, const LaserSample& sample) const {
    const double range = line.range(sample.direction);
    return range - sample.range > kInFront * noise_.sigmaZ(range);
  }

  /// To within a few sigma, whether right or wrong.
  bool predicts(const RangeLine& line, int i) const {
    const LaserSample& sample = samples_[i];
    if (!(line.range(sample.direction) > 0.0)) return false;
    RangeError error;
    if (!rangeError(line, sample, error)) return false;
    const double variance = line.rangeVariance(sample.direction);
    return variance <= kMostUncertain * kMostUncertain * error.variance;
  }

  Eigen::Vector2d direction(int beam) const {
    const double angle = scan_.angle(static_cast<std::size_t>(beam));
    return {std::cos(angle), std::sin(angle)};
  }

  /// Whether beams pass through the line, or end nowhere.
  bool isOpen(const RangeLine& line, int beam) const {
    if (!scan_.hasReturn(static_cast<std::size_t>(beam))) return true;
    const double range = line.range(direction(beam));
    const double variance = noise_.varianceZ(range) + line.rangeVariance(direction(beam));
    const double behind = scan_.ranges[static_cast<std::size_t>(beam)] - range;
    return behind > 0.0 && behind * behind > kBehind * kBehind * variance;
  }

  bool isHidden(const RangeLine& line, int from, int to) const {
    const int beams = static_cast<int>(scan_.ranges.size());
    const auto next = [&](int beam) { return beam + 1 == beams ? 0 : beam + 1; };
    Eigen::Vector2d last = line.point(direction(from));
    if ((line.point(direction(to)) - last).norm() > parameters_.max_hidden) return false;
    double open = 0.0;
    for (int beam = next(from); beam != to; beam = next(beam)) {
      if (!(line.range(direction(beam)) > 0.0)) return false;
      const Eigen::Vector2d point = line.point(direction(beam));
      open = isOpen(line, beam) ? open + (point - last).norm() : 0.0;
      if (open > parameters_.max_gap) return false;
      last = point;
    }
    return true;
  }

  const std::vector<LaserSample>& samples_;
  const LaserScan& scan_;
  const SensorModel& noise_;
  const LaserLineParameters& parameters_;
  bool circle_;
};

}  // namespace

void joinHiddenLines(const std::vector<LaserSample>& samples, const LaserScan& scan, const SensorModel& noise,
                     const LaserLineParameters& parameters, bool circle, std::vector<GrownLaserLine>& lines) {
  const Joining joining(samples, scan, noise, parameters, circle);
  for (;;) {
    Pair best{0, 0, {}, -1.0}, pair;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (std::size_t j = 0; j < lines.size(); ++j) {
        if (i == j || (j < i && !circle)) continue;
        if (!joining.test(lines[i], lines[j], pair)) continue;
        if (best.excess >= 0.0 && pair.excess >= best.excess) continue;
        best = pair;
        best.first = i;
        best.second = j;
        best.excess = std::max(0.0, pair.excess);
      }
    if (best.excess < 0.0) return;
    lines[best.first] = best.joined;
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(best.second));
  }
}

void adoptHiddenPieces(const std::vector<LaserSample>& samples, const LaserScan& scan, const SensorModel& noise,
                       const LaserLineParameters& parameters, bool circle, std::vector<GrownLaserLine>& lines) {
  const Joining joining(samples, scan, noise, parameters, circle);
  std::vector<char> taken(samples.size(), 0);
  for (const GrownLaserLine& grown : lines)
    for (const int i : grown.members) taken[static_cast<std::size_t>(i)] = 1;
  for (GrownLaserLine& grown : lines)
    for (const int step : {1, -1}) {
      std::vector<int> piece;
      int end = step > 0 ? grown.members.back() : grown.members.front();
      int i = end + step, looked = 0;
      while (joining.nextPiece(grown, taken, end, step, i, looked, piece)) {
        for (const int k : piece) taken[static_cast<std::size_t>(k)] = 1;
        end = piece.back();
        if (step < 0) std::reverse(piece.begin(), piece.end());
        grown.members.insert(step > 0 ? grown.members.end() : grown.members.begin(), piece.begin(), piece.end());
        if (fitRangeLine(samples, grown.members, noise, grown.line) < 0.0) break;
      }
    }
}

}  // namespace epcc
