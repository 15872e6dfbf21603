// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the segmentation, by stage. Equation numbers are those of the paper (Sensors 2021, 21, 4395).
#pragma once

#include <string>

namespace epcc {

/// Which lines of the image are the scan lines (Sec. 7.2).
enum class ScanDirection {
  Columns,
  Rows,
  Both  ///< default mode only: lines in both directions, a pixel takes the larger of its two planes
};

/// The two forms of the method.
enum class Mode {
  Default,  ///< inverse depth, made for the correlated error of real sensors
  Paper     ///< metric sections, Algorithms 1 and 2 as published
};

/// The variances that make up the acceptance criterion of Algorithm 2 (Table 2).
enum class PlaneCriterion {
  PrototypeSensorSegment,  ///< (a) sigma_j^2 + sigma_z^2 + sigma_seg^2
  PrototypeSensor,         ///< (b) sigma_j^2 + sigma_z^2
  PrototypeSegment,        ///< (c) sigma_j^2 + sigma_seg^2
  Prototype                ///< (d) sigma_j^2
};

/// Algorithm 1: samples of one scan line -> line segments.
struct LineClusteringParameters {
  /// l: samples that fit the candidate of a new segment. [2, 100]
  int fit_samples = 3;
  /// l_v: later samples that must agree with the candidate; k_min = l + l_v. [1, 100]
  int validation_samples = 5;
  /// n_buf: rejected samples kept for a new segment, >= k_min (Fig. 12). [k_min, 1000]
  int buffer_samples = 16;
  /// k_max of Eq. 20: a sample belongs to the segment if d^2 <= k_max^2 (sigma^2 + s^2). (0, 100]
  double k_max = 2.0;
  /// Smallest share of sigma_z^2 that counts across a grazing line (q^2 floor of Eq. 20). [0, 1]
  double projection_floor = 0.1;
  /// Use sigma_z in Eq. 20. Off only to study what the noise model is worth (Fig. 15).
  bool use_sensor_noise = true;

  int minimumSamples() const { return fit_samples + validation_samples; }
  std::string validate() const;
};

/// Algorithm 2: line segments of neighbouring scan lines -> planes.
struct PlaneClusteringParameters {
  /// k_max of Eq. 23: a segment belongs to the plane if its cost is below k_max^2. (0, 100]
  double k_max = 3.0;
  /// d_1 of Eq. 27, metres: gap between neighbouring segments allowed beyond the noise. [0, 100]
  double max_gap = 0.15;
  /// Scan lines to look back for a labelled neighbour. [1, 100]
  int look_back = 4;
  /// Scan lines to look back for an unlabelled partner of a new plane; older ones are outliers. [1, look_back]
  int pair_look_back = 2;
  /// Largest angle between the two segments that start a plane, degrees. (0, 90]
  double max_start_angle = 20.0;
  /// Planes with fewer segments are dropped (15 segments are the paper's 30 endpoints). [1, 1e6]
  int min_segments = 15;
  /// Planes with fewer pixels are dropped. [0, 1e9]
  int min_points = 0;
  /// Form of the criterion (Table 2).
  PlaneCriterion criterion = PlaneCriterion::PrototypeSensorSegment;

