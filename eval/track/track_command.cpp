// SPDX-License-Identifier: BSD-3-Clause
// The frames are tracked, then the files that speak of all of them are written.
#include "eval/track/track_command.h"

#include <filesystem>
#include <ostream>

#include "datasets/files/png_io.h"
#include "datasets/support/atomic_file.h"
#include "eval/pictures/overlay.h"
#include "eval/program/command_line.h"
#include "eval/program/folder_lock.h"
#include "eval/program/frame_sensor.h"
#include "eval/program/reading_arguments.h"
#include "eval/track/earlier_run.h"
#include "eval/track/map_picture.h"
#include "eval/track/track_files.h"
#include "eval/track/track_report.h"
#include "eval/track/track_run.h"

namespace epcc {
namespace {

constexpr const char* kProgram = "epcc_track";

std::vector<PlaneTrack> tracksOf(const TrackResult& result) {
  std::vector<PlaneTrack> tracks;
  for (const MappedTrack& one : result.tracks) tracks.push_back(one.track);
  return tracks;
}

void writeOverlays(const TrackOptions& options, const TrackInput& input, const TrackResult& result) {
  for (std::size_t i = 0; i < result.names.size(); ++i) {
    const std::string start = (std::filesystem::path(options.out) / result.names[i]).string();
    const LabelImage labels = readGray16(start + "_labels.png");
    writeRgb(start + "_overlay.png", drawOverlay(input.read(result.places[i]).frame.depth, labels));
  }
}

void writeFiles(const TrackOptions& options, const TrackResult& result, std::ostream& err) {
  const auto in_folder = [&](const char* name) { return (std::filesystem::path(options.out) / name).string(); };
  if (!options.online) rewriteLabels(tracksOf(result), result.names, options.out);
  const bool poses_given = !result.truth.empty() && result.truth.front().time == result.trajectory.front().time;
  writeTextFile(in_folder("tracks.json"),
                trackListJson(result.tracks, poses_given, static_cast<long>(result.names.size())).dump(1) + "\n");
  writeTrajectory(in_folder("trajectory.txt"), result.trajectory);
  writeRgb(in_folder("map.png"), mapPicture(result.tracks, result.trajectory));
  if (!writeMapMesh(in_folder("map.ply"), result.tracks))
    err << kProgram << ": no map.ply, this program was built without GEOS (EPCC_WITH_GEOS)\n";
}

}  // namespace

int trackMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  TrackOptions options;
  if (const auto done = parseTrackOptions(argc, argv, options, out, err)) return *done;
  return runProgram(kProgram, out, err, [&]() -> int {
    const TrackInput input(options);
    FrameKinds kinds;
    kinds.add(input.source());
    std::string misuse = uselessOption(options.reading, kinds);
    if (misuse.empty()) misuse = outputProblem(options, input);
    if (!misuse.empty()) return reportProblem(kProgram, err, misuse, kExitUsage);
    const FolderLock lock(options.out);
    for (const std::string& file : filesOfRun(options.out)) checkOutputFile(file);  // before hours of work
    const TrackResult result = runTracker(options, input, err);
    if (result.doubtful > 0)
      err << kProgram << ": " << doubtfulText(result.doubtful, result.first_doubtful, result.first_doubt) << '\n';
    writeFiles(options, result, err);
    if (options.overlays) writeOverlays(options, input, result);
    out << trackSummary(options, result) << trajectorySummary(result) << measureSummary(options, result);
    return result.problems > 0 ? kExitInput : kExitDone;
  });
}

}  // namespace epcc
