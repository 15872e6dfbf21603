// SPDX-License-Identifier: BSD-3-Clause
// Parts of a quarter of the side -> of half of it -> the block: sums are taken over the smallest alone.
#include "sensor/block_quadrics.h"

#include <algorithm>
#include <cassert>

#include "sensor/block_parts.h"

namespace epcc {

namespace {

constexpr float kMinShare = 0.6f;
constexpr float kMinPixels = 12.0f;

/// Middles of the parts of all sizes, in the block's coordinates; along x or along y.
struct Middles {
  float of_quarters[4];
  float of_halves[2];
  float of_all;

  Middles(const float* ray, int side) {
    const auto middle = [ray](int begin, int end) { return 0.5f * (ray[begin] + ray[end - 1]); };
    for (int i = 0; i < 4; ++i) of_quarters[i] = middle(i * side / 4, (i + 1) * side / 4);
    for (int i = 0; i < 2; ++i) of_halves[i] = middle(i * side / 2, (i + 1) * side / 2);
    of_all = middle(0, side);
  }
};

void findRays(const BlockRays& rays, const SamplePlane& plane, const Middles& x, const Middles& y, PartPixels& parts) {
  constexpr auto kScale = static_cast<float>(kPartsAcross);
  for (int i = 0; i < parts.side; ++i)
    for (int part = 0; part < kPartsAcross; ++part) {
      const int at = part * parts.side + i;
      const float along_x = plane.x * rays.x[at] + plane.forward * rays.forward[at];
      const float along_y = plane.y * rays.y[at];
      const float in_x = kScale * (rays.x[at] - x.of_quarters[part]);
      const float in_y = kScale * (rays.y[at] - y.of_quarters[part]);
      for (int other = 0; other < kPartsAcross; ++other) {
        parts.along_x[i][other * kPartsAcross + part] = along_x;
        parts.x[i][other * kPartsAcross + part] = in_x;
        parts.along_y[i][part * kPartsAcross + other] = along_y;
        parts.y[i][part * kPartsAcross + other] = in_y;
      }
    }
}

/// Sums over `across` x `across` parts become those of half as many each way, the first lanes.
void joinFours(PartSums& sums, int across) {
  const int half = across / 2;
  for (auto& sum : sums.of)
    for (int down = 0; down < half; ++down)
      for (int right = 0; right < half; ++right) {
        const float* first = sum + 2 * down * across + 2 * right;
        sum[down * half + right] = (first[0] + first[1]) + (first[across] + first[across + 1]);
      }
}

/// The squares of all parts are found, too.
double pooledSquares(const PartSums& sums, int count, float least_pixels, PartSquares& squares) {
  solveParts(sums, count, squares);
  double total = 0.0, pixels = 0.0;
  for (int part = 0; part < count; ++part) {
    if (sums.of[0][part] < least_pixels) continue;
    total += static_cast<double>(squares.of_quadric[part]);
    pixels += static_cast<double>(sums.of[0][part]);
  }
  return pixels > 0.0 ? total / pixels : 0.0;
}

/// Of the first part.
double bentOf(const PartSquares& squares, double pixels) {
  const auto plane = static_cast<double>(squares.of_plane[0]), quadric = static_cast<double>(squares.of_quadric[0]);
  const double free = pixels - kTerms;
  return quadric > 0.0 && free > 0.0 ? (plane - quadric) / (kTerms - kPlaneTerms) / (quadric / free) : 1.0;
}

/// Of the squares of white error on so many pixels, what a quadric leaves.
double shareLeft(float pixels) {
  return 1.0 - static_cast<double>(kTerms) / static_cast<double>(pixels);
}

}  // namespace

QuadricResiduals fitQuadrics(const BlockSamples& samples, const BlockRays& rays, const SamplePlane& plane, float gate,
                             double full_share) {
  assert(samples.side % (4 * kPartsAcross) == 0);
  PartPixels parts;
  parts.side = samples.side / kPartsAcross;
  const Middles x(rays.x, samples.side), y(rays.y, samples.side);
  findRays(rays, plane, x, y, parts);
  splitIntoParts(samples, parts);
  PartSums sums;
  PartSquares part_squares;
  sumParts(parts, gate, sums);

  QuadricResiduals result;
  const auto measure = [&](std::size_t scale, int across) {
    const auto side = static_cast<float>(samples.side / across);
    const float full = static_cast<float>(full_share) * side * side;
    const double squares = pooledSquares(sums, across * across, std::max(kMinPixels, kMinShare * full), part_squares);
    // Of fewer pixels a quadric takes a larger share: as if none was missing.
    result.squares[scale] = squares * shareLeft(side * side) / shareLeft(full);
  };
  measure(0, 4);
  PartShifts shifts{};
  for (int part = 0; part < 16; ++part) {
    shifts.x[part] = 2.0f * (x.of_quarters[part % 4] - x.of_halves[part % 4 / 2]);
    shifts.y[part] = 2.0f * (y.of_quarters[part / 4] - y.of_halves[part / 8]);
  }
  shiftParts(shifts, 16, sums);
  joinFours(sums, 4);
  measure(1, 2);
  for (int part = 0; part < 4; ++part) {
    shifts.x[part] = x.of_halves[part % 2] - x.of_all;
    shifts.y[part] = y.of_halves[part / 2] - y.of_all;
  }
  shiftParts(shifts, 4, sums);
  joinFours(sums, 2);
  measure(2, 1);
  result.inliers = static_cast<double>(sums.of[0][0]);
  result.bent = bentOf(part_squares, result.inliers);
  return result;
}

}  // namespace epcc
