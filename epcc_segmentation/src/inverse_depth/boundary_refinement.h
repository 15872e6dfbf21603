// SPDX-License-Identifier: BSD-3-Clause
// S5: pixels along the borders of regions find the plane that explains them best.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "inverse_depth/crease_votes.h"
#include "inverse_depth/label_borders.h"
#include "inverse_depth/region_map.h"

namespace epcc {

/// What the refinement knows of a region.
struct RefinedPlane {
  double x = 0.0, y = 0.0, z = 0.0;  ///< q
  double inverse_slope = 1e300;      ///< 1 / sqrt(slope factor); huge where there is no plane: all are far from it
};

/// What a crease says of a pixel: keep your label, take the other, or look at the residuals.
enum class Verdict : std::uint8_t { Residual, Keep, Flip };

/// Lists as long as the borders, kept from frame to frame.
struct RefinementMemory {
  struct Pixel {
    std::int32_t index, row, column;
  };
  struct Change {
    Pixel pixel;
    std::int32_t label;
  };
  /// A pixel of the frontier, what it is and what it may become in this pass.
  struct Choice {
    std::int32_t current, best;
    double least;  ///< residual
  };
  /// A label that a pixel of the frontier sees beside it.
  struct Candidate {
    std::int32_t choice, label;
    double error, other_error;  ///< residuals on the plane that it has and on this one, in sigma across the surface
    double difference;          ///< of the planes
    Verdict verdict;
  };
  std::vector<RefinedPlane> planes;    ///< per label
  RowBits next;                        ///< row after row: pixels to look at in the next pass
  std::vector<std::uint8_t> has_next;  ///< per row: there are some
  // Lists that are written without branches are longer than what they hold; counts tell how much that is.
  /// A band of rows.
  struct Band {
    std::vector<Pixel> frontier;  ///< to look at in this pass
    std::vector<Change> changes;  ///< of the pass
    std::size_t frontier_count = 0, change_count = 0;
  };
  std::vector<Band> bands;
  /// A thread's.
  struct Part {
    RowBorders borders;      ///< of a row
    RowBits upper_labelled;  ///< of the one above
    PixelList list;          ///< some of a row
    CreaseVotes creases;     ///< of the thread; the first one's are all in the end
    // Of some pixels of a frontier.
    std::vector<Choice> choices;
    std::vector<std::int32_t> changed;  ///< choices other than before
    std::vector<Candidate> candidates;
    std::vector<std::size_t> at_crease;  ///< the candidates for which a crease may decide
    std::size_t candidate_count = 0, at_crease_count = 0;
  };
  std::vector<Part> parts;
};

/// Refines the labels with the planes of the regions' present moments, then brings the moments up to date.
void refineBoundaries(const InverseDepthImage& image, const InverseDepthParameters& parameters, RegionMap& map,
                      RefinementMemory& memory, int threads = 1);

}  // namespace epcc
