// SPDX-License-Identifier: BSD-3-Clause
// What epcc_view is showing, and how keys change it; nothing here draws.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/files/labelled_frame.h"
#include "epcc_segmentation/plane_extractor.h"
#include "eval/segment/plane_report.h"
#include "eval/segment/segment_input.h"
#include "eval/segment/segment_options.h"
#include "eval/view/parameter_dial.h"
#include "eval/view/view_camera.h"
#include "eval/view/view_keys.h"
#include "eval/view/view_scene.h"

namespace epcc {

/// What has to be done after a key.
struct ViewChange {
  bool redraw = false;  ///< scene and texts
  bool look = false;    ///< from place() anew
  bool quit = false;
};

/// One input at a time, segmented as the person at the keys wants it.
class ViewSession {
 public:
  /// `inputs` are those of listInputs(), at least one. Reads and segments the first.
  ViewSession(const SegmentOptions& options, std::vector<SegmentInput> inputs, const ViewStyle& style = firstStyle());

  /// Does what a key asks for: reads and segments what that needs. Nothing is thrown but std::bad_alloc.
  ViewChange press(ViewCommand command);
  /// Selects a plane, or none for 0.
  ViewChange select(std::int32_t label);

  /// What is to be drawn; empty where the input cannot be used.
  ViewScene scene() const;
  ViewPlace place() const { return place_; }
  double pointSize() const { return point_size_; }
  bool showsTexts() const { return shows_texts_; }
  bool showsHelp() const { return shows_help_; }

  const SegmentInput& input() const { return inputs_[index_]; }
  std::size_t index() const { return index_; }
  std::size_t size() const { return inputs_.size(); }
  /// Why the input could not be read or segmented, in one line; empty if it was.
  const std::string& problem() const { return problem_; }
  /// What makes the planes doubtful, in one line; empty if nothing does.
  std::string doubt() const { return result_.doubts.any() ? result_.doubts.inWords() : std::string(); }
  /// Why there are no polygons or no mesh, though they were asked for, in one line; empty if nothing is amiss.
  const std::string& notice() const { return notice_; }
  /// Polygons and mesh of the planes; empty unless they are drawn.
  const FrameSurfaces& surfaces() const { return surfaces_; }
  const PlaneSegmentation& result() const { return result_; }
  const std::vector<PlaneSummary>& summaries() const { return summaries_; }
  const ViewStyle& style() const { return style_; }
  const Parameters& parameters() const { return parameters_; }
  /// The parameters that keys change, and which of them is the next to change.
  const std::vector<const ParameterField*>& fields() const { return fields_; }
  std::size_t field() const { return field_; }
  /// The sensor model's name in reports, and the seconds of the segmentation.
  const std::string& sensorName() const { return sensor_name_; }
  double seconds() const { return seconds_; }

 private:
  ViewChange go(std::size_t index);
  ViewChange changeSensor(int by);
  ViewChange changeMode();
  ViewChange changeField(int direction);
  ViewChange choosePlane(int by);
  ViewChange resegmented();
  ViewChange nextSurface();
  ViewChange switchOutlineKind();
  bool surfacesAreMissing();
  ViewChange obey(ViewCommand command);
  void findSurfaces();
  void load();
  void segment();
  void attempt(void (ViewSession::*step)());
  void useMode(Mode mode);

  SegmentOptions options_;
  std::vector<SegmentInput> inputs_;
  std::size_t index_ = 0;
  std::vector<std::string> sensors_;  // as --noise takes them; the first as given
  std::size_t sensor_ = 0;
  Parameters parameters_;
  std::vector<const ParameterField*> fields_;
  std::size_t field_ = 0;
  ViewStyle style_;
  ViewPlace place_ = ViewPlace::Sensor;
  double point_size_ = 2.0;
  bool shows_texts_ = true;
  bool shows_help_ = false;

  std::optional<LabelledFrame> frame_;
  PlaneExtractor extractor_;
  PlaneSegmentation result_;
  std::vector<PlaneSummary> summaries_;
  FrameSurfaces surfaces_;
  bool has_surfaces_ = false;  // of this result
  std::string problem_;
  std::string notice_;
  std::string sensor_name_;
  double seconds_ = 0.0;
};

}  // namespace epcc
