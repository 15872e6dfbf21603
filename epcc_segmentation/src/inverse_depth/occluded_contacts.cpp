// SPDX-License-Identifier: BSD-3-Clause
// Walks along rows and columns behind what is in front.
#include "inverse_depth/region_contacts.h"
#include "inverse_depth/region_merging.h"

namespace epcc {

namespace {

/// Every other line will do: contacts come in long rows.
constexpr int kLineStep = 2;

/// Looks from the end of a run of labels along its line, behind what is in front of the run's plane.
class OcclusionWalk {
 public:
  OcclusionWalk(const InverseDepthImage& image, double max_occluder, double residual, const RegionMap& map,
                RegionContacts& contacts)
      : image_(image),
        max_occluder_(max_occluder),
        residual_(residual),
        map_(map),
        planes_(map.regions.size()),
        contacts_(contacts) {
    for (std::size_t k = 0; k < map.regions.size(); ++k) {
      const PlaneMoments& region = map.regions[k];
      if (region.n <= 0.0) continue;
      planes_[k].q = region.fit(weakRidge(region)).q;
      planes_[k].slope_factor = slopeFactor(planes_[k].q, region.meanW());
    }
  }

  void walkLines() {
    for (int row = 0; row < image_.height; row += kLineStep) walkLine({row, 0}, {0, 1}, image_.width);
    for (int column = 0; column < image_.width; column += kLineStep) walkLine({0, column}, {1, 0}, image_.height);
  }

 private:
  struct Pixel {
    int row, column;
  };
  struct Plane {
    Eigen::Vector3d q = Eigen::Vector3d::Zero();
    double slope_factor = 1.0;
  };
  enum class Place { InFront, On, Behind };

  void walkLine(Pixel start, Pixel step, int length) {
    line_start_ = start;
    line_step_ = step;
    length_ = length;
    int run_begin = 0;
    for (int i = 0; i + 1 < length; ++i) {
      const std::int32_t label = labelAt(i);
      if (labelAt(i + 1) == label) continue;
      if (label != 0) lookBehind(label, run_begin, i);
      run_begin = i + 1;
    }
  }

  /// Adds a contact if the run [begin, end] of `label` goes on behind what comes next.
  void lookBehind(std::int32_t label, int begin, int end) {
    for (int i = end + 1; i < length_; ++i) {
      const std::int32_t here = labelAt(i);
      const Place place = here == label ? Place::Behind : placeOf(i, label);
      if (place == Place::Behind) return;
      if (place == Place::InFront || here == 0) continue;
      const int seen = end + 1 - begin + runFrom(i);
      if (i - end - 1 <= max_occluder_ * seen) addContact(end, i);
      return;
    }
  }

  int runFrom(int begin) const {
    int end = begin + 1;
    while (end < length_ && labelAt(end) == labelAt(begin)) ++end;
    return end - begin;
  }

  void addContact(int i, int j) {
    const Pixel a = pixelAt(i), b = pixelAt(j);
    contacts_[RegionPair(labelAt(i), labelAt(j))].add(image_, a.row, a.column, b.row, b.column);
  }

  Pixel pixelAt(int i) const {
    return {line_start_.row + i * line_step_.row, line_start_.column + i * line_step_.column};
  }
  std::size_t indexOf(Pixel p) const {
    return static_cast<std::size_t>(p.row) * static_cast<std::size_t>(image_.width) +
           static_cast<std::size_t>(p.column);
  }
  std::int32_t labelAt(int i) const { return map_.labels[indexOf(pixelAt(i))]; }

  Place placeOf(int i, std::int32_t label) const {
    const Pixel p = pixelAt(i);
    const double w = static_cast<double>(image_.w[indexOf(p)]);
    if (!(w > 0.0)) return Place::Behind;  // a hole is no occluder
    const Plane& plane = planes_[static_cast<std::size_t>(label) - 1];
    const double error = w - plane.q.dot(image_.ray(p.row, p.column));
    if (error * error <= residual_ * residual_ * image_.variance(w, p.row) * plane.slope_factor) return Place::On;
    return error > 0.0 ? Place::InFront : Place::Behind;
  }

  const InverseDepthImage& image_;
  double max_occluder_;
  double residual_;
  const RegionMap& map_;
  std::vector<Plane> planes_;
  RegionContacts& contacts_;
  Pixel line_start_{0, 0}, line_step_{0, 1};  // the line that is walked
  int length_ = 0;
};

}  // namespace

RegionContacts findOccludedContacts(const InverseDepthImage& image, double max_occluder, double residual,
                                    const RegionMap& map) {
  RegionContacts contacts;
  OcclusionWalk(image, max_occluder, residual, map, contacts).walkLines();
  return contacts;
}

}  // namespace epcc
