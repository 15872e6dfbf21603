// SPDX-License-Identifier: BSD-3-Clause
// Finds regions on both sides of an occluder by looking from the ends of the runs of labels on rows and columns.
#include <algorithm>
#include <cstddef>

#include "inverse_depth/region_contacts.h"
#include "parallel_for.h"

namespace epcc {

namespace {

/// Every other line will do: contacts come in long rows.
constexpr int kLineStep = 2;
constexpr std::uint64_t kEvenColumns = 0x5555555555555555;

constexpr int kWalkedBands = 8;  // of rows and of columns

/// Looks from both ends of a run of labels along its line, behind what is in front of the run's plane: on the lines of
/// a band.
class OcclusionWalk {
 public:
  OcclusionWalk(const InverseDepthImage& image, double max_occluder, const RegionMap& map,
                const OcclusionMemory& memory, OcclusionMemory::Band& band)
      : image_(image), max_occluder_(max_occluder), labels_(map.labels.data()), memory_(memory), band_(band) {}

  /// Also lists where runs on columns begin.
  void walkRows(int begin, int end) {
    for (RowBits* bits : {&band_.left, &band_.above}) bits->assign(wordsOf(image_.width), 0);
    band_.begins_on_columns.clear();
    band_.on_rows.clear();
    places_ = &band_.on_rows;
    for (int row = begin; row < end; ++row) {
      listBeginsOnColumns(row);
      if (row % kLineStep != 0) continue;
      listBegins(row);
      walkLine({row, 0}, {0, 1}, image_.width, band_.begins);
    }
  }

  void walkColumns(int first_line, int end_line) {
    band_.on_columns.clear();
    places_ = &band_.on_columns;
    for (int line = first_line; line < end_line; ++line) {
      const int* first = memory_.first_of_column.data() + line;
      band_.begins.assign(1, 0);
      band_.begins.insert(band_.begins.end(), memory_.sorted_begins.begin() + first[0],
                          memory_.sorted_begins.begin() + first[1]);
      walkLine({0, line * kLineStep}, {1, 0}, image_.height, band_.begins);
    }
  }

 private:
  struct Pixel {
    int row, column;
  };
  enum class Place { InFront, On, Behind };

  // ---- runs ----
  void listBegins(int row) {
    markLeftBorders(labels_, image_.width, image_.height, row, band_.left);
    band_.columns.clear(image_.width);
    for (std::size_t word = 0; word < band_.left.size(); ++word) band_.columns.add(band_.left[word], word);
    band_.begins.assign(1, 0);
    band_.begins.insert(band_.begins.end(), band_.columns.begin(), band_.columns.end());
  }

  void listBeginsOnColumns(int row) {
    markUpperBorders(labels_, image_.width, row, band_.above);
    band_.columns.clear(image_.width);
    for (std::size_t word = 0; word < band_.above.size(); ++word)
      band_.columns.add(band_.above[word] & kEvenColumns, word);
    for (const int column : band_.columns) band_.begins_on_columns.push_back({row, column / kLineStep});
  }

  // ---- a line ----
  void walkLine(Pixel start, Pixel step, int length, std::vector<int>& begins) {
    line_start_ = start;
    line_step_ = step;
    stride_ = static_cast<std::ptrdiff_t>(step.row) * image_.width + step.column;
    first_ = static_cast<std::ptrdiff_t>(image_.index(start.row, start.column));
    band_.labels.clear();
    for (const int begin : begins) band_.labels.push_back(labels_[first_ + begin * stride_]);
    begins.push_back(length);
    begins_ = begins.data();
    runs_ = static_cast<int>(begins.size()) - 1;
    for (int run = 0; run < runs_; ++run) {
      if (labelOf(run) == 0) continue;
      lookBehind(run, 1);
      lookBehind(run, -1);
    }
  }

  int begin(int run) const { return begins_[run]; }
  int end(int run) const { return begins_[run + 1]; }
  int lengthOf(int run) const { return end(run) - begin(run); }
  Pixel pixelAt(int i) const {
    return {line_start_.row + i * line_step_.row, line_start_.column + i * line_step_.column};
  }
  std::int32_t labelOf(int run) const { return band_.labels[static_cast<std::size_t>(run)]; }

  /// Adds a contact if the run goes on behind what comes next in `direction`. The longer of two runs looks for the
  /// other, no farther than an occluder of the two can reach: the walks along a line are no longer than a few lines
  /// together.
  void lookBehind(int run, int direction) {
    const std::int32_t label = labelOf(run);
    const OcclusionMemory::Plane& plane = memory_.planes[static_cast<std::size_t>(label)];
    const int edge = direction > 0 ? end(run) - 1 : begin(run);
    const int reach = static_cast<int>(2.0 * max_occluder_ * lengthOf(run));
    bool occluded = false;
    int hidden = 0;
    for (int next = run + direction; next >= 0 && next < runs_; next += direction) {
      const std::int32_t other = labelOf(next);
      if (other == label) return;
      const int last = std::min(hidden + lengthOf(next) - 1, reach);
      for (; hidden <= last; ++hidden) {
        const int i = edge + direction * (hidden + 1);
        const Place place = placeOf(i, plane);
        if (place == Place::Behind) return;
        occluded |= place == Place::InFront;
        if (place == Place::InFront || other == 0) continue;
        const int seen = direction > 0 ? end(next) - i : i + 1 - begin(next);
        if (occluded) meet(run, direction, edge, i, seen, hidden);
        return;
      }
      if (hidden > reach) return;
    }
  }

