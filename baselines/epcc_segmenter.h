// SPDX-License-Identifier: BSD-3-Clause
// EPCC behind the interface of the comparison.
#pragma once

#include <optional>

#include "baselines/plane_segmenter.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_extractor.h"

namespace epcc {

/// Where EpccSegmenter takes the sensor model from.
enum class SensorChoice {
  Given,    ///< SegmenterInput::sensor
  Measured  ///< estimateSensor() of the frame at hand; its time counts
};

/// PlaneExtractor as a PlaneSegmenter: "epcc" in the default mode, "epcc-paper" in the paper mode, with "-auto" behind
/// it where the sensor is measured. The extractor and its memory are kept from frame to frame as long as the sensor
/// model stays the same.
class EpccSegmenter : public PlaneSegmenter {
 public:
  explicit EpccSegmenter(const Parameters& parameters, SensorChoice sensor = SensorChoice::Given)
      : parameters_(parameters), sensor_(sensor) {}
  std::string name() const override {
    return std::string(parameters_.mode == Mode::Paper ? "epcc-paper" : "epcc") +
           (sensor_ == SensorChoice::Measured ? "-auto" : "");
  }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override;

 private:
  Parameters parameters_;
  SensorChoice sensor_;
  std::optional<PlaneExtractor> extractor_;
};

}  // namespace epcc
