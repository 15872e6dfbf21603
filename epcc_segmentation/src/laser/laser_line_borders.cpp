// SPDX-License-Identifier: BSD-3-Clause
// Lines and borders in turn.
#include "laser/laser_line_borders.h"

#include <algorithm>

namespace epcc {
namespace {

constexpr int kBorderRounds = 3;
// A point at the end of a line must be nearer than others, in sigma^2: it may belong to a surface that comes next and
// is too small to be a line.
constexpr double kMostAtEnd = 4.0;
constexpr double kStray = 25.0;   // sigma^2: a point no farther off is not taken, but it is no opening in the line
constexpr int kFewestOfLine = 4;  // points with which a line lives on until the last round

/// Squared error in sigma^2, no more than `most`.
double cappedError(const RangeLine& line, const LaserSample& sample, double most) {
  RangeError error;
  if (!rangeError(line, sample, error)) return most;
  return std::min(most, error.squared / error.variance);
}

/// The first sample of the second line: errors of both are smallest with it.
int borderBetween(const std::vector<LaserSample>& samples, const GrownLaserLine& a, const GrownLaserLine& b,
                  double most) {
  const int from = a.members[a.members.size() / 2] + 1;
  const int to = b.members[b.members.size() / 2];
  double difference = 0.0, smallest = 0.0;
  int border = from;
  for (int i = from; i < to; ++i) {
    difference += cappedError(a.line, samples[i], most) - cappedError(b.line, samples[i], most);
    if (difference < smallest) {
      smallest = difference;
      border = i + 1;
    }
  }
  return border;
}

/// Samples of a line between two borders, from its middle on in both directions.
std::vector<int> ownSamples(const std::vector<LaserSample>& samples, const GrownLaserLine& grown, int begin, int end,
                            double most, double max_gap) {
  std::vector<int> own;
  const int middle = std::clamp(grown.members[grown.members.size() / 2], begin, end - 1);
  const auto take = [&](int i, int& last) {
    if (!isWithinGap(grown.line, samples[last], samples[i], max_gap)) return false;
    const double error = cappedError(grown.line, samples[i], kStray);
    if (error < most) own.push_back(i);
    if (error < kStray) last = i;
    return true;
  };
  for (int i = middle, last = middle; i >= begin && take(i, last); --i) {
  }
  std::reverse(own.begin(), own.end());
  for (int i = middle + 1, last = middle; i < end && take(i, last); ++i) {
  }
  return own;
}

/// How many points of an end, in this order, are farther off than points of a line are.
template <typename Iterator>
int strayPoints(const std::vector<LaserSample>& samples, const RangeLine& line, Iterator first, Iterator last,
                double most) {
  double sum = 0.0, largest = 0.0;
  int stray = 0, count = 0;
  for (; first != last; ++first) {
    sum += cappedError(line, samples[*first], most) - kMostAtEnd;
    ++count;
    if (sum <= largest) continue;
    largest = sum;
    stray = count;
  }
  return stray;
}

void trimEnds(const std::vector<LaserSample>& samples, double most, GrownLaserLine& grown) {
  std::vector<int>& members = grown.members;
  members.resize(members.size() - strayPoints(samples, grown.line, members.rbegin(), members.rend(), most));
  members.erase(members.begin(),
                members.begin() + strayPoints(samples, grown.line, members.begin(), members.end(), most));
}

void dropBelow(std::size_t points, std::vector<GrownLaserLine>& lines) {
  lines.erase(std::remove_if(lines.begin(), lines.end(),
                             [&](const GrownLaserLine& grown) { return grown.members.size() < points; }),
              lines.end());
}

}  // namespace

void settleBorders(const std::vector<LaserSample>& samples, const SensorModel& noise,
                   const LaserLineParameters& parameters, std::vector<GrownLaserLine>& lines) {
  const double most = 2.0 * parameters.k_max * parameters.k_max;
  for (int round = 0; round < kBorderRounds; ++round) {
    for (GrownLaserLine& grown : lines)
      if (fitRangeLine(samples, grown.members, noise, grown.line) < 0.0) grown.members.clear();
    dropBelow(kFewestOfLine, lines);
    std::vector<int> borders{0};
    for (std::size_t k = 1; k < lines.size(); ++k)
      borders.push_back(borderBetween(samples, lines[k - 1], lines[k], most));
    borders.push_back(static_cast<int>(samples.size()));
    for (std::size_t k = 0; k < lines.size(); ++k) {
      lines[k].members = ownSamples(samples, lines[k], borders[k], borders[k + 1], most, parameters.max_gap);
      trimEnds(samples, most, lines[k]);
    }
    dropBelow(round + 1 < kBorderRounds ? kFewestOfLine : static_cast<std::size_t>(parameters.min_points), lines);
  }
}

}  // namespace epcc
