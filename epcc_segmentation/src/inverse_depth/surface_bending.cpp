// SPDX-License-Identifier: BSD-3-Clause
// One pass over the runs of labels; each region takes those on its own grid.
#include "inverse_depth/surface_bending.h"

#include <algorithm>
#include <cstddef>

namespace epcc {

namespace {

void listViews(const InverseDepthImage& image, const RegionMap& map, const std::vector<std::uint8_t>& wanted,
               BendingMemory& memory) {
  memory.views.clear();
  memory.view_of.assign(map.regions.size() + 1, -1);
  for (std::size_t k = 0; k < map.regions.size(); ++k)
    if (wanted[k] != 0) {
      memory.view_of[k + 1] = static_cast<std::int32_t>(memory.views.size());
      memory.views.emplace_back(map.regions[k], !image.planar_rows);
    }
}

void addRuns(const InverseDepthImage& image, const RegionMap& map, int row, BendingMemory& memory) {
  markLeftBorders(map.labels.data(), image.width, image.height, row, memory.left);
  memory.begins.clear(image.width);
  for (std::size_t word = 0; word < memory.left.size(); ++word) memory.begins.add(memory.left[word], word);
  int begin = 0;
  const auto addRun = [&](int end) {
    const std::int32_t k = memory.view_of[static_cast<std::size_t>(map.labels[image.index(row, begin)])];
    if (k >= 0) memory.views[static_cast<std::size_t>(k)].addRun(image, row, begin, end);
    begin = end;
  };
  for (const int end : memory.begins) addRun(end);
  addRun(image.width);
}

}  // namespace

void measureBending(const InverseDepthImage& image, const RegionMap& map, const std::vector<std::uint8_t>& wanted,
                    BendingMemory& memory) {
  listViews(image, map, wanted, memory);
  memory.left.assign(wordsOf(image.width), 0);
  const auto& views = memory.views;
  for (int row = 0; row < image.height; ++row)
    if (std::any_of(views.begin(), views.end(), [row](const RegionView& view) { return view.isOnGrid(row); }))
      addRuns(image, map, row, memory);
  memory.bending.assign(map.regions.size(), Bending());
  for (std::size_t k = 0; k < map.regions.size(); ++k)
    if (memory.view_of[k + 1] >= 0)
      memory.bending[k] = views[static_cast<std::size_t>(memory.view_of[k + 1])].bending();
}

}  // namespace epcc
