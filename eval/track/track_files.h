// SPDX-License-Identifier: BSD-3-Clause
// The files that epcc_track leaves beside the label images.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "datasets/files/trajectory_file.h"
#include "eval/track/track_map.h"

namespace epcc {

/// Version 1, explained in docs/reference/epcc_track.md. `names` tells the name of a frame by its number.
nlohmann::json trackListJson(const std::vector<MappedTrack>& tracks, bool poses_given, long frames);

/// Writes the polygons of the tracks that go on as triangles in the colours of their labels; false if this program was
/// built without GEOS, which cuts them. Throws OutputError.
bool writeMapMesh(const std::string& path, const std::vector<MappedTrack>& tracks);

/// The label image of a frame: lasting labels, 0 none. OutputError, also for a label above 65534.
void writeLastingLabels(const std::string& path, int width, int height, const std::vector<std::int32_t>& labels);

/// Gives the pixels of labels that turned out to be part of another that one's label, in the files of the frames that
/// may have them; `path` tells a frame's file, empty if it has none. Returns the number of files that were rewritten.
long rewriteLabels(const std::vector<PlaneTrack>& tracks, const std::vector<std::string>& names,
                   const std::string& folder);

}  // namespace epcc
