// SPDX-License-Identifier: BSD-3-Clause
// The one interface of every plane segmentation method that the evaluation compares.
#pragma once

#include <cstdint>
#include <string>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// What a method is given: one frame.
struct SegmenterInput {
  DepthFrame frame;    ///< Pinhole depth image or organized cloud; its data must outlive the call.
  SensorModel sensor;  ///< Noise of the frame. EPCC uses it to segment, the others only to weight the final planes.
  std::string name;    ///< Name of the frame, for labels imported from files; may be empty elsewhere.
  bool sensor_is_measured = false;  ///< On this frame: EPCC takes it as it is, whatever its parameters say (S0).
};

/// A method that segments frames into planes.
///
/// What holds for every method:
/// - labels are row-major, 0 no plane, k the plane planes[k - 1], largest plane first; a pixel without a
///   measurement has no label; planes are the core's weighted least squares through their pixels, with the
///   unit normal towards the sensor (d >= 0), whatever model the method itself found;
/// - the same input gives the same result, on the same object and on another;
/// - a frame without a measurement, or with a single row or column, has no planes and is no error;
/// - nothing is thrown and PCL prints nothing.
/// An object serves one thread at a time; different objects may run in different threads.
class PlaneSegmenter {
 public:
  virtual ~PlaneSegmenter() = default;

  /// Short name as on the command line, for example "region-growing".
  virtual std::string name() const = 0;

  /// Segments a frame. True on success; otherwise the result is empty (all labels 0, no planes) and error()
  /// says why in words.
  bool segment(const SegmenterInput& input, PlaneSegmentation& result);

  /// Why the last segment() failed; empty after a success.
  const std::string& error() const { return error_; }

  /// Wall-clock seconds of the method itself in the last segment(), > 0: filtering, normals, search trees, and
  /// bringing the labels back to the pixels included. Left out is what is no part of a PCL method: the conversion
  /// of the frame to a PCL cloud (conversionSeconds()) and the least-squares planes of the result (fitSeconds());
  /// EPCC, which does both itself, is charged for them.
  ///
  /// PCL's part of the time belongs to Debian's PCL, built for plain x86-64. RANSAC runs 6 to 17 times faster in a
  /// PCL built with -O3 -march=native -DPCL_NO_PRECOMPILE, the other methods gain little.
  double seconds() const { return seconds_; }
  /// Seconds spent on the PCL cloud, not part of seconds().
  double conversionSeconds() const { return conversion_seconds_; }
  /// Seconds spent on the planes of the result, not part of seconds().
  double fitSeconds() const { return fit_seconds_; }

 protected:
  /// Does the work on a frame with at least two rows and columns; `result` comes with its size and all labels 0.
  /// Methods that only label finish with fitLabels(). False after fail().
  virtual bool run(const SegmenterInput& input, PlaneSegmentation& result) = 0;

  /// Notes the error and returns false.
  bool fail(const std::string& message);
  /// Clears labels without a measurement and fills the planes from the labels 1..label_count.
  void fitLabels(const SegmenterInput& input, std::int32_t label_count, PlaneSegmentation& result);
  /// Runs a conversion outside the method's time and returns its value.
  template <typename Conversion>
  auto convert(const Conversion& conversion) {
    const double start = now();
    auto converted = conversion();
    conversion_seconds_ += now() - start;
    return converted;
  }

 private:
  static double now();
  bool runGuarded(const SegmenterInput& input, PlaneSegmentation& result);

  std::string error_;
  double seconds_ = 0.0;
  double conversion_seconds_ = 0.0;
  double fit_seconds_ = 0.0;
};

}  // namespace epcc
