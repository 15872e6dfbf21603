// SPDX-License-Identifier: BSD-3-Clause
// The whole pipeline of the paper's Figure 2 without PCL: depth frame in, labels and planes out.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/known_planes.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "epcc_segmentation/status.h"

namespace epcc {

struct ErrorCorrelation;  // internal: how far the sensor's error is alike

/// Wall-clock seconds of the last extraction, by stage.
struct StageTimes {
  double read = 0.0;     ///< depth -> inverse depth (inverse-depth mode, or where the sensor was measured)
  double sensor = 0.0;   ///< the sensor measured on the frame, where no model was given
  double lines = 0.0;    ///< scan lines -> line segments (Algorithm 1, S1)
  double planes = 0.0;   ///< line segments -> planes (Algorithm 2, S2)
  double regions = 0.0;  ///< join, merge, refine, reject (S3 to S8, inverse-depth mode)
  double result = 0.0;   ///< labels, least-squares planes, line segments if asked for
  /// The sum of all stages, seconds.
  double total() const noexcept { return read + sensor + lines + planes + regions + result; }
};

/// Segments frames into planes. Keeps its memory from frame to frame, also when parameters or sensor change; not for
/// use from two threads at once.
///
///     epcc::PlaneExtractor extractor;  // the sensor is measured on the frames
///     epcc::PlaneSegmentation result;
///     if (!extractor.extract(frame, result)) std::cerr << extractor.error() << '\n';
class EPCC_CORE_EXPORT PlaneExtractor {
 public:
  /// Without a sensor model it is measured, see setSensorAuto().
  explicit PlaneExtractor(const Parameters& parameters = Parameters(),
                          const std::optional<SensorModel>& sensor = std::nullopt);
  ~PlaneExtractor();
  /// Takes over settings and memory; the other is not for use afterwards.
  PlaneExtractor(PlaneExtractor&&) noexcept;
  /// Takes over settings and memory; the other is not for use afterwards.
  PlaneExtractor& operator=(PlaneExtractor&&) noexcept;

  /// Parameters of the frames to come. What is out of range shows in extract().
  void setParameters(const Parameters& parameters);
  /// The sensor model of the frames to come: nothing is measured, but its size may be adapted
  /// (InverseDepthParameters::adapt_sensor). What is out of range shows in extract().
  void setSensor(const SensorModel& sensor);
  /// The sensor model is measured on the frames and settles over a stream of them; then each measures a quarter of the
  /// blocks (SensorEstimator). So do the covariances, in which its slow bending is: of one frame, segmented twice, they
  /// may differ. Starts afresh.
  void setSensorAuto();

  /// Segments one frame. Returns true on success; otherwise the result has no planes (all labels 0, or no labels if
  /// memory ran out) and status() and error() say why: invalid parameters or sensor model, an unusable frame, a cloud
  /// whose geometry is unknown, a row scan of a spherical scan, no memory. Planes and segments are in the frame of the
  /// cloud that was given. A frame without a single valid pixel is no error. Nothing is thrown.
  bool extract(const DepthFrame& frame, PlaneSegmentation& result);

  /// The same where planes of an earlier frame are known, KnownPlanes. Of depth images and clouds of a camera in its
  /// own frame in the inverse-depth mode; for others, or views whose size or numbers do not fit, it is as if nothing
  /// were known.
  bool extract(const DepthFrame& frame, const KnownPlanes& known, PlaneSegmentation& result,
               Continuation& continuation);

  /// How the last extract() ended.
  Status status() const noexcept { return status_; }
  /// What was wrong, in words; empty if nothing was.
  const std::string& error() const noexcept { return error_; }
  /// How long the last extract() took, stage by stage.
  const StageTimes& times() const noexcept { return times_; }
  /// The parameters that were set.
  const Parameters& parameters() const { return parameters_; }
  /// The model that the last frame was segmented with: measured, or the given one as S0 adapted it
  /// (InverseDepthParameters::adapt_sensor). Before the first frame what was given.
  const SensorModel& sensor() const noexcept { return sensor_; }
  /// Whether the sensor is measured on the frames: no model was given.
  bool measuresSensor() const noexcept { return measures_sensor_; }

 private:
  struct Workspace;
  bool fail(Status status, const std::string& error, PlaneSegmentation& result);
  bool check(const DepthFrame& frame, PlaneSegmentation& result);
  void extractInSensorFrame(const DepthFrame& frame, PlaneSegmentation& result);
  int extractMetric(const DepthFrame& frame, PlaneSegmentation& result);
  int extractInverseDepth(const DepthFrame& frame, PlaneSegmentation& result);
  void adaptSensor(const InverseDepthImage& image, Doubts& doubts);
  void measureSensor(const DepthFrame& frame, Doubts& doubts);
  void listSegments(const DepthFrame& frame, const ErrorCorrelation& error, PlaneSegmentation& result) const;

  Parameters parameters_;
  SensorModel given_sensor_;
  SensorModel sensor_;  // of the last frame
  bool measures_sensor_;
  Status status_ = Status::Ok;
  std::string error_;
  StageTimes times_;
  const KnownPlanes* known_ = nullptr;  // of the extraction that is going on
  Continuation* continuation_ = nullptr;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace epcc
