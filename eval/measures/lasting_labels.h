// SPDX-License-Identifier: BSD-3-Clause
// Whether a surface keeps its label over time, and whether the squared errors of a tracker are what it says.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "eval/measures/repeatability.h"

namespace epcc {

/// A frame with lasting labels, as the measures need it.
struct LastingRegions {
  LabelImage labels;         ///< lasting; 0 none
  std::map<int, bool> flat;  ///< by label that occurs: whether its largest plane is flat (SeenRegions::flat)
};

/// Regions of single planes with the lasting label of each plane, 0 for those that have none yet.
LastingRegions lastingRegions(const SeenRegions& regions, const std::vector<std::int32_t>& label_of_plane);

/// Repeatability with equal labels: as struct Repeatability, but a region is repeated only if its partner has the same
/// label.
struct LastingRepeatability {
  long pairs = 0;            ///< of frames
  long shared = 0;           ///< pixels of the first frame that the second shows too
  long repeated_pixels = 0;  ///< of these, in repeated regions of the first frame
  long regions = 0;          ///< flat regions of the first frame with at least 200 shared pixels
  long repeated = 0;  ///< of these, sharing 80 % of their shared pixels with a flat one of the same label, in turn

  LastingRepeatability& operator+=(const LastingRepeatability& other);
};

/// One pair; `shared` is sharedPixels().
LastingRepeatability lastingRepeatability(const std::vector<std::int32_t>& shared, const LastingRegions& from,
                                          const LastingRegions& to);

/// How often surfaces change their label.
struct LabelSwitches {
  long switches = 0;
  double seconds = 0.0;  ///< summed over the surfaces: how long each was watched

  /// Switches a surface and minute; 0 if nothing was watched.
  double perMinute() const { return seconds > 0.0 ? 60.0 * static_cast<double>(switches) / seconds : 0.0; }
};

/// Counts switches against the truth. In each frame a surface has the label that holds most of its pixels, the smallest
/// of equal ones; frames in which it has fewer than 200 pixels, or most of them have no label, do not count. A switch
/// is a label other than that of the last frame that counted; the time between those two frames was watched.
class SwitchCounter {
 public:
  /// `truth` has the same numbers for the same surfaces in every frame, 0 and 65535 are none.
  void add(const LabelImage& truth, const LabelImage& labels, double time);
  const LabelSwitches& result() const { return result_; }

 private:
  struct Last {
    int label = 0;
    double time = 0.0;
  };
  std::map<int, Last> last_;
  LabelSwitches result_;
};

/// The same without truth, of one pair of frames some time apart: each of the five labels with the most shared pixels
/// in the first frame, at least 200, stands for a surface; it has switched if another label holds most of those pixels
/// in the second. Where most of them have no label there nothing was watched, else `seconds` were.
LabelSwitches labelSwitches(const std::vector<std::int32_t>& shared, const LastingRegions& from,
                            const LastingRegions& to, double seconds);

/// Normalised squared errors of planes, three degrees of freedom: 3 on average and 95 % below 7.81 if the covariances
/// are right. Memory does not grow with their number.
class SquaredErrors {
 public:
  void add(double squared_error);
  long size() const { return values_.size(); }
  double mean() const;              ///< 0 for none
  double median() const;            ///< 0 for none, to a thousandth
  double shareWithinLimit() const;  ///< of those up to the 95 % quantile of chi^2

 private:
  ValueCounts values_;  // thousandths
  double sum_ = 0.0;
  long within_ = 0;
};

}  // namespace epcc
