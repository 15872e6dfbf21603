// SPDX-License-Identifier: BSD-3-Clause
// Counts and medians as lines and tables.
#include "eval/track/track_report.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "eval/report/table.h"

namespace epcc {
namespace {

constexpr std::size_t kListedTracks = 12;

std::string line(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string line(const char* format, ...) {
  char text[400];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return text;
}

std::string share(long part, long whole) {
  return whole > 0 ? numberCell(static_cast<double>(part) / static_cast<double>(whole), 3) : "-";
}

template <typename Sums>
std::vector<std::string> repeatedCells(const Sums& sums) {
  return {share(sums.repeated_pixels, sums.shared),
          std::to_string(sums.repeated) + " of " + std::to_string(sums.regions)};
}

/// Standard deviation of the plane's distance at its middle, millimetres.
double offsetSigma(const PlaneTrack& track) {
  const Eigen::Vector4d at(track.centroid.x(), track.centroid.y(), track.centroid.z(), 1.0);
  return 1e3 * std::sqrt(std::max(0.0, at.dot(Eigen::Matrix4d(track.plane.covariance) * at)));
}

Table largestTracks(const std::vector<MappedTrack>& tracks) {
  std::vector<const MappedTrack*> order;
  for (const MappedTrack& one : tracks)
    if (one.track.end == TrackEnd::None) order.push_back(&one);
  std::stable_sort(order.begin(), order.end(),
                   [](const MappedTrack* a, const MappedTrack* b) { return a->surface.area > b->surface.area; });
  order.resize(std::min(order.size(), kListedTracks));
  Table table;
  for (const char* title : {"label", "area m2", "frames", "from s", "to s", "sigma mm", "confidence"})
    table.columns.push_back({title, true});
  for (const MappedTrack* one : order) {
    const PlaneTrack& track = one->track;
    table.rows.push_back({std::to_string(track.label), numberCell(one->surface.area, 2), std::to_string(track.frames),
                          numberCell(track.first_time, 2), numberCell(track.last_time, 2),
                          numberCell(offsetSigma(track), 1), numberCell(track.confidence, 2)});
  }
  return table;
}

std::vector<std::string> errorCells(const char* name, const ErrorStatistics& errors, double scale, int decimals) {
  std::vector<std::string> cells = {name};
  for (const double value : {errors.rmse, errors.mean, errors.median, errors.max})
    cells.push_back(errors.count > 0 ? numberCell(scale * value, decimals, "-") : "-");
  cells.push_back(std::to_string(errors.count));
  return cells;
}

}  // namespace

std::string trackSummary(const TrackOptions& options, const TrackResult& result) {
  long going_on = 0, merged = 0, clutter = 0;
  for (const MappedTrack& one : result.tracks) {
    going_on += one.track.end == TrackEnd::None ? 1 : 0;
    merged += one.track.end == TrackEnd::Merged ? 1 : 0;
    clutter += one.track.end == TrackEnd::Clutter ? 1 : 0;
  }
  std::string text = line("%zu %s of %s, noise %s, %s\n", result.names.size(),
                          result.names.size() == 1 ? "frame" : "frames", options.folder.c_str(), result.sensor.c_str(),
                          result.truth.empty() || options.pose_free ? "poses found by the planes" : "poses known");
  text += line(
      "%zu tracks: %ld go on, %ld became part of another, %ld turned out to be clutter; %.2f ms a frame (median)\n",
      result.tracks.size(), going_on, merged, clutter, 1e-3 * result.microseconds.median().value_or(0.0));
  const bool given = !result.truth.empty() && !options.pose_free;
  // Before the first frame there is no map.
  const auto open = std::count_if(result.open.begin() + (result.open.empty() ? 0 : 1), result.open.end(),
                                  [](int directions) { return directions > 0; });
  if (open > 0)
    text += line("planes that leave a direction open, in %ld of the frames: along it %s\n", static_cast<long>(open),
                 given ? "given poses alone tell where the camera is" : "the camera goes on as expected");
  if (!result.lost.empty())
    text +=
        line("planes that are not where they are expected, in %zu of the frames, %s first: the camera may be lost\n",
             result.lost.size(), result.lost.front().c_str());
  if (result.without_depth > 0) text += line("%ld of the frames show nothing\n", result.without_depth);
  if (result.without_start > 0)
    text += line("%ld frames left out, for they come before the first pose of %s\n", result.without_start,
                 options.poses.c_str());
  for (const std::string& name : result.jumps)
    text += line("the given poses jumped at frame %s; the map goes on without the jump\n", name.c_str());
  const Table table = largestTracks(result.tracks);
  return table.rows.empty() ? text : text + textTable(table);
}

std::string trajectorySummary(const TrackResult& result) {
  if (result.truth.size() < 3) return {};
  const RelativePoseErrors relative = relativePoseErrors(result.trajectory, result.truth);
  std::vector<bool> is_determined;
  for (const int open : result.open) is_determined.push_back(open == 0);
  const RelativePoseErrors determined = relativePoseErrors(result.trajectory, result.truth, 1.0, is_determined);
  const ErrorStatistics absolute = absoluteTrajectoryErrors(result.trajectory, result.truth);
  Table table;
  table.columns.push_back({"trajectory against the known poses", false});
  for (const char* title : {"rmse", "mean", "median", "max", "poses"}) table.columns.push_back({title, true});
  table.rows.push_back(errorCells("relative, over 1 s, mm", relative.metres, 1e3, 2));
  table.rows.push_back(errorCells("relative, over 1 s, degrees", relative.degrees, 1.0, 3));
  table.rows.push_back(errorCells("the same, three planes, mm", determined.metres, 1e3, 2));
  table.rows.push_back(errorCells("the same, three planes, degrees", determined.degrees, 1.0, 3));
  table.rows.push_back(errorCells("absolute, aligned, mm", absolute, 1e3, 2));
  return "\n" + textTable(table);
}

namespace {

std::string alignedSummary(const AlignedErrors& errors) {
  Table table;
  table.columns.push_back({"over 1 s, against aligned depth images", false});
  for (const char* title : {"rmse", "mean", "median", "max", "pairs"}) table.columns.push_back({title, true});
  table.rows.push_back(errorCells("known poses, mm", errorStatistics(errors.known_metres), 1e3, 2));
  table.rows.push_back(errorCells("known poses, degrees", errorStatistics(errors.known_degrees), 1.0, 3));
  table.rows.push_back(errorCells("trajectory, mm", errorStatistics(errors.tracked_metres), 1e3, 2));
  table.rows.push_back(errorCells("trajectory, degrees", errorStatistics(errors.tracked_degrees), 1.0, 3));
  return "\n" + textTable(table) +
         line("misfit of the depth images, mean square in sigma: known poses %.2f, trajectory %.2f, aligned %.2f\n",
              errorStatistics(errors.known_misfit).mean, errorStatistics(errors.tracked_misfit).mean,
              errorStatistics(errors.aligned_misfit).mean);
}

}  // namespace

std::string measureSummary(const TrackOptions& options, const TrackResult& result) {
  const SquaredErrors& squares = result.squared_errors;
  std::string text;
  if (result.measures && result.measures->frames() > 0) {
    const TrackMeasures& measures = *result.measures;
    Table table;
    table.columns.push_back({"repeated", false});
    for (const char* title : {"lag", "pairs", "pixels", "regions"}) table.columns.push_back({title, true});
    for (const LagMeasures& sums : measures.lags()) {
      const auto row = [&](const char* name, const auto& repeated) {
        std::vector<std::string> cells = {name, std::to_string(sums.lag), std::to_string(repeated.pairs)};
        for (const std::string& cell : repeatedCells(repeated)) cells.push_back(cell);
        table.rows.push_back(cells);
      };
      if (options.compare_single) row("planes, frames one by one", sums.single);
      row("planes, tracked", sums.tracked);
      row("labels as written", sums.as_written);
      row("labels as known by then", sums.as_known);
    }
    if (!measures.alignedErrors().known_metres.empty()) text += alignedSummary(measures.alignedErrors());
    text += "\n" + textTable(table);
    if (measures.hasTruth())
      text += line("label switches a surface and minute, against the truth: %.2f (%ld in %.1f minutes)\n",
                   measures.switchesOfTruth().perMinute(), measures.switchesOfTruth().switches,
                   measures.switchesOfTruth().seconds / 60.0);
    text += line(
        "label switches a surface and minute, of the largest five over 1 s: %.2f as written, %.2f as known by then "
        "(%.1f minutes)\n",
        measures.switchesAsWritten().perMinute(), measures.switchesAsKnown().perMinute(),
        measures.switchesAsWritten().seconds / 60.0);
  } else if (options.measure) {
    text += "\nnothing measured: no frame has a known pose\n";
  }
  if (options.measure && squares.size() > 0)
    text += line(
        "squared errors of planes: mean %.2f (3), median %.2f (2.37), within the 95 %% limit %.1f %%; covariances "
        "taken %.2f times\n",
        squares.mean(), squares.median(), 100.0 * squares.shareWithinLimit(), result.error_scale);
  return text;
}

}  // namespace epcc
