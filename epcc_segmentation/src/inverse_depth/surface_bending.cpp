// SPDX-License-Identifier: BSD-3-Clause
// One pass over the runs of labels, by bands of rows; each region takes those on its own grid.
#include "inverse_depth/surface_bending.h"

#include <algorithm>
#include <cstddef>

#include "parallel_for.h"

namespace epcc {

namespace {

// However many threads there are, the rows are summed in as many bands: one order of all sums.
constexpr int kViewedBands = 4;

void listViews(const InverseDepthImage& image, const RegionMap& map, const std::vector<std::uint8_t>& wanted,
               BendingMemory& memory) {
  memory.bands.resize(kViewedBands);
  std::vector<RegionView>& views = memory.bands.front().views;
  views.clear();
  memory.view_of.assign(map.regions.size() + 1, -1);
  for (std::size_t k = 0; k < map.regions.size(); ++k)
    if (wanted[k] != 0) {
      memory.view_of[k + 1] = static_cast<std::int32_t>(views.size());
      views.emplace_back(map.regions[k], !image.planar_rows);
    }
  for (BendingMemory::Band& band : memory.bands)
    if (&band.views != &views) band.views = views;
}

void addRuns(const InverseDepthImage& image, const RegionMap& map, const std::vector<std::int32_t>& view_of, int row,
             BendingMemory::Band& band) {
  markLeftBorders(map.labels.data(), image.width, image.height, row, band.left);
  band.begins.clear(image.width);
  for (std::size_t word = 0; word < band.left.size(); ++word) band.begins.add(band.left[word], word);
  int begin = 0;
  const auto addRun = [&](int end) {
    const std::int32_t k = view_of[static_cast<std::size_t>(map.labels[image.index(row, begin)])];
    if (k >= 0) band.views[static_cast<std::size_t>(k)].addRun(image, row, begin, end);
    begin = end;
  };
  for (const int end : band.begins) addRun(end);
  addRun(image.width);
}

}  // namespace

void measureBending(const InverseDepthImage& image, const RegionMap& map, const std::vector<std::uint8_t>& wanted,
                    BendingMemory& memory, int threads) {
  listViews(image, map, wanted, memory);
  sharedFor(kViewedBands, threads, [&](int /*thread*/, int first, int end) {
    for (int k = first; k < end; ++k) {
      BendingMemory::Band& band = memory.bands[static_cast<std::size_t>(k)];
      band.left.assign(wordsOf(image.width), 0);
      const auto isWanted = [&band](int row) {
        return std::any_of(band.views.begin(), band.views.end(),
                           [row](const RegionView& view) { return view.isOnGrid(row); });
      };
      for (int row = image.height * k / kViewedBands; row < image.height * (k + 1) / kViewedBands; ++row)
        if (isWanted(row)) addRuns(image, map, memory.view_of, row, band);
    }
  });
  memory.bending.assign(map.regions.size(), Bending());
  for (std::size_t k = 0; k < map.regions.size(); ++k) {
    const std::int32_t number = memory.view_of[k + 1];
    if (number < 0) continue;
    const auto viewIn = [number](BendingMemory::Band& band) -> RegionView& {
      return band.views[static_cast<std::size_t>(number)];
    };
    RegionView& view = viewIn(memory.bands.front());
    for (std::size_t band = 1; band < memory.bands.size(); ++band) view += viewIn(memory.bands[band]);
    memory.bending[k] = view.bending();
  }
}

}  // namespace epcc
