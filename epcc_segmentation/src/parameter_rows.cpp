// SPDX-License-Identifier: BSD-3-Clause
// The rows of the parameter table. Their texts are those of the headers' comments; a test holds the two against each
// other.
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "epcc_segmentation/parameter_table.h"

namespace epcc {

namespace {

using Get = double (*)(const Parameters&);
using Set = void (*)(Parameters&, double);
ParameterField number(const char* name, Get get, Set set, bool whole, double low, double high, const char* unit,
                      const char* meaning, const char* raise, const char* lower) {
  return {name, get, set, whole, low, high, {}, unit, meaning, raise, lower, ""};
}

ParameterField choice(const char* name, Get get, Set set, bool whole, std::vector<const char*> words,
                      const char* meaning, const char* advice) {
  const double last = static_cast<double>(words.size()) - 1.0;
  return {name, get, set, whole, 0.0, last, std::move(words), "", meaning, "", "", advice};
}

/// The value of a field nearest to a number, which a whole number or a choice cannot always hold. What is no number is
/// the lowest, which no range contains.
template <typename Field>
Field nearestOf(double value) {
  if constexpr (std::is_same<Field, bool>::value) {
    return value != 0.0;
  } else if constexpr (std::is_enum<Field>::value) {
    return static_cast<Field>(nearestOf<std::underlying_type_t<Field>>(value));
  } else if constexpr (std::is_integral<Field>::value) {
    const double low = std::numeric_limits<Field>::lowest(), high = std::numeric_limits<Field>::max();
    return std::isnan(value) ? std::numeric_limits<Field>::lowest() : static_cast<Field>(std::clamp(value, low, high));
  } else {
    return static_cast<Field>(value);
  }
}

// A field's name is its path in Parameters; choices are enums or bool.
#define EPCC_FIELD(path) \
#path, [](const Parameters& p) { return static_cast<double>(p.path); },                                           \
      [](Parameters& p, double value) { p.path = nearestOf<std::decay_t<decltype(p.path)>>(value); },                  \
      !std::is_floating_point<decltype(std::declval<Parameters&>().path)>::value

std::vector<ParameterField> generalFields() {
  return {
      choice(EPCC_FIELD(mode), {"inverse-depth", "paper"}, "Form of the method",
             "Choose paper to compare with the publication"),
      choice(EPCC_FIELD(scan), {"columns", "rows", "both"}, "Scan lines",
             "Choose one direction to save time; rows are an error for spherical scans, whose rows are cones"),
      number(EPCC_FIELD(threads), 1, 256, "threads", "Threads; the result does not depend on them", "cores are idle",
             "other work needs them"),
      choice(EPCC_FIELD(line_segments), {"off", "on"}, "Report the line segments too (PlaneSegmentation::segments)",
             "Choose on to draw them, or to build something else than planes on them"),
  };
}

std::vector<ParameterField> inverseDepthFields() {
  return {
      number(EPCC_FIELD(inverse_depth.min_points), 1, 1e9, "pixels",
             "Planes with fewer pixels are rejected (S7); of a frame whose pixels are scattered their area counts, "
             "holes included",
             "small pieces of clutter are reported",
             "small faces are missing and the sensor is good enough to see them"),
      number(EPCC_FIELD(inverse_depth.min_confidence), 0, 1, "",
             "Planes that are less likely surfaces than this are rejected (S9), see Plane::confidence",
             "ragged pieces of clutter are reported", "frames, rails and other narrow planes are missing"),
      number(
          EPCC_FIELD(inverse_depth.stride), 0, 8, "pixels",
          "Grid of the samples that the planes are found on, every so many rows and columns; the labels are those of "
          "all pixels. 0: by the longer side, one for every 320 pixels",
          "time matters more than small faces", "faces of a few pixels matter more than time"),
      choice(
          EPCC_FIELD(inverse_depth.adapt_sensor), {"off", "on"},
          "Pull size and correlation length of a given sensor model to those of the error that the frames show, unless "
          "they agree within 20 % (S0)",
          "Choose off if the model is known to be right, and for repeatable experiments with wrong ones"),
      number(
          EPCC_FIELD(inverse_depth.line_k_max), kAboveZero, 100, "sigma_w",
          "Gate of a line segment (S1): a sample belongs to it within so many standard deviations of the sensor model",
          "surfaces break into pieces although the sensor model is right",
          "shallow creases and small steps are run over"),
      number(EPCC_FIELD(inverse_depth.plane_k_max), kAboveZero, 100, "sigma",
             "Gate of a plane (S2): a line segment joins the plane if it agrees with it within so many standard "
             "deviations",
             "planes break along the scan direction", "neighbouring faces that differ by a few degrees join"),
      number(EPCC_FIELD(inverse_depth.region_tolerance), 0, 100, "sigma",
             "Offset within which two large regions are one surface (c2 of S4)",
             "large walls stay in pieces that lie a little apart (over-segmentation)",
             "doors, steps or panels join the wall behind them (under-segmentation)"),
      number(EPCC_FIELD(inverse_depth.expert.lines.min_samples), 3, 100, "samples",
             "Rejected samples in a row that may start a new line segment", "clutter starts too many short segments",
             "faces a few pixels wide are missing"),
      number(EPCC_FIELD(inverse_depth.expert.lines.max_gap_pixels), 0, 1000, "pixels",
             "A line segment ends after more missing or rejected pixels than this", "holes in the depth cut surfaces",
             "segments jump over narrow objects and grooves"),
      number(EPCC_FIELD(inverse_depth.expert.planes.min_overlap_pixels), 1, 1000, "pixels",
             "Neighbouring segments of a plane overlap by at least so many pixels, and by half of the shorter",
             "planes leak through thin bridges", "narrow slanted faces break up"),
      number(EPCC_FIELD(inverse_depth.expert.planes.max_prediction), 0, 1e6, "sigma_w^2",
             "Largest prediction variance of plane and line that widens the gate",
             "young planes lose segments that belong to them", "young planes take segments that do not belong to them"),
      number(EPCC_FIELD(inverse_depth.expert.planes.min_points), 1, 1e6, "pixels",
             "Planes with fewer pixels never reach the merge (S3)", "many specks slow the merge down",
             "fragments that would have completed a surface are missing"),
      number(EPCC_FIELD(inverse_depth.expert.planes.min_segments), 1, 1e6, "segments",
             "Planes of fewer line segments never reach the merge (S3)", "single noisy scan lines become planes",
             "surfaces one scan line wide matter"),
      number(EPCC_FIELD(inverse_depth.expert.merging.fragment_tolerance), 0, 1e6, "independent samples",
             "Tolerance for fragments (c1): the fewer samples a region has, the farther off it may lie",
             "small fragments stay beside the surface that they belong to", "small faces are swallowed by large ones"),
      number(EPCC_FIELD(inverse_depth.expert.merging.max_step), kAboveZero, 1e6, "sigma",
             "Largest step along the common border, rms", "fragments with a poor border stay apart",
             "fragments jump over real steps"),
      number(EPCC_FIELD(inverse_depth.expert.merging.ragged_border), kAboveZero, 1e6, "squares",
             "Contacts, in those of a square of the smaller region, above which a border counts as ragged and the "
             "offset tolerance grows in proportion",
             "interleaved surfaces of different depth join", "one surface split by noise stays in interleaved pieces"),
      number(EPCC_FIELD(inverse_depth.expert.merging.max_ragged_gain), 1, 100, "",
             "Largest factor by which a ragged border widens the offset tolerance",
             "one surface split by noise stays in interleaved pieces", "interleaved surfaces of different depth join"),
      number(EPCC_FIELD(inverse_depth.expert.merging.max_ragged_step), 0, 1e6, "sigma",
             "Largest step along a ragged border, rms, at which the tolerance still grows",
             "one surface split by noise stays in interleaved pieces",
             "surfaces a small step apart join along a ragged border"),
      number(EPCC_FIELD(inverse_depth.expert.merging.bridge_samples), 0, 1000, "independent samples of a line",
             "Regions are neighbours across a hole of this width", "blotchy holes keep the parts of a wall apart",
             "parts that lie on both sides of a hole join wrongly"),
      number(EPCC_FIELD(inverse_depth.expert.merging.min_bridge_pixels), 0, 1000, "pixels",
             "Regions are neighbours across a hole of this width, whatever the sensor",
             "drop-outs and dark spots keep the parts of a wall apart",
             "parts that lie on both sides of a hole join wrongly"),
      number(EPCC_FIELD(inverse_depth.expert.merging.min_contacts), 1, 1e6, "pixels",
             "Regions are neighbours if they face each other in so many places", "regions join through a few pixels",
             "thin faces stay apart from their surface"),
      number(EPCC_FIELD(inverse_depth.expert.merging.min_samples), 0, 1e6, "independent samples",
             "Regions with fewer are dropped before the borders are refined", "specks eat into the borders",
             "fragments are lost that the second merge would have used"),
      number(EPCC_FIELD(inverse_depth.expert.merging.max_occluder), 0, 100, "",
             "Regions on both sides of something nearer may be one surface (S8) if it covers no more of a row or "
             "column than this share of what is seen of the two; 0 keeps them apart",
             "a wall behind a broad object should be one plane",
             "separate surfaces at the same depth join behind an object"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.passes), 0, 1000, "passes", "Passes over the borders",
             "unlabelled margins remain along the edges", "time matters more than the last pixels"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.max_residual), kAboveZero, 100, "sigma",
             "An unlabelled pixel joins a region within this residual; a pixel farther behind or in front of the "
             "regions on both sides of it is a groove (S4) or an occluder (S8)",
             "surfaces have unlabelled pixels", "objects on a surface are taken into it"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.flip_gain), 0, 100, "sigma",
             "A labelled pixel changes sides for a gain of this much", "borders flicker between two regions",
             "borders stay where the scan lines left them"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.crease_passes), 0, 1000, "passes",
             "Passes, of all, in which creases are decided by geometry", "creases are still frayed",
             "spikes grow at the corners of boxes"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.crease_vote_pixels), 1, 100, "pixels",
             "Distance from the border at which the kind of a crease, convex or concave, is voted",
             "borders are frayed wider than this", "faces are narrower than twice this"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.crease_min_votes), 1, 1e6, "votes",
             "Fewest votes that decide the kind of a crease", "creases are misjudged",
             "short creases are not sharpened"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.crease_agreement), 0.5, 1, "",
             "Share of the votes that decides the kind of a crease; at 0.5 a tie counts as convex",
             "creases are misjudged", "noisy creases are not sharpened"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.crease_range), 0, 100, "sigma",
             "Largest residual and plane difference at which a crease decides", "creases of noisy faces stay frayed",
             "pixels far from both faces change sides"),
      number(EPCC_FIELD(inverse_depth.expert.refinement.crease_slack), 0, 100, "sigma",
             "Residual that a crease may cost a pixel", "creases stay frayed", "pixels land on the wrong face"),
      number(EPCC_FIELD(inverse_depth.expert.evidence.min_samples), 0, 1e6, "independent samples",
             "Planes with fewer are rejected, whatever their residuals", "blotches of the error are reported as planes",
             "small faces are missing"),
      number(EPCC_FIELD(inverse_depth.expert.evidence.max_chi2), kAboveZero, 1e6, "sigma^2",
             "Largest mean squared residual of a plane",
             "real surfaces are rejected because the sensor model is too narrow",
             "curved and cluttered regions are reported"),
      number(EPCC_FIELD(inverse_depth.expert.evidence.min_evidence), 0, 1e6, "independent samples",
             "Samples that a plane needs, times max(0.5, chi^2)", "pieces of clutter are reported",
             "small faces are missing"),
      number(EPCC_FIELD(inverse_depth.expert.evidence.rough_evidence), 0, 1e6, "independent samples",
             "The least that a plane rougher than the sensor, chi^2 > 1, needs",
             "pieces of chairs and plants are reported", "small rough faces are missing"),
      number(EPCC_FIELD(inverse_depth.expert.evidence.min_radius), 0, 1e6, "m",
             "Surfaces that bend with a smaller radius are not planes", "facets of columns and cushions are reported",
             "slightly bent boards are missing"),
      number(EPCC_FIELD(inverse_depth.expert.evidence.bending_share), 0, 1, "",
             "Share of the squared residuals that bending must explain before a region is rejected for it",
             "bent boards are missing", "facets of curved things are reported"),
      number(EPCC_FIELD(inverse_depth.expert.evidence.bending_evidence), 0, 1e6, "independent samples",
             "Reduction of the squared residuals, in sigma^2 per independent sample, that bending must be worth",
             "planes are rejected for the bending of the sensor", "facets of curved things are reported"),
  };
}

