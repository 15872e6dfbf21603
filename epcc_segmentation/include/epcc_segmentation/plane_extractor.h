// SPDX-License-Identifier: BSD-3-Clause
// The whole pipeline of the paper's Figure 2 without PCL: depth frame in, labels and planes out.
#pragma once

#include <memory>
#include <string>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// Wall-clock seconds of the last extraction, by stage.
struct StageTimes {
  double read = 0.0;     ///< depth -> inverse depth (default mode)
  double lines = 0.0;    ///< scan lines -> line segments (Algorithm 1, S1)
  double planes = 0.0;   ///< line segments -> planes (Algorithm 2, S2)
  double regions = 0.0;  ///< join, merge, refine, reject (S3 to S7, default mode)
  double result = 0.0;   ///< labels, least-squares planes
  double total() const { return read + lines + planes + regions + result; }
};

/// Segments frames into planes. Keeps its memory between frames; not for use from two threads at once.
class PlaneExtractor {
 public:
  explicit PlaneExtractor(const Parameters& parameters = Parameters(), const SensorModel& sensor = SensorModel());
  ~PlaneExtractor();
  PlaneExtractor(PlaneExtractor&&) noexcept;
  PlaneExtractor& operator=(PlaneExtractor&&) noexcept;

  /// Segments one frame. Returns true on success; otherwise the result is empty (all labels 0)
  /// and error() says why: invalid parameters or sensor model, an empty frame, a row scan of a
  /// spherical scan. A frame without a single valid pixel is no error: it has no planes.
  bool extract(const DepthFrame& frame, PlaneSegmentation& result);

  const std::string& error() const { return error_; }
  const StageTimes& times() const { return times_; }
  const Parameters& parameters() const { return parameters_; }
  const SensorModel& sensor() const { return sensor_; }

 private:
  struct Workspace;
  void prepare(const DepthFrame& frame, PlaneSegmentation& result);
  int extractMetric(const DepthFrame& frame, PlaneSegmentation& result);
  int extractInverseDepth(const DepthFrame& frame, PlaneSegmentation& result);

  Parameters parameters_;
  SensorModel sensor_;
  std::string error_;
  StageTimes times_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace epcc
