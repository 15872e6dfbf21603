// SPDX-License-Identifier: BSD-3-Clause
// Line segments of scans of a laser range finder: Algorithm 1 with a noise model of the range.
#pragma once

#include <string>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/laser_scan.h"
#include "epcc_segmentation/sensor_model.h"
#include "epcc_segmentation/status.h"

namespace epcc {

/// What steers the extraction of lines.
struct LaserLineParameters {
  /// Largest error of a point of a line, k_max of Eq. 20, in units of sqrt(own variance of the line + sigma_r^2): 2 is
  /// 2.8 sigma_r where both agree. [0.5, 10], default 2. Raise it if lines break on straight walls; lower it if lines
  /// run round corners.
  double k_max = 2.0;
  /// Fewest points of a line (k_min of Algorithm 1). [5, 1000], default 8. Raise it if clutter or round things give
  /// lines; lower it to keep what few beams hit.
  int min_points = 8;
  /// Longest stretch of a line without points, metres, unless something in front of the line hides it. [0, 1000],
  /// default 0.3. Raise it to close doors; lower it to see small openings. Neighbouring beams may be farther apart.
  double max_gap = 0.3;
  /// Lines that something in front of them cuts in pieces are joined where the pieces agree. off | on, default on.
  /// Choose off to have each visible piece on its own.
  bool join_hidden = true;
  /// The largest stretch that may be hidden, metres. [0, 1000], default 5. Raise it in halls; lower it where several
  /// walls lie in one line.
  double max_hidden = 5.0;

  /// Empty if every value is in its range, else the first thing that is wrong, in words.
  EPCC_CORE_EXPORT std::string validate() const;
};

/// Finds the line segments of one scan after the other.
///
/// A line is 1/r = q . (cos, sin) of the beam's angle, linear in q = (cos alpha, sin alpha)/rho: prototypes of two
/// numbers with additive statistics, exact for errors of the range, all round the sensor. One pass grows lines as
/// Algorithm 1 does: a sample is accepted by Eq. 20 or buffered, and every start in the buffer is tried for a new line.
/// Then corners are put where both lines fit best, and pieces of one wall behind something are joined. Linear in the
/// number of beams.
///
/// The sensor model's sigmaZ(r) is the error of a range r: SensorModel::polynomial(0, b, a) is sigma_r = a + b r, and
/// estimateRangeNoise() measures it on scans. Its correlation length is not used. An object serves one thread at a
/// time.
class EPCC_CORE_EXPORT LaserLineExtractor {
 public:
  /// With the error of a range as the model's sigmaZ(r). What is out of range shows in extract().
  explicit LaserLineExtractor(const SensorModel& noise, const LaserLineParameters& parameters = {});

  /// False if the scan or a parameter cannot be used; `result` is empty then, and status() and error() say why. A scan
  /// without returns gives no lines. Throws nothing.
  bool extract(const LaserScan& scan, LaserLines& result);

  /// How the last extract() ended: Status::InvalidParameters for parameters and noise model.
  Status status() const noexcept { return status_; }
  /// What was wrong, in words; empty if nothing was.
  const std::string& error() const noexcept { return error_; }

 private:
  bool fail(Status status, std::string error);

  SensorModel noise_;
  LaserLineParameters parameters_;
  Status status_ = Status::Ok;
  std::string error_;
};

}  // namespace epcc