std::vector<ParameterField> paperFields() {
  return {
      number(EPCC_FIELD(paper.line_k_max), kAboveZero, 100, "sigma",
             "k_max of Eq. 20: a sample belongs to the line segment if d^2 <= k_max^2 (sigma^2 + s^2)",
             "scan lines break into short segments", "segments bend around edges"),
      number(EPCC_FIELD(paper.plane_k_max), kAboveZero, 100, "sigma",
             "k_max of Eq. 23: a line segment belongs to the plane if its cost is below k_max^2",
             "surfaces are over-segmented", "neighbouring faces join (under-segmentation)"),
      number(EPCC_FIELD(paper.max_gap), 0, 100, "m",
             "d_1 of Eq. 27: gap between neighbouring segments of a plane, beyond the noise", "holes cut surfaces",
             "separate objects at the same depth join"),
      number(EPCC_FIELD(paper.min_segments), 1, 1e6, "segments",
             "Planes with fewer line segments are dropped (min_c of Sec. 7.1: 15 segments are the 30 end points)",
             "clutter is reported", "narrow surfaces are missing"),
      number(EPCC_FIELD(paper.min_points), 0, 1e9, "pixels", "Planes with fewer pixels are dropped",
             "specks are reported", "small surfaces are missing"),
      choice(EPCC_FIELD(paper.criterion), {"a", "b", "c", "d"}, "Form of the criterion (Table 2)",
             "Choose b if segments are short and noisy, c or d only to study what the noise model is worth"),
      choice(EPCC_FIELD(paper.endpoint_weight), {"printed", "exponential", "gaussian", "cauchy", "huber", "none"},
             "Weight of an end point in the covariance of its plane (Eq. 26)",
             "Choose exponential on real depth, whose error is correlated, for fewer strips; cauchy or huber for fewer "
             "still, at the cost of small surfaces; none only to study what the weight is worth"),
      number(EPCC_FIELD(paper.expert.lines.fit_samples), 2, 100, "samples",
             "l: samples that fit the candidate of a new segment", "candidates are fitted to noise",
             "short segments are missing"),
      number(EPCC_FIELD(paper.expert.lines.validation_samples), 1, 100, "samples",
             "l_v: later samples that must agree with the candidate; k_min = l + l_v", "candidates start in clutter",
             "short segments are missing"),
      number(EPCC_FIELD(paper.expert.lines.buffer_samples), 2, 1000, "samples",
             "n_buf: rejected samples kept for a new segment, at least k_min (Fig. 12)",
             "outliers push the start of a surface out of the buffer",
             "time matters: every start in the buffer is tried"),
      number(EPCC_FIELD(paper.expert.lines.projection_floor), 0, 1, "",
             "Smallest share of sigma_z^2 that counts across a grazing line (floor of q^2 in Eq. 20)",
             "floors and side walls break up", "steps on floors and side walls are run over"),
      choice(EPCC_FIELD(paper.expert.lines.use_sensor_noise), {"off", "on"}, "Use sigma_z in Eq. 20",
             "Choose off only to study what the noise model is worth (Fig. 15)"),
      number(EPCC_FIELD(paper.expert.planes.look_back), 1, 100, "scan lines",
             "Scan lines to look back for a segment that has a plane", "scan lines without a segment end surfaces",
             "separate surfaces join across a gap"),
      number(
          EPCC_FIELD(paper.expert.planes.pair_look_back), 1, 100, "scan lines",
          "Scan lines to look back for a partner that starts a plane, at most look_back; older segments are outliers",
          "surfaces start late", "clutter starts planes"),
      number(EPCC_FIELD(paper.expert.planes.max_start_angle), kAboveZero, 90, "degrees",
             "Largest angle between the two segments that start a plane", "slanted surfaces start late",
             "planes start on curved things"),
  };
}

#undef EPCC_FIELD

}  // namespace

const std::vector<ParameterField>& parameterFields() {
  static const std::vector<ParameterField> fields = [] {
    std::vector<ParameterField> all = generalFields();
    std::vector<ParameterField> inverse_depth = inverseDepthFields();
    std::vector<ParameterField> paper = paperFields();
    for (ParameterField& field : inverse_depth) all.push_back(std::move(field));
    for (ParameterField& field : paper) all.push_back(std::move(field));
    return all;
  }();
  return fields;
}

}  // namespace epcc
