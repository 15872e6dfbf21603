// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the segmentation, by stage. Equation numbers are those of the paper (Sensors 2021, 21, 4395).
#pragma once

#include <string>

namespace epcc {

/// Which lines of the image are the scan lines (Sec. 7.2).
enum class ScanDirection { Columns, Rows };

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

/// Everything that steers a segmentation, but for the sensor model.
struct Parameters {
  ScanDirection scan = ScanDirection::Columns;
  LineClusteringParameters line;
  PlaneClusteringParameters plane;
  /// Threads for the scan lines; the result does not depend on it. [1, 256]
  int threads = 1;

  /// Empty if every value is in its range, else the first thing that is wrong, in words.
  std::string validate() const;
};

}  // namespace epcc
