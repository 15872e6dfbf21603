// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the inverse-depth mode, the default: four basic fields, then those of each step.
#pragma once

namespace epcc {

/// Parameters of Mode::InverseDepth, the default mode.
///
/// Lengths in sigma are in standard deviations of the sensor model; "independent samples" are pixels divided by those
/// that the sensor's correlated error covers (SensorModel::pixelsPerSample()).
struct InverseDepthParameters {
  /// Planes with fewer pixels are rejected (S7); of a frame whose pixels are scattered their area counts, holes
  /// included. [1, 1e9] pixels, default 60. Raise it if small pieces of clutter are reported; lower it if small faces
  /// are missing and the sensor is good enough to see them.
  int min_points = 60;

  /// Planes that are less likely surfaces than this are rejected (S9), see Plane::confidence. [0, 1], default 0.3.
  /// Raise it if ragged pieces of clutter are reported; lower it if frames, rails and other narrow planes are missing.
  double min_confidence = 0.3;

  /// Grid of the samples that the planes are found on, every so many rows and columns; the labels are those of all
  /// pixels. 0: by the longer side, one for every 320 pixels. [0, 8] pixels, default 0. Raise it if time matters more
  /// than small faces; lower it if faces of a few pixels matter more than time.
  int stride = 0;

  /// Pull size and correlation length of a given sensor model to those of the error that the frames show, unless they
  /// agree within 20 % (S0). off | on, default on. Choose off if the model is known to be right, and for repeatable
  /// experiments with wrong ones.
  bool adapt_sensor = true;

  /// Gate of a line segment (S1): a sample belongs to it within so many standard deviations of the sensor model.
  /// (0, 100] sigma_w, default 1.5. Raise it if surfaces break into pieces although the sensor model is right; lower it
  /// if shallow creases and small steps are run over.
  double line_k_max = 1.5;

  /// Gate of a plane (S2): a line segment joins the plane if it agrees with it within so many standard deviations.
  /// (0, 100] sigma, default 2. Raise it if planes break along the scan direction; lower it if neighbouring faces that
  /// differ by a few degrees join.
  double plane_k_max = 2.0;

  /// Offset within which two large regions are one surface (c2 of S4). [0, 100] sigma, default 1.5. Raise it if large
  /// walls stay in pieces that lie a little apart (over-segmentation); lower it if doors, steps or panels join the wall
  /// behind them (under-segmentation).
  double region_tolerance = 1.5;

  // Expert fields, by step: the defaults serve every sensor that was measured.

  /// S1: samples of one scan line become line segments.
  struct Lines {
    /// Rejected samples in a row that may start a new line segment. [3, 100] samples, default 6. Raise it if clutter
    /// starts too many short segments; lower it if faces a few pixels wide are missing.
    int min_samples = 6;

    /// A line segment ends after more missing or rejected pixels than this. [0, 1000] pixels, default 5. Raise it if
    /// holes in the depth cut surfaces; lower it if segments jump over narrow objects and grooves.
    int max_gap_pixels = 5;
  };

  /// S2: line segments of neighbouring scan lines become planes.
  struct Planes {
    /// Neighbouring segments of a plane overlap by at least so many pixels, and by half of the shorter. [1, 1000]
    /// pixels, default 3. Raise it if planes leak through thin bridges; lower it if narrow slanted faces break up.
    int min_overlap_pixels = 3;

    /// Largest prediction variance of plane and line that widens the gate. [0, 1e6] sigma_w^2, default 9. Raise it if
    /// young planes lose segments that belong to them; lower it if young planes take segments that do not belong to
    /// them.
    double max_prediction = 9.0;

    /// Planes with fewer pixels never reach the merge (S3). [1, 1e6] pixels, default 40. Raise it if many specks slow
    /// the merge down; lower it if fragments that would have completed a surface are missing.
    int min_points = 40;

    /// Planes of fewer line segments never reach the merge (S3). [1, 1e6] segments, default 2. Raise it if single noisy
    /// scan lines become planes; lower it if surfaces one scan line wide matter.
    int min_segments = 2;
  };

  /// S4, S6 and S8: neighbouring regions, and those on both sides of an occluder, become one.
  struct Merging {
    /// Tolerance for fragments (c1): the fewer samples a region has, the farther off it may lie. [0, 1e6] independent
    /// samples, default 60. Raise it if small fragments stay beside the surface that they belong to; lower it if small
    /// faces are swallowed by large ones.
    double fragment_tolerance = 60.0;

    /// Largest step along the common border, rms. (0, 1e6] sigma, default 6. Raise it if fragments with a poor border
    /// stay apart; lower it if fragments jump over real steps.
    double max_step = 6.0;

    /// Contacts, in those of a square of the smaller region, above which a border counts as ragged and the offset
    /// tolerance grows in proportion. (0, 1e6] squares, default 1.5. Raise it if interleaved surfaces of different
    /// depth join; lower it if one surface split by noise stays in interleaved pieces.
    double ragged_border = 1.5;

    /// Largest factor by which a ragged border widens the offset tolerance. [1, 100], default 2. Raise it if one
    /// surface split by noise stays in interleaved pieces; lower it if interleaved surfaces of different depth join.
    double max_ragged_gain = 2.0;

    /// Largest step along a ragged border, rms, at which the tolerance still grows. [0, 1e6] sigma, default 1.75. Raise
    /// it if one surface split by noise stays in interleaved pieces; lower it if surfaces a small step apart join along
    /// a ragged border.
    double max_ragged_step = 1.75;

