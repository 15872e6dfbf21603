// SPDX-License-Identifier: BSD-3-Clause
// Follows each plane of Algorithm 2 from its first segment until no coming line looks back to its last one.
#include "stream/stream_planes.h"

#include <algorithm>

namespace epcc {

namespace {

// The clustering counts in 32 bits.
constexpr std::int64_t kMostSegments = 500000000;

const std::vector<ClusteredLine> kNoSegments;

}  // namespace

void StreamPlanes::begin(const PaperParameters& parameters, const SensorModel& sensor, Projection projection,
                         std::int64_t longest_plane, const Eigen::Matrix3d& axes) {
  parameters_ = parameters;
  projection_ = projection;
  longest_plane_ = longest_plane;
  pixels_per_sample_ = sensor.pixelsPerSample();
  axes_ = axes;
  clustering_.configure(parameters, sensor);
  clustering_.begin(projection);
  serial_ = ids_ = 0;
  lines_.clear();
  planes_.clear();
  free_.clear();
  open_.clear();
  closed_.clear();
  at_place_.clear();
}

void StreamPlanes::addLine(const std::vector<ClusteredLine>& segments) {
  PendingLine& line = lines_.at(lines_.size() - 1);
  line.serial = serial_ + 1;
  for (PendingSegment& segment : line.segments) segment.plane = PendingSegment::kNone;
  clusterLine(segments);
  handOutLines();
  handOutPlanes();
}

// No line looks back farther than that.
void StreamPlanes::skipLines(std::int64_t count) {
  const auto seen = std::min<std::int64_t>(count, parameters_.expert.planes.look_back);
  for (std::int64_t i = 0; i < seen; ++i) clusterLine(kNoSegments);
  handOutLines();
  handOutPlanes();
}

void StreamPlanes::clusterLine(const std::vector<ClusteredLine>& segments) {
  ++serial_;
  clustering_.addLine(segments);
  labelSegments();
  closePlanes();
  clustering_.forgetOldLines();
}

/// What Algorithm 2 labelled: segments of this line, and earlier ones as their partners.
void StreamPlanes::labelSegments() {
  const auto look_back = static_cast<std::int64_t>(parameters_.expert.planes.pair_look_back);
  std::size_t i = lines_.size();
  while (i > 0 && serial_ - lines_.at(i - 1).serial <= look_back) --i;
  for (; i < lines_.size(); ++i) {
    PendingLine& line = lines_.at(i);
    const int* labels = clustering_.labelsOfLine(static_cast<std::size_t>(serial_ - line.serial));
    for (std::size_t k = 0; k < line.segments.size(); ++k) {
      PendingSegment& segment = line.segments[k];
      if (segment.plane != PendingSegment::kNone || labels[k] < 0) continue;
      segment.plane = planeAt(labels[k], line);
      addSegment(line, segment.plane, segment);
    }
  }
}

int StreamPlanes::planeAt(int place, const PendingLine& line) {
  const auto at = static_cast<std::size_t>(place);
  if (at >= at_place_.size()) at_place_.resize(at + 1, PendingSegment::kNone);
  if (at_place_[at] != PendingSegment::kNone) return at_place_[at];
  if (free_.empty()) {
    free_.push_back(static_cast<int>(planes_.size()));
    planes_.emplace_back();
  }
  const int plane = free_.back();
  free_.pop_back();
  open_.push_back(plane);
  at_place_[at] = plane;
  GrowingPlane& fresh = planes_[static_cast<std::size_t>(plane)];
  fresh = GrowingPlane();
  fresh.place = place;
  fresh.first_line = line.index;
  return plane;
}

void StreamPlanes::addSegment(const PendingLine& line, int index, const PendingSegment& segment) {
  GrowingPlane& plane = planes_[static_cast<std::size_t>(index)];
  plane.moments.add(segment.moments);
  plane.points += static_cast<std::int64_t>(segment.moments.plain.one);
  ++plane.segments;
  plane.last_line = line.index;
  plane.last_serial = line.serial;
  if (plane.id == kUndecided && plane.segments >= parameters_.min_segments && plane.points >= parameters_.min_points)
    plane.id = ++ids_;
}

/// Planes that no coming line looks back to, and those that have become as long as they may.
void StreamPlanes::closePlanes() {
  std::size_t kept = 0;
  for (const int index : open_) {
    GrowingPlane& plane = planes_[static_cast<std::size_t>(index)];
    plane.is_cut = plane.last_line - plane.first_line + 1 >= longest_plane_ || plane.segments >= kMostSegments;
    if (plane.is_cut || serial_ - plane.last_serial >= parameters_.expert.planes.look_back)
      closePlane(index);
    else
      open_[kept++] = index;
  }
  open_.resize(kept);
}

void StreamPlanes::closePlane(int index) {
  GrowingPlane& plane = planes_[static_cast<std::size_t>(index)];
  if (plane.id == kUndecided) plane.id = kDropped;
  clustering_.release(plane.place);
  at_place_[static_cast<std::size_t>(plane.place)] = PendingSegment::kNone;
  closed_.push_back(index);
}

bool StreamPlanes::isDecided(const PendingLine& line) const {
  return std::all_of(line.segments.begin(), line.segments.end(), [this](const PendingSegment& segment) {
    return segment.plane == PendingSegment::kNone || planes_[static_cast<std::size_t>(segment.plane)].id != kUndecided;
  });
}

void StreamPlanes::handOutLines() {
  const auto look_back = static_cast<std::int64_t>(parameters_.expert.planes.pair_look_back);
  while (!lines_.empty() && serial_ - lines_.front().serial >= look_back && isDecided(lines_.front())) {
    if (on_line) handOut(lines_.front());
    lines_.pop();
  }
}

void StreamPlanes::handOut(const PendingLine& line) {
  runs_.clear();
  for (const PendingRun& run : line.runs) {
    const int plane = line.segments[static_cast<std::size_t>(run.segment)].plane;
    if (plane == PendingSegment::kNone) continue;
    const std::int64_t id = planes_[static_cast<std::size_t>(plane)].id;
    if (id == kDropped) continue;
    if (!runs_.empty() && runs_.back().plane == id && runs_.back().last + 1 == run.first)
      runs_.back().last = run.last;
    else
      runs_.push_back({run.first, run.last, id});
  }
  LabelledLine labelled;
  labelled.index = line.index;
  labelled.azimuth = line.azimuth;
  labelled.runs = runs_.data();
  labelled.run_count = runs_.size();
  on_line(labelled);
}

void StreamPlanes::handOutPlanes() {
  std::size_t kept = 0;
  for (const int index : closed_) {
    const GrowingPlane& plane = planes_[static_cast<std::size_t>(index)];
    if (!lines_.empty() && lines_.front().serial <= plane.last_serial) {
      closed_[kept++] = index;
      continue;
    }
    if (on_plane && plane.id != kDropped) on_plane(describe(plane));
    free_.push_back(index);
  }
  closed_.resize(kept);
}

StreamPlane StreamPlanes::describe(const GrowingPlane& plane) const {
  StreamPlane result;
  result.id = plane.id;
  result.plane =
      planeOf(plane.moments.turned(axes_), static_cast<std::size_t>(plane.moments.plain.one), pixels_per_sample_);
  result.first_line = plane.first_line;
  result.last_line = plane.last_line;
  result.segments = plane.segments;
  result.is_cut = plane.is_cut;
  return result;
}

void StreamPlanes::finish() {
  for (const int index : open_) closePlane(index);
  open_.clear();
  serial_ += parameters_.expert.planes.look_back;
  handOutLines();
  handOutPlanes();
  clustering_.begin(projection_);
}

void StreamPlanes::listOpen(std::vector<StreamPlane>& planes) const {
  planes.clear();
  for (const int index : open_) {
    const GrowingPlane& plane = planes_[static_cast<std::size_t>(index)];
    if (plane.id != kUndecided) planes.push_back(describe(plane));
  }
  std::sort(planes.begin(), planes.end(), [](const StreamPlane& a, const StreamPlane& b) { return a.id < b.id; });
}

}  // namespace epcc
