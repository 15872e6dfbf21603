// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the paper mode: Algorithms 1 and 2 (Sensors 2021, 21, 4395; equation numbers are the paper's).
#pragma once

namespace epcc {

/// The variances that make up the acceptance criterion of Algorithm 2 (Table 2).
enum class PlaneCriterion {
  PrototypeSensorSegment,  ///< (a) sigma_j^2 + sigma_z^2 + sigma_seg^2
  PrototypeSensor,         ///< (b) sigma_j^2 + sigma_z^2
  PrototypeSegment,        ///< (c) sigma_j^2 + sigma_seg^2
  Prototype                ///< (d) sigma_j^2
};

/// How much an end point counts in the covariance of its plane (Eq. 26). d is its distance from the plane before it is
/// added, mu the running mean of these distances (mu_jd), at least 1e-6 m.
enum class EndpointWeight {
  Printed,      ///< exp(-d^2/mu^2), as printed
  Exponential,  ///< exp(-d/mu)
  Gaussian,     ///< exp(-d^2/(2 mu^2))
  Cauchy,       ///< 1/(1 + d^2/mu^2)
  Huber,        ///< min(1, mu/d)
  None          ///< 1
};

/// Parameters of Mode::Paper, the algorithm as published; defaults are those of Table 3.
struct PaperParameters {
  /// k_max of Eq. 20: a sample belongs to the line segment if d^2 <= k_max^2 (sigma^2 + s^2). (0, 100] sigma, default
  /// 2. Raise it if scan lines break into short segments; lower it if segments bend around edges.
  double line_k_max = 2.0;

  /// k_max of Eq. 23: a line segment belongs to the plane if its cost is below k_max^2. (0, 100] sigma, default 3.
  /// Raise it if surfaces are over-segmented; lower it if neighbouring faces join (under-segmentation).
  double plane_k_max = 3.0;

  /// d_1 of Eq. 27: gap between neighbouring segments of a plane, beyond the noise. [0, 100] m, default 0.15. Raise it
  /// if holes cut surfaces; lower it if separate objects at the same depth join.
  double max_gap = 0.15;

  /// Planes with fewer line segments are dropped (min_c of Sec. 7.1: 15 segments are the 30 end points). [1, 1e6]
  /// segments, default 15. Raise it if clutter is reported; lower it if narrow surfaces are missing.
  int min_segments = 15;

  /// Planes with fewer pixels are dropped. [0, 1e9] pixels, default 0. Raise it if specks are reported; lower it if
  /// small surfaces are missing.
  int min_points = 0;

  /// Form of the criterion (Table 2). a | b | c | d, default a. Choose b if segments are short and noisy, c or d only
  /// to study what the noise model is worth.
  PlaneCriterion criterion = PlaneCriterion::PrototypeSensorSegment;

  /// Weight of an end point in the covariance of its plane (Eq. 26). printed | exponential | gaussian | cauchy | huber
  /// | none, default printed. Choose exponential on real depth, whose error is correlated, for fewer strips; cauchy or
  /// huber for fewer still, at the cost of small surfaces; none only to study what the weight is worth.
  EndpointWeight endpoint_weight = EndpointWeight::Printed;

  // Expert fields, by step: the defaults serve every sensor that was measured.

  /// Algorithm 1: samples of one scan line become line segments.
  struct Lines {
    /// l: samples that fit the candidate of a new segment. [2, 100] samples, default 3. Raise it if candidates are
    /// fitted to noise; lower it if short segments are missing.
    int fit_samples = 3;

    /// l_v: later samples that must agree with the candidate; k_min = l + l_v. [1, 100] samples, default 5. Raise it if
    /// candidates start in clutter; lower it if short segments are missing.
    int validation_samples = 5;

    /// n_buf: rejected samples kept for a new segment, at least k_min (Fig. 12). [2, 1000] samples, default 16. Raise
    /// it if outliers push the start of a surface out of the buffer; lower it if time matters: every start in the
    /// buffer is tried.
    int buffer_samples = 16;

    /// Smallest share of sigma_z^2 that counts across a grazing line (floor of q^2 in Eq. 20). [0, 1], default 0.1.
    /// Raise it if floors and side walls break up; lower it if steps on floors and side walls are run over.
    double projection_floor = 0.1;

    /// Use sigma_z in Eq. 20. off | on, default on. Choose off only to study what the noise model is worth (Fig. 15).
    bool use_sensor_noise = true;

    /// k_min: samples that must be buffered before a new segment is looked for.
    int minSamples() const { return fit_samples + validation_samples; }
  };

  /// Algorithm 2: line segments of neighbouring scan lines become planes.
  struct Planes {
    /// Scan lines to look back for a segment that has a plane. [1, 100] scan lines, default 4. Raise it if scan lines
    /// without a segment end surfaces; lower it if separate surfaces join across a gap.
    int look_back = 4;

    /// Scan lines to look back for a partner that starts a plane, at most look_back; older segments are outliers.
    /// [1, 100] scan lines, default 2. Raise it if surfaces start late; lower it if clutter starts planes.
    int pair_look_back = 2;

    /// Largest angle between the two segments that start a plane. (0, 90] degrees, default 20. Raise it if slanted
    /// surfaces start late; lower it if planes start on curved things.
    double max_start_angle = 20.0;
  };

  /// The expert fields.
  struct Expert {
    Lines lines;    ///< Algorithm 1
    Planes planes;  ///< Algorithm 2
  };
  Expert expert;  ///< the defaults serve every sensor that was measured
};

}  // namespace epcc
