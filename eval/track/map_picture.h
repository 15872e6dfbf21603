// SPDX-License-Identifier: BSD-3-Clause
// A map as a picture, without OpenGL.
#pragma once

#include <vector>

#include "datasets/files/image.h"
#include "eval/track/map_view.h"

namespace epcc {

/// The tracks that go on, in the colours of their labels, seen along the view's axis: what faces the viewer, nearest
/// first, so that walls and ceilings between the viewer and the room do not hide it. The larger ones carry their label,
/// a dark line is the camera's way, its start a dot; a bar says how long a metre is, or another round length.
ColorImage drawMap(const std::vector<MappedTrack>& tracks, const Trajectory& trajectory, const MapView& view,
                   int width);

/// From above and obliquely, side by side.
ColorImage mapPicture(const std::vector<MappedTrack>& tracks, const Trajectory& trajectory);

}  // namespace epcc
