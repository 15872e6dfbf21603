// SPDX-License-Identifier: BSD-3-Clause
// Neighbours are counted for each candidate.
#include "inverse_depth/steady_borders.h"

#include <cstddef>

namespace epcc {

namespace {

constexpr int kFewestBeside = 2;  // of four

int countBeside(const InverseDepthImage& image, const std::int32_t* labels, const RefinementMemory::Pixel& pixel,
                std::int32_t label) {
  const std::int32_t* here = labels + pixel.index;
  int count = 0;
  if (pixel.column > 0) count += here[-1] == label ? 1 : 0;
  if (pixel.column + 1 < image.width) count += here[1] == label ? 1 : 0;
  if (pixel.row > 0) count += here[-image.width] == label ? 1 : 0;
  if (pixel.row + 1 < image.height) count += here[image.width] == label ? 1 : 0;
  return count;
}

}  // namespace

void askNeighbours(const InverseDepthImage& image, const std::int32_t* labels, double flip_gain,
                   const RefinementMemory::Pixel* pixels, RefinementMemory::Part& part) {
  for (std::size_t k = 0; k < part.candidate_count; ++k) {
    RefinementMemory::Candidate& candidate = part.candidates[k];
    const RefinementMemory::Choice& choice = part.choices[static_cast<std::size_t>(candidate.choice)];
    if (choice.current == 0) continue;
    const RefinementMemory::Pixel& pixel = pixels[candidate.choice];
    const int own = countBeside(image, labels, pixel, choice.current);
    const int others = countBeside(image, labels, pixel, candidate.label);
    if (candidate.verdict == Verdict::Flip && others < kFewestBeside) candidate.verdict = Verdict::Keep;
    if (own < kFewestBeside && others > own) {
      candidate.verdict = Verdict::Residual;
      candidate.other_error -= flip_gain * (others - own);
    }
  }
}

}  // namespace epcc
