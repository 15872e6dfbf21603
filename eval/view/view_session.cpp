// SPDX-License-Identifier: BSD-3-Clause
// Keys move through inputs, sensors, parameters and planes; what follows from a move is read or segmented anew.
#include "eval/view/view_session.h"

#include <algorithm>
#include <utility>

#include "eval/segment/frame_planes.h"

namespace epcc {
namespace {

constexpr ViewChange kNothing{};
constexpr ViewChange kRedraw{true, false, false};
constexpr double kSmallestPoint = 1.0, kLargestPoint = 12.0;  // pixels

/// `by` steps on in a ring.
std::size_t around(std::size_t index, int by, std::size_t count) {
  const auto size = static_cast<int>(count);
  return static_cast<std::size_t>((static_cast<int>(index) + by + size) % size);
}

/// --noise as given first, then those that it is worth to compare with.
std::vector<std::string> sensorChoices(const std::string& given) {
  std::vector<std::string> choices{given};
  if (given != "auto") choices.emplace_back("auto");
  for (const std::string& name : SensorModel::presetNames())
    if (name != given) choices.push_back(name);
  return choices;
}

}  // namespace

ViewSession::ViewSession(const SegmentOptions& options, std::vector<SegmentInput> inputs, const ViewStyle& style)
    : options_(options),
      inputs_(std::move(inputs)),
      sensors_(sensorChoices(options.noise)),
      parameters_(options.parameters),
      style_(style) {
  useMode(parameters_.mode);
  attempt(&ViewSession::load);
  findSurfaces();
  const ViewScene first = scene();
  place_ = firstPlace(first);
}

ViewChange ViewSession::press(ViewCommand command) {
  const bool had_notice = !notice_.empty();
  notice_.clear();
  ViewChange change = obey(command);
  findSurfaces();
  change.redraw |= had_notice || !notice_.empty();
  return change;
}

ViewChange ViewSession::obey(ViewCommand command) {
  const auto toggled = [](bool& value) {
    value = !value;
    return kRedraw;
  };
  const auto chosen = [&](int by) {
    field_ = around(field_, by, fields_.size());
    return kRedraw;
  };
  const auto resized = [&](double by) {
    point_size_ = std::clamp(point_size_ + by, kSmallestPoint, kLargestPoint);
    return kRedraw;
  };
  switch (command) {
    case ViewCommand::NextInput:
      return index_ + 1 < size() ? go(index_ + 1) : kNothing;
    case ViewCommand::PreviousInput:
      return index_ > 0 ? go(index_ - 1) : kNothing;
    case ViewCommand::FirstInput:
      return go(0);
    case ViewCommand::LastInput:
      return go(size() - 1);
    case ViewCommand::NextSensor:
      return changeSensor(1);
    case ViewCommand::PreviousSensor:
      return changeSensor(-1);
    case ViewCommand::SwitchMode:
      return changeMode();
    case ViewCommand::NextParameter:
      return chosen(1);
    case ViewCommand::PreviousParameter:
      return chosen(-1);
    case ViewCommand::RaiseParameter:
      return changeField(1);
    case ViewCommand::LowerParameter:
      return changeField(-1);
    case ViewCommand::ResetParameters:
      parameters_ = options_.parameters;
      sensor_ = 0;
      useMode(parameters_.mode);
      return resegmented();
    case ViewCommand::NextPlane:
      return choosePlane(1);
    case ViewCommand::PreviousPlane:
      return choosePlane(-1);
    case ViewCommand::SelectNone:
      return select(0);
    case ViewCommand::NextSurface:
      return nextSurface();
    case ViewCommand::SwitchOutlines:
      return toggled(style_.outlines);
    case ViewCommand::SwitchOutlineKind:
      return switchOutlineKind();
    case ViewCommand::SwitchNormals:
      return toggled(style_.normals);
    case ViewCommand::SwitchUnlabelled:
      return toggled(style_.unlabelled);
    case ViewCommand::LargerPoints:
      return resized(1.0);
    case ViewCommand::SmallerPoints:
      return resized(-1.0);
    case ViewCommand::NextPlace:
      place_ = static_cast<ViewPlace>((static_cast<int>(place_) + 1) % 3);
      return {true, true, false};
    case ViewCommand::SamePlace:
      return {true, true, false};
    case ViewCommand::SwitchTexts:
      return toggled(shows_texts_);
    case ViewCommand::SwitchHelp:
      return toggled(shows_help_);
    case ViewCommand::Quit:
      return {false, false, true};
  }
  return kNothing;
}

ViewChange ViewSession::select(std::int32_t label) {
  style_.selected = label;
  return kRedraw;
}

ViewScene ViewSession::scene() const {
  if (!frame_ || !problem_.empty()) return {{}, true, {}, {}, {}, {{0, 0, 0}, {0, 0, 1}, {0, -1, 0}, false}};
  return viewScene(frameView(*frame_), result_, surfaces_, style_);
}

/// The view stays where it is from frame to frame of one sensor.
ViewChange ViewSession::go(std::size_t index) {
  const ViewSensor before = scene().sensor;
  const int width = result_.width, height = result_.height;
  index_ = index;
  style_.selected = 0;
  attempt(&ViewSession::load);
  const ViewScene now = scene();
  const bool is_same = before.is_scanner == now.sensor.is_scanner && before.origin == now.sensor.origin &&
                       before.forward == now.sensor.forward && width == result_.width && height == result_.height;
  if (!is_same) place_ = firstPlace(now);
  return {true, !is_same, false};
}

ViewChange ViewSession::changeSensor(int by) {
  sensor_ = around(sensor_, by, sensors_.size());
  return resegmented();
}

ViewChange ViewSession::changeMode() {
  useMode(parameters_.mode == Mode::Paper ? Mode::InverseDepth : Mode::Paper);
  return resegmented();
}

ViewChange ViewSession::changeField(int direction) {
  const ParameterField& field = *fields_[field_];
  Parameters changed = parameters_;
  field.set(changed, dialStep(field, field.get(parameters_), direction));
  if (!changed.validate().empty()) return kNothing;
  parameters_ = changed;
  return resegmented();
}

ViewChange ViewSession::choosePlane(int by) {
  if (result_.planes.empty()) return kNothing;
  const std::size_t choices = result_.planes.size() + 1;  // with none
  return select(static_cast<std::int32_t>(around(static_cast<std::size_t>(style_.selected), by, choices)));
}

ViewChange ViewSession::resegmented() {
  style_.selected = 0;
  if (frame_) attempt(&ViewSession::segment);
  return kRedraw;
}

/// The points, the mesh, both, the points again.
ViewChange ViewSession::nextSurface() {
  const bool is_mesh = style_.mesh && !style_.points;
  const bool is_points = style_.points && !style_.mesh;
  if (is_points && surfacesAreMissing()) return kRedraw;
  style_.points = !is_points;
  style_.mesh = is_points || is_mesh;
  return kRedraw;
}

ViewChange ViewSession::switchOutlineKind() {
  if (surfacesAreMissing()) return kRedraw;
  const bool are_polygons = style_.outline_kind == OutlineKind::Polygons;
  style_.outline_kind = are_polygons ? OutlineKind::Contours : OutlineKind::Polygons;
  style_.outlines = true;
  return kRedraw;
}

bool ViewSession::surfacesAreMissing() {
  notice_ = surfacesMissing();
  if (!notice_.empty()) notice_ = "no polygons, no mesh: " + notice_;
  return !notice_.empty();
}

void ViewSession::useMode(Mode mode) {
  parameters_.mode = mode;
  const std::string chosen = fields_.empty() ? "line_k_max" : fields_[field_]->name;
  fields_ = dialFields(mode);
  // The parameter of the same name stays chosen, if the other mode has it.
  const std::string word = chosen.substr(chosen.rfind('.') + 1);
  const auto found = std::find_if(fields_.begin(), fields_.end(), [&](const ParameterField* field) {
    const std::string name = field->name;
    return name.substr(name.rfind('.') + 1) == word;
  });
  field_ = found == fields_.end() ? 0 : static_cast<std::size_t>(found - fields_.begin());
}

/// Runs a step; what it throws becomes the problem that is shown in the place of planes.
void ViewSession::attempt(void (ViewSession::*step)()) {
  problem_.clear();
  result_ = PlaneSegmentation();
  surfaces_ = FrameSurfaces();
  has_surfaces_ = false;
  summaries_.clear();
  try {
    (this->*step)();
  } catch (const InputError& error) {
    problem_ = error.what();
  }
}

void ViewSession::load() {
  frame_.reset();
  if (input().problem) throw *input().problem;
  frame_ = loadInput(input(), options_);
  segment();
}

void ViewSession::segment() {
  const FrameSensor sensor = sensorOf(input(), *frame_, sensors_[sensor_]);
  sensor_name_ = sensor.name;
  findPlanes(input(), *frame_, sensor, parameters_, extractor_, result_);
  seconds_ = extractor_.times().total();
  summaries_ = summarizePlanes(frameView(*frame_), result_);
}

/// Once for each result, and not before they are to be drawn.
void ViewSession::findSurfaces() {
  if (!frame_ || !problem_.empty() || !style_.needsSurfaces()) return;
  if (!has_surfaces_) surfaces_ = frameSurfaces(frameView(*frame_), extractor_.sensor(), result_, true);
  has_surfaces_ = true;
  if (!surfaces_.polygons.problem.empty()) notice_ = "no polygons, no mesh: " + surfaces_.polygons.problem;
}

}  // namespace epcc
