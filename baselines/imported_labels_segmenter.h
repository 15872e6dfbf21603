// SPDX-License-Identifier: BSD-3-Clause
// Label images that another program wrote, as one more method of the comparison.
#pragma once

#include "baselines/plane_segmenter.h"

namespace epcc {

/// Reads FOLDER/NAME_labels.png for the frame called NAME: 16-bit grey, the frame's size, 0 = no plane, 1..65534 =
/// plane, 65535 = ignore, which counts as no plane. Ids may have gaps. segment() fails where the file is missing,
/// damaged, of another size or kind. seconds() is the time of reading: the method's own is not in the file.
class ImportedLabelsSegmenter : public PlaneSegmenter {
 public:
  ImportedLabelsSegmenter(const std::string& method_name, const std::string& folder)
      : method_name_(method_name), folder_(folder) {}
  std::string name() const override { return method_name_; }

 protected:
  bool run(const SegmenterInput& input, PlaneSegmentation& result) override;

 private:
  std::string method_name_;
  std::string folder_;
};

}  // namespace epcc
