// SPDX-License-Identifier: BSD-3-Clause
// The lists are in the order of the columns; a new number is a line here.
#include "eval/measures/measure_fields.h"

namespace epcc {

namespace {

template <auto Part, auto Number>
MeasureField field(const char* name) {
  return {name, [](FrameMeasures& m) -> long& { return (m.*Part).*Number; },
          [](const FrameMeasures& m) { return (m.*Part).*Number; }};
}

constexpr auto kPaper = &FrameMeasures::paper;
constexpr auto kSegcomp = &FrameMeasures::segcomp;
constexpr auto kInstances = &FrameMeasures::instances;
constexpr auto kPlanes = &FrameMeasures::planes;

}  // namespace

const std::vector<MeasureField>& countFields() {
  static const std::vector<MeasureField> fields = {
      field<kPaper, &PaperMeasures::surfaces>("N"),         field<kPaper, &PaperMeasures::clusters>("IC"),
      field<kPaper, &PaperMeasures::detected>("D"),         field<kPaper, &PaperMeasures::over_segmented>("No"),
      field<kPaper, &PaperMeasures::under_segmented>("Nu"), field<kSegcomp, &SegcompMeasures::correct>("correct"),
      field<kSegcomp, &SegcompMeasures::over>("over"),      field<kSegcomp, &SegcompMeasures::under>("under"),
      field<kSegcomp, &SegcompMeasures::missed>("missed"),  field<kSegcomp, &SegcompMeasures::noise>("noise")};
  return fields;
}

const std::vector<MeasureField>& furtherFields() {
  static const std::vector<MeasureField> fields = {
      field<kInstances, &InstanceMeasures::matched>("matched"),
      field<kInstances, &InstanceMeasures::iou_millionths>("iou_sum_millionths"),
      field<kInstances, &InstanceMeasures::dice_millionths>("dice_sum_millionths"),
      field<kInstances, &InstanceMeasures::plane_pixels>("plane_pixels"),
      field<kInstances, &InstanceMeasures::dominated_pixels>("dominated_pixels"),
      field<kPlanes, &PlaneErrorSums::planes>("compared_planes"),
      field<kPlanes, &PlaneErrorSums::microdegrees>("normal_error_sum_microdegrees"),
      field<kPlanes, &PlaneErrorSums::micrometres>("offset_error_sum_micrometres")};
  return fields;
}

}  // namespace epcc