  /// Two runs on one plane, seen from `edge` and `i` outwards, with `hidden` pixels between them.
  void meet(int run, int direction, int edge, int i, int seen, int hidden) {
    const int length = lengthOf(run);
    const bool longer = direction > 0 ? seen <= length : seen < length;
    if (!longer || hidden > max_occluder_ * (length + seen)) return;
    const Pixel a = pixelAt(edge), b = pixelAt(i);
    places_->push_back({a.row, a.column, b.row, b.column, hidden});
  }

  Place placeOf(int i, const OcclusionMemory::Plane& plane) const {
    const auto index = static_cast<std::size_t>(first_ + i * stride_);
    const auto w = static_cast<double>(image_.w[index]);
    if (!(w > 0.0)) return Place::Behind;  // a hole is no occluder
    const Pixel p = pixelAt(i);
    const auto column = static_cast<std::size_t>(p.column);
    const double error =
        w - (plane.x * image_.across[column] + plane.y * image_.along[static_cast<std::size_t>(p.row)] +
             plane.z * image_.forward[column]);
    if (error * error * static_cast<double>(image_.weight[index]) <= plane.max_square) return Place::On;
    return error > 0.0 ? Place::InFront : Place::Behind;
  }

  const InverseDepthImage& image_;
  double max_occluder_;
  const std::int32_t* labels_;
  const OcclusionMemory& memory_;
  OcclusionMemory::Band& band_;
  std::vector<OcclusionMemory::Place>* places_ = nullptr;  // of the lines that are walked
  Pixel line_start_{0, 0}, line_step_{0, 1};               // the line that is walked
  std::ptrdiff_t first_ = 0, stride_ = 1;                  // the same, of the pixels
  const int* begins_ = nullptr;                            // of its runs, and the line's end
  int runs_ = 0;
};

/// Brings the beginnings of runs on columns from the order of rows into that of columns.
void sortBegins(int lines, OcclusionMemory& memory) {
  std::vector<int>& first = memory.first_of_column;
  first.assign(static_cast<std::size_t>(lines) + 1, 0);
  for (const OcclusionMemory::Band& band : memory.bands)
    for (const OcclusionMemory::Begin& begin : band.begins_on_columns) ++first[static_cast<std::size_t>(begin.line)];
  int sum = 0;
  for (int& count : first) {
    sum += count;
    count = sum;
  }
  memory.sorted_begins.resize(static_cast<std::size_t>(sum));
  for (auto band = memory.bands.rbegin(); band != memory.bands.rend(); ++band)
    for (auto begin = band->begins_on_columns.rbegin(); begin != band->begins_on_columns.rend(); ++begin)
      memory.sorted_begins[static_cast<std::size_t>(--first[static_cast<std::size_t>(begin->line)])] = begin->row;
}

}  // namespace

void findOccludedContacts(const InverseDepthImage& image, int bridge, double max_occluder, double residual,
                          const RegionMap& map, OcclusionMemory& memory, RegionContacts& contacts, int threads) {
  memory.planes.assign(1, OcclusionMemory::Plane());
  for (const PlaneMoments& region : map.regions) {
    const RegionPlane plane(region);
    memory.planes.push_back({plane.q.x(), plane.q.y(), plane.q.z(), residual * residual * plane.slope_factor});
  }
  memory.bands.resize(kWalkedBands);
  const auto walk = [&](int lines, void (OcclusionWalk::*walkBand)(int, int)) {
    sharedFor(kWalkedBands, threads, [&](int /*thread*/, int first, int end) {
      for (int k = first; k < end; ++k) {
        OcclusionWalk band(image, max_occluder, map, memory, memory.bands[static_cast<std::size_t>(k)]);
        (band.*walkBand)(lines * k / kWalkedBands, lines * (k + 1) / kWalkedBands);
      }
    });
  };
  walk(image.height, &OcclusionWalk::walkRows);
  const int columns = (image.width + kLineStep - 1) / kLineStep;
  sortBegins(columns, memory);
  walk(columns, &OcclusionWalk::walkColumns);

  // Of regions that touch, a few pixels of the one along the border are in front of the other's plane if the error is
  // as large as the step between them. That is no occluder, and S4 has judged them.
  contacts.clear();
  const auto add = [&](const std::vector<OcclusionMemory::Place>& places, bool wide) {
    for (const auto& [row, column, other_row, other_column, hidden] : places) {
      if ((hidden > bridge) != wide) continue;
      const RegionPair pair(map.labels[image.index(row, column)], map.labels[image.index(other_row, other_column)]);
      if (wide || contacts.find(pair) != nullptr) contacts[pair].add(image, row, column, other_row, other_column);
    }
  };
  for (const bool wide : {true, false}) {
    for (const OcclusionMemory::Band& band : memory.bands) add(band.on_rows, wide);
    for (const OcclusionMemory::Band& band : memory.bands) add(band.on_columns, wide);
  }
}

}  // namespace epcc
