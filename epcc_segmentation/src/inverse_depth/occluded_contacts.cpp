// SPDX-License-Identifier: BSD-3-Clause
// Finds regions on both sides of an occluder by walking along rows and columns.
#include "inverse_depth/region_contacts.h"

#include <algorithm>
#include <cstddef>

namespace epcc {

namespace {

/// Every other line will do: contacts come in long rows.
constexpr int kLineStep = 2;

/// Looks from both ends of a run of labels along its line, behind what is in front of the run's plane.
class OcclusionWalk {
 public:
  OcclusionWalk(const InverseDepthImage& image, double max_occluder, double residual, const RegionMap& map,
                RegionContacts& contacts)
      : image_(image),
        max_occluder_(max_occluder),
        residual_(residual),
        map_(map),
        planes_(map.regions.begin(), map.regions.end()),
        contacts_(contacts) {}

  void walkLines() {
    for (int row = 0; row < image_.height; row += kLineStep) walkLine({row, 0}, {0, 1}, image_.width);
    for (int column = 0; column < image_.width; column += kLineStep) walkLine({0, column}, {1, 0}, image_.height);
  }

 private:
  struct Pixel {
    int row, column;
  };
  enum class Place { InFront, On, Behind };

  void walkLine(Pixel start, Pixel step, int length) {
    line_start_ = start;
    line_step_ = step;
    length_ = length;
    labels_ = map_.labels.data() + image_.index(start.row, start.column);
    stride_ = step.row * image_.width + step.column;
    for (int begin = 0, end = 0; begin < length; begin = end + 1) {
      end = begin + runLength(begin, 1, length) - 1;
      if (labelAt(begin) == 0) continue;
      lookBehind(end, 1, end - begin + 1);
      lookBehind(begin, -1, end - begin + 1);
    }
  }

  /// Adds a contact if the run that ends at `edge` goes on behind what comes next in `direction`. The longer of two
  /// runs looks for the other, no farther than an occluder of the two can reach: the walks along a line are no longer
  /// than a few lines together.
  void lookBehind(int edge, int direction, int run) {
    const std::int32_t label = labelAt(edge);
    const int reach = static_cast<int>(2.0 * max_occluder_ * run);
    bool occluded = false;
    for (int hidden = 0; hidden <= reach; ++hidden) {
      const int i = edge + direction * (hidden + 1);
      if (i < 0 || i >= length_ || labelAt(i) == label) return;
      const Place place = placeOf(i, label);
      if (place == Place::Behind) return;
      occluded |= place == Place::InFront;
      if (place == Place::InFront || labelAt(i) == 0) continue;
      const int other = runLength(i, direction, run + 1);
      const bool longer = direction > 0 ? other <= run : other < run;
      if (occluded && longer && hidden <= max_occluder_ * (run + other)) addContact(edge, i);
      return;
    }
  }

  /// Pixels of one label from `i` on, counted up to `most`.
  int runLength(int i, int direction, int most) const {
    const std::int32_t label = labelAt(i);
    const int end = std::min(most, direction > 0 ? length_ - i : i + 1);
    int count = 1;
    while (count < end && labelAt(i + direction * count) == label) ++count;
    return count;
  }

  void addContact(int i, int j) {
    const Pixel a = pixelAt(i), b = pixelAt(j);
    contacts_[RegionPair(labelAt(i), labelAt(j))].add(image_, a.row, a.column, b.row, b.column);
  }

  Pixel pixelAt(int i) const {
    return {line_start_.row + i * line_step_.row, line_start_.column + i * line_step_.column};
  }
  std::int32_t labelAt(int i) const { return labels_[static_cast<std::ptrdiff_t>(i) * stride_]; }

  Place placeOf(int i, std::int32_t label) const {
    const Pixel p = pixelAt(i);
    const std::size_t index = image_.index(p.row, p.column);
    const auto w = static_cast<double>(image_.w[index]);
    if (!(w > 0.0)) return Place::Behind;  // a hole is no occluder
    const RegionPlane& plane = planes_[static_cast<std::size_t>(label) - 1];
    const double error = w - plane.q.dot(image_.ray(p.row, p.column));
    if (error * error * static_cast<double>(image_.weight[index]) <= residual_ * residual_ * plane.slope_factor)
      return Place::On;
    return error > 0.0 ? Place::InFront : Place::Behind;
  }

  const InverseDepthImage& image_;
  double max_occluder_;
  double residual_;
  const RegionMap& map_;
  std::vector<RegionPlane> planes_;
  RegionContacts& contacts_;
  Pixel line_start_{0, 0}, line_step_{0, 1};  // the line that is walked
  int length_ = 0;
  const std::int32_t* labels_ = nullptr;
  std::ptrdiff_t stride_ = 1;
};

}  // namespace

void findOccludedContacts(const InverseDepthImage& image, double max_occluder, double residual, const RegionMap& map,
                          RegionContacts& contacts) {
  contacts.clear();
  OcclusionWalk(image, max_occluder, residual, map, contacts).walkLines();
}

}  // namespace epcc
