// SPDX-License-Identifier: BSD-3-Clause
// EPCC behind the interface of the comparison.
#pragma once

#include "baselines/plane_segmenter.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_extractor.h"

namespace epcc {

/// Where EpccSegmenter takes the sensor model from.
enum class SensorChoice {
  Given,            ///< SegmenterInput::sensor
  Measured,         ///< estimateSensor() of the frame at hand; its time counts
  MeasuredOnStream  ///< of the frames so far, which come in order; the result depends on them
};

/// PlaneExtractor as a PlaneSegmenter: "epcc" in Mode::InverseDepth, "epcc-paper" in Mode::Paper, with "-auto" behind
/// it where the sensor is measured. Memory is kept from frame to frame.
class EpccSegmenter : public PlaneSegmenter {
 public:
  explicit EpccSegmenter(const Parameters& parameters, SensorChoice sensor = SensorChoice::Given)
      : parameters_(parameters), sensor_(sensor), extractor_(parameters) {}
  std::string name() const override {
    return std::string(extractor_.parameters().mode == Mode::Paper ? "epcc-paper" : "epcc") +
           (sensor_ == SensorChoice::Given ? "" : "-auto");
  }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override;

 private:
  Parameters parameters_;
  SensorChoice sensor_;
  PlaneExtractor extractor_;
};

}  // namespace epcc
