// SPDX-License-Identifier: BSD-3-Clause
// Sums over the parts of a block that quadrics come from, and what the quadrics leave; for any vector unit with the
// same bits. How they go together is in block_quadrics.cpp.
#pragma once

#include "sensor/block_samples.h"

namespace epcc {

constexpr int kPartsAcross = 4;
constexpr int kParts = kPartsAcross * kPartsAcross;
constexpr int kMaxPart = kMaxBlock / kPartsAcross;  // side, pixels
constexpr int kDegree = 2;                          // of the quadric
constexpr int kPlaneTerms = 3;
constexpr int kTerms = 6;

/// Place of the sum of x^i y^j among such sums.
constexpr int termAt(int i, int j) {
  return (i + j) * (i + j + 1) / 2 + j;
}
constexpr int kErrorSums = termAt(0, 2 * kDegree + 1);  // of e x^i y^j; those of x^i y^j come first
constexpr int kSquareSum = kErrorSums + kTerms;         // of e^2
constexpr int kBlockSums = kSquareSum + 1;

/// A block's pixels and rays, part by part. x and y run from -1 to 1 in each part.
struct PartPixels {
  int side = 0;
  alignas(64) float w[kMaxPart * kMaxPart][kParts];
  alignas(64) float along_x[kMaxPart][kParts];  // what the plane says of a column, without y
  alignas(64) float along_y[kMaxPart][kParts];
  alignas(64) float x[kMaxPart][kParts];
  alignas(64) float y[kMaxPart][kParts];
};

/// Sums over the inliers of each part.
struct PartSums {
  alignas(64) float of[kBlockSums][kParts];
};

/// Where parts lie in the part that four of them make: its x is that of the small part, halved, and shift_x.
struct PartShifts {
  alignas(64) float x[kParts];
  alignas(64) float y[kParts];
};

/// Fills w.
void splitIntoParts(const BlockSamples& samples, PartPixels& parts);
/// Sums over the pixels with |e| <= gate, e = w - (along_x + along_y).
void sumParts(const PartPixels& parts, float gate, PartSums& sums);
/// The sums of the first `count` parts in the coordinates of the parts that four of them make.
void shiftParts(const PartShifts& shifts, int count, PartSums& sums);
/// Sums of the squares that a plane and a quadric leave in each part.
struct PartSquares {
  alignas(64) float of_plane[kParts];
  alignas(64) float of_quadric[kParts];
};

/// Of the first `count` parts.
void solveParts(const PartSums& sums, int count, PartSquares& squares);

}  // namespace epcc
