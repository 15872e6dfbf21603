// SPDX-License-Identifier: BSD-3-Clause
// EPCC behind the interface of the comparison.
#pragma once

#include <optional>

#include "baselines/plane_segmenter.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_extractor.h"

namespace epcc {

/// PlaneExtractor as a PlaneSegmenter: "epcc" in the default mode, "epcc-paper" in the paper mode. The extractor and
/// its memory are kept from frame to frame as long as the sensor model stays the same.
class EpccSegmenter : public PlaneSegmenter {
 public:
  explicit EpccSegmenter(const Parameters& parameters) : parameters_(parameters) {}
  std::string name() const override { return parameters_.mode == Mode::Paper ? "epcc-paper" : "epcc"; }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override;

 private:
  Parameters parameters_;
  std::optional<PlaneExtractor> extractor_;
};

}  // namespace epcc