    /// Regions are neighbours across a hole of this width. [0, 1000] independent samples of a line, default 1. Raise it
    /// if blotchy holes keep the parts of a wall apart; lower it if parts that lie on both sides of a hole join
    /// wrongly.
    double bridge_samples = 1.0;

    /// Regions are neighbours across a hole of this width, whatever the sensor. [0, 1000] pixels, default 2. Raise it
    /// if drop-outs and dark spots keep the parts of a wall apart; lower it if parts that lie on both sides of a hole
    /// join wrongly.
    int min_bridge_pixels = 2;

    /// Regions are neighbours if they face each other in so many places. [1, 1e6] pixels, default 3. Raise it if
    /// regions join through a few pixels; lower it if thin faces stay apart from their surface.
    int min_contacts = 3;

    /// Regions with fewer are dropped before the borders are refined. [0, 1e6] independent samples, default 3. Raise it
    /// if specks eat into the borders; lower it if fragments are lost that the second merge would have used.
    double min_samples = 3.0;

    /// Regions on both sides of something nearer may be one surface (S8) if it covers no more of a row or column than
    /// this share of what is seen of the two; 0 keeps them apart. [0, 100], default 0.4. Raise it if a wall behind a
    /// broad object should be one plane; lower it if separate surfaces at the same depth join behind an object.
    double max_occluder = 0.4;
  };

  /// S5: the borders of the regions.
  struct Refinement {
    /// Passes over the borders. [0, 1000] passes, default 12. Raise it if unlabelled margins remain along the edges;
    /// lower it if time matters more than the last pixels.
    int passes = 12;

    /// An unlabelled pixel joins a region within this residual; a pixel farther behind or in front of the regions on
    /// both sides of it is a groove (S4) or an occluder (S8). (0, 100] sigma, default 3. Raise it if surfaces have
    /// unlabelled pixels; lower it if objects on a surface are taken into it.
    double max_residual = 3.0;

    /// A labelled pixel changes sides for a gain of this much. [0, 100] sigma, default 0.3. Raise it if borders flicker
    /// between two regions; lower it if borders stay where the scan lines left them.
    double flip_gain = 0.3;

    /// Passes, of all, in which creases are decided by geometry. [0, 1000] passes, default 6. Raise it if creases are
    /// still frayed; lower it if spikes grow at the corners of boxes.
    int crease_passes = 6;

    /// Distance from the border at which the kind of a crease, convex or concave, is voted. [1, 100] pixels, default 6.
    /// Raise it if borders are frayed wider than this; lower it if faces are narrower than twice this.
    int crease_vote_pixels = 6;

    /// Fewest votes that decide the kind of a crease. [1, 1e6] votes, default 5. Raise it if creases are misjudged;
    /// lower it if short creases are not sharpened.
    int crease_min_votes = 5;

    /// Share of the votes that decides the kind of a crease; at 0.5 a tie counts as convex. [0.5, 1], default 0.7.
    /// Raise it if creases are misjudged; lower it if noisy creases are not sharpened.
    double crease_agreement = 0.7;

    /// Largest residual and plane difference at which a crease decides. [0, 100] sigma, default 4. Raise it if creases
    /// of noisy faces stay frayed; lower it if pixels far from both faces change sides.
    double crease_range = 4.0;

    /// Residual that a crease may cost a pixel. [0, 100] sigma, default 1.5. Raise it if creases stay frayed; lower it
    /// if pixels land on the wrong face.
    double crease_slack = 1.5;
  };

  /// S7: what counts as a plane.
  struct Evidence {
    /// Planes with fewer are rejected, whatever their residuals. [0, 1e6] independent samples, default 2. Raise it if
    /// blotches of the error are reported as planes; lower it if small faces are missing.
    double min_samples = 2.0;

    /// Largest mean squared residual of a plane. (0, 1e6] sigma^2, default 4. Raise it if real surfaces are rejected
    /// because the sensor model is too narrow; lower it if curved and cluttered regions are reported.
    double max_chi2 = 4.0;

    /// Samples that a plane needs, times max(0.5, chi^2). [0, 1e6] independent samples, default 11. Raise it if pieces
    /// of clutter are reported; lower it if small faces are missing.
    double min_evidence = 11.0;

    /// The least that a plane rougher than the sensor, chi^2 > 1, needs. [0, 1e6] independent samples, default 20.
    /// Raise it if pieces of chairs and plants are reported; lower it if small rough faces are missing.
    double rough_evidence = 20.0;

    /// Surfaces that bend with a smaller radius are not planes. [0, 1e6] m, default 0.4. Raise it if facets of columns
    /// and cushions are reported; lower it if slightly bent boards are missing.
    double min_radius = 0.4;

    /// Share of the squared residuals that bending must explain before a region is rejected for it. [0, 1], default
    /// 0.6. Raise it if bent boards are missing; lower it if facets of curved things are reported.
    double bending_share = 0.6;

    /// Reduction of the squared residuals, in sigma^2 per independent sample, that bending must be worth. [0, 1e6]
    /// independent samples, default 5. Raise it if planes are rejected for the bending of the sensor; lower it if
    /// facets of curved things are reported.
    double bending_evidence = 5.0;
  };

  /// The expert fields.
  struct Expert {
    Lines lines;            ///< S1
    Planes planes;          ///< S2, S3
    Merging merging;        ///< S4, S6, S8
    Refinement refinement;  ///< S5
    Evidence evidence;      ///< S7
  };
  Expert expert;  ///< the defaults serve every sensor that was measured
};

}  // namespace epcc
