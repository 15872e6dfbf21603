// SPDX-License-Identifier: BSD-3-Clause
// Two lists of names.
#include "eval/measures/measure_fields.h"

namespace epcc {

using M = FrameMeasures;

const std::vector<MeasureField>& countFields() {
  static const std::vector<MeasureField> fields = {{"N", [](M& m) -> long& { return m.paper.surfaces; }},
                                                   {"IC", [](M& m) -> long& { return m.paper.clusters; }},
                                                   {"D", [](M& m) -> long& { return m.paper.detected; }},
                                                   {"No", [](M& m) -> long& { return m.paper.over_segmented; }},
                                                   {"Nu", [](M& m) -> long& { return m.paper.under_segmented; }},
                                                   {"correct", [](M& m) -> long& { return m.segcomp.correct; }},
                                                   {"over", [](M& m) -> long& { return m.segcomp.over; }},
                                                   {"under", [](M& m) -> long& { return m.segcomp.under; }},
                                                   {"missed", [](M& m) -> long& { return m.segcomp.missed; }},
                                                   {"noise", [](M& m) -> long& { return m.segcomp.noise; }}};
  return fields;
}

const std::vector<MeasureField>& furtherFields() {
  static const std::vector<MeasureField> fields = {
      {"matched", [](M& m) -> long& { return m.instances.matched; }},
      {"iou_sum_millionths", [](M& m) -> long& { return m.instances.iou_millionths; }},
      {"dice_sum_millionths", [](M& m) -> long& { return m.instances.dice_millionths; }},
      {"plane_pixels", [](M& m) -> long& { return m.instances.plane_pixels; }},
      {"dominated_pixels", [](M& m) -> long& { return m.instances.dominated_pixels; }},
      {"compared_planes", [](M& m) -> long& { return m.planes.planes; }},
      {"normal_error_sum_microdegrees", [](M& m) -> long& { return m.planes.microdegrees; }},
      {"offset_error_sum_micrometres", [](M& m) -> long& { return m.planes.micrometres; }}};
  return fields;
}

}  // namespace epcc