  std::string validate() const;
};

/// S1: samples of one scan line -> line segments in inverse depth (default mode).
struct LineGrowingParameters {
  /// A sample belongs to the line within k_max sigma_w. (0, 100]
  double k_max = 1.5;
  /// Rejected samples in a row that may start a new line. [3, 100]
  int min_samples = 6;
  /// A line ends after more missing or rejected pixels than this. [0, 1000]
  int max_gap_pixels = 5;
  std::string validate() const;
};

/// S2: line segments of neighbouring scan lines -> planes in inverse depth (default mode).
struct PlaneGrowingParameters {
  /// A segment joins a plane if T < k_max^2. (0, 100]
  double k_max = 2.0;
  /// Neighbouring segments overlap by at least so many pixels, and by half of the shorter. [1, 1000]
  int min_overlap_pixels = 3;
  /// Largest prediction variance of plane and line, in units of sigma_w^2. [0, 1e6]
  double max_prediction = 9.0;
  /// Planes smaller than this never reach the merge. [1, 1e6]
  int min_points = 40;
  int min_segments = 2;
  std::string validate() const;
};

/// S4 and S8: merging of neighbouring regions and of those on both sides of an occluder (default mode).
struct MergingParameters {
  /// c1: tolerance for fragments, in independent samples. [0, 1e6]
  double fragment_tolerance = 60.0;
  /// c2: offset in sigma within which large faces are one surface. [0, 100]
  double offset_tolerance = 1.5;
  /// Largest step along the common border, rms in sigma across the surface. (0, 1e6]
  double max_step = 6.0;
  /// A border is ragged if it has more contacts than this times 4 sqrt(n) of the smaller region (1 is the border of
  /// a square); then the offset tolerance grows in proportion ... (0, 1e6]
  double ragged_border = 1.5;
  /// ... up to this factor ... [1, 100]
  double max_ragged_gain = 2.0;
  /// ... where the step along the border, rms in sigma, is smaller than this. [0, 1e6]
  double max_ragged_step = 1.75;
  /// Regions are neighbours across a hole as wide as so many independent samples of a line, ... [0, 1000]
  double bridge_samples = 1.0;
  /// ... or of so many pixels: drop-outs, dark spots ... [0, 1000]
  int min_bridge_pixels = 15;
  /// ... in at least so many places. [1, 1e6]
  int min_contacts = 3;
  /// Regions with fewer independent samples are dropped. [0, 1e6]
  double min_samples = 3.0;
  /// Regions on both sides of something nearer are neighbours, in S8, if it takes up no more of a row or column than
  /// this times what is seen of the two; 0 keeps them apart. [0, 100]
  double max_occluder = 0.4;
  std::string validate() const;
};

/// S5: refinement of the borders (default mode). Residuals in sigma across the surface.
struct RefinementParameters {
  int passes = 12;
  /// An unlabelled pixel joins a region within this residual; what lies farther behind or in front of the regions on
  /// both sides of it is a groove (S4) or an occluder (S8). (0, 100]
  double max_residual = 3.0;
  /// A labelled pixel changes sides for a gain of this much. [0, 100]
  double flip_gain = 0.3;
  /// Passes in which creases are decided by geometry.
  int crease_passes = 6;
  /// Distance from the border at which the crease's kind is voted, pixels. [1, 100]
  int crease_vote_pixels = 6;
  int crease_min_votes = 5;
  double crease_agreement = 0.7;
  /// Largest residuals and plane difference at which a crease decides.
  double crease_range = 4.0;
  /// A crease may cost a pixel this much residual.
  double crease_slack = 1.5;
  std::string validate() const;
};

/// S7: what counts as a plane (default mode).
struct EvidenceParameters {
  /// Planes with fewer pixels are rejected. [1, 1e9]
  int min_points = 60;
  /// Smallest number of independent samples. [0, 1e6]
  double min_samples = 2.0;
  /// Largest mean squared residual in sigma^2 across the surface. (0, 1e6]
  double max_chi2 = 4.0;
  /// Independent samples a region needs, times max(0.5, chi^2). [0, 1e6]
  double min_evidence = 11.0;
  /// The least if the region is rougher than the sensor, chi^2 > 1: pieces of clutter often are. [0, 1e6]
  double rough_evidence = 20.0;
  /// Surfaces that bend with a smaller radius are not planes, metres ... [0, 1e6]
  double min_radius = 0.4;
  /// ... if bending explains at least this share of the squared residuals ... [0, 1]
  double bending_share = 0.6;
  /// ... and is worth this many independent samples. [0, 1e6]
  double bending_evidence = 5.0;
  std::string validate() const;
};

/// Everything that steers a segmentation, but for the sensor model.
struct Parameters {
  Mode mode = Mode::Default;
  /// Spherical scans have planar columns only: Both means Columns there.
  ScanDirection scan = ScanDirection::Both;
  // Paper mode.
  LineClusteringParameters line;
  PlaneClusteringParameters plane;
  // Default mode.
  LineGrowingParameters line_growing;
  PlaneGrowingParameters plane_growing;
  MergingParameters merging;
  RefinementParameters refinement;
  EvidenceParameters evidence;
  /// Threads for the scan lines (default mode: one a scan direction); the result does not depend on it. [1, 256]
  int threads = 1;

  /// The paper's: its mode, columns, k_max = 2 and 3, d_1 = 15 cm.
  static Parameters paper() {
    Parameters parameters;
    parameters.mode = Mode::Paper;
    parameters.scan = ScanDirection::Columns;
    return parameters;
  }
  /// Empty if every value is in its range, else the first thing that is wrong, in words.
  std::string validate() const;
};

}  // namespace epcc
