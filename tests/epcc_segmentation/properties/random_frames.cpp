// SPDX-License-Identifier: BSD-3-Clause
// Planes seen by cameras and scanners, rough clouds, and what sensors and programs spoil.
#include "tests/epcc_segmentation/properties/random_frames.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/epcc_segmentation/properties/property_case.h"

namespace epcc::test {

namespace {

constexpr double kSigmaGrowth = 0.5;  // of the noise at a metre, per square metre
constexpr double kFarthest = 50.0;    // metres

/// Numbers from 0 to 1 and of the normal distribution.
class Dice {
 public:
  explicit Dice(unsigned seed) : generator_(seed) {}
  double share() { return std::uniform_real_distribution<double>()(generator_); }
  double within(double low, double high) { return low + (high - low) * share(); }
  bool percent(double p) { return share() < 0.01 * p; }
  double normal() { return std::normal_distribution<double>()(generator_); }

 private:
  std::mt19937 generator_;
};

/// A plane n . p = offset with the pixels that it may be seen at.
struct Patch {
  Eigen::Vector3d normal;
  double offset = 0.0;
  double row = 0.0, column = 0.0, rows = 0.0, columns = 0.0;  // an ellipse of the image; without rows: everywhere

  bool isAt(int r, int c) const {
    if (rows <= 0.0) return true;
    return std::pow((r - row) / rows, 2) + std::pow((c - column) / columns, 2) <= 1.0;
  }
};

/// Rays on which the measured value, z or the range, is 1.
class Rays {
 public:
  Rays(const FrameSpec& spec, const PinholeCamera& camera, double turn) : spec_(spec), camera_(camera), turn_(turn) {}
  Eigen::Vector3d at(int row, int column) const {
    if (spec_.kind == FrameKind::Scanner) {
      const double azimuth = -turn_ * column / spec_.width;
      const double elevation = 0.35 - 0.8 * (row + 0.5) / spec_.height;
      return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
    }
    const double x = (column - camera_.cx) / camera_.fx, y = (row - camera_.cy) / camera_.fy;
    return spec_.kind == FrameKind::BackwardCloud ? Eigen::Vector3d(x, -y, -1.0) : Eigen::Vector3d(x, y, 1.0);
  }

 private:
  const FrameSpec& spec_;
  const PinholeCamera& camera_;
  double turn_;
};

std::vector<Patch> randomPatches(const FrameSpec& spec, const Rays& rays, Dice& dice) {
  std::vector<Patch> patches;
  for (int k = 0; k <= spec.planes; ++k) {
    Patch patch;
    patch.row = dice.within(0.0, spec.height);
    patch.column = dice.within(0.0, spec.width);
    const Eigen::Vector3d ray = rays.at(static_cast<int>(patch.row), static_cast<int>(patch.column));
    patch.normal = Eigen::Vector3d(dice.normal(), dice.normal(), dice.normal()).normalized() + 1.2 * ray.normalized();
    patch.normal.normalize();
    patch.offset = dice.within(0.4, k == 0 ? 8.0 : 4.0) * patch.normal.dot(ray);
    if (k > 0) {
      patch.rows = dice.within(0.1, 0.6) * spec.height;
      patch.columns = dice.within(0.1, 0.6) * spec.width;
    }
    patches.push_back(patch);
  }
  return patches;
}

double nearestOf(const std::vector<Patch>& patches, const Eigen::Vector3d& ray, int row, int column) {
  double nearest = kFarthest;
  for (const Patch& patch : patches) {
    if (!patch.isAt(row, column)) continue;
    const double value = patch.offset / patch.normal.dot(ray);
    if (value > 0.05 && value < nearest) nearest = value;
  }
  return nearest < kFarthest ? nearest : 0.0;
}

/// What a sensor measures, z or range, 0 where nothing is.
std::vector<double> measuredValues(const FrameSpec& spec, const Rays& rays, const SensorModel& sensor, Dice& dice) {
  const std::vector<Patch> patches = randomPatches(spec, rays, dice);
  const double hills = dice.within(0.02, 1.0), period = dice.within(2.0, 40.0), clutter = dice.share();
  std::vector<double> values;
  double walk = 2.0;
  for (int row = 0; row < spec.height; ++row)
    for (int column = 0; column < spec.width; ++column) {
      double value = nearestOf(patches, rays.at(row, column), row, column);
      if (spec.scene == Scene::Rough) {
        walk = std::min(8.0, std::max(0.3, walk + 0.05 * dice.normal()));
        value = clutter < 0.3   ? dice.within(0.3, 8.0)
                : clutter < 0.6 ? walk
                                : 2.0 + hills * std::sin(row / period) * std::cos(column / period);
      }
      if (value > 0.0) value += sensor.sigmaZ(value) * dice.normal();
      values.push_back(dice.percent(spec.holes) ? 0.0 : value);
    }
  return values;
}

/// In stretches as well as one by one, as shadows and grain do it.
void spoil(std::vector<float>& numbers, Dice& dice) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float odd[] = {std::numeric_limits<float>::quiet_NaN(),
                       kInfinity,
                       -kInfinity,
                       0.0f,
                       -0.0f,
                       -1.0f,
                       1e-42f,
                       1e-38f,
                       1e-20f,
                       1e18f,
                       3e38f,
                       -3e38f,
                       65.535f};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (dice.percent(8.0)) {
      const float value = odd[static_cast<std::size_t>(dice.share() * std::size(odd))];
      const auto end = std::min(numbers.size(), i + (dice.percent(10.0) ? 40U : 1U));
      for (; i < end; ++i) numbers[i] = value;
    }
}

PinholeCamera randomCamera(const FrameSpec& spec, Dice& dice) {
  const double focus = dice.within(0.4, 1.5) * std::max(spec.width, spec.height);
  return {spec.width,
          spec.height,
          focus,
          focus * dice.within(0.9, 1.1),
          dice.within(0.3, 0.7) * spec.width,
          dice.within(0.3, 0.7) * spec.height};
}

}  // namespace

RandomFrame::RandomFrame(const FrameSpec& of) : spec(of) {
  noteCase(rc::toString(spec));
  Dice dice(spec.seed);
  camera = randomCamera(spec, dice);
  closes_round = spec.kind == FrameKind::Scanner && dice.percent(50.0);
  const Rays rays(spec, camera, closes_round ? 2.0 * M_PI : dice.within(0.5, 6.0));
  const std::vector<double> values = measuredValues(spec, rays, sensor(), dice);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (spec.kind == FrameKind::Depth) depth.push_back(static_cast<float>(values[i]));
    if (spec.kind == FrameKind::WholeNumbers) {
      const double mm = std::min(65535.0, std::max(0.0, std::round(1000.0 * values[i])));
      const bool is_odd = spec.scene == Scene::Wild && dice.percent(10.0);
      units.push_back(static_cast<std::uint16_t>(is_odd ? (dice.percent(50.0) ? 65535.0 : dice.within(0.0, 3.0)) : mm));
    }
    if (!isCloud()) continue;
    const int row = static_cast<int>(i) / spec.width, column = static_cast<int>(i) % spec.width;
    const Eigen::Vector3d point = values[i] * rays.at(row, column);
    for (int k = 0; k < 3; ++k) xyz.push_back(values[i] > 0.0 ? static_cast<float>(point(k)) : NAN);
  }
  if (spec.kind == FrameKind::BackwardCloud) projection = Projection::PerspectiveBackward;
  if (spec.kind == FrameKind::Scanner) projection = Projection::Spherical;
  if (spec.scene == Scene::Wild) {
    spoil(depth, dice);
    spoil(xyz, dice);
  }
  if (!spec.masked) return;
  for (std::size_t i = 0; i < values.size(); ++i) mask.push_back(dice.percent(85.0) ? 1 : 0);
}

SensorModel RandomFrame::sensor() const {
  const double a = std::max(1e-6, 1e-4 * spec.noise);  // 0 is no model
  return SensorModel::axial(a, kSigmaGrowth * a);
}

DepthFrame RandomFrame::frame() const {
  DepthFrame view =
      isCloud() ? DepthFrame::fromPoints(xyz.data(), 3, spec.width, spec.height, projection)
      : spec.kind == FrameKind::Depth
          ? DepthFrame::fromDepth(depth.data(), camera)
          : DepthFrame::fromDepth(DepthView<std::uint16_t>{units.data(), spec.width, spec.height}, camera);
  if (closes_round) view = view.closedRound();
  return mask.empty() ? view : view.masked(mask.data());
}

bool RandomFrame::isValid(std::size_t pixel) const {
  if (!mask.empty() && mask[pixel] == 0) return false;
  if (spec.kind == FrameKind::WholeNumbers) return units[pixel] != 0 && units[pixel] != 65535;
  if (spec.kind == FrameKind::Depth) return std::isfinite(depth[pixel]) && depth[pixel] > 0.0f;
  const Eigen::Vector3f point = Eigen::Map<const Eigen::Vector3f>(&xyz[3 * pixel]);
  if (!point.allFinite()) return false;
  if (spec.kind == FrameKind::Cloud) return point.z() > 0.0f;
  return spec.kind == FrameKind::BackwardCloud ? point.z() < 0.0f : !point.isZero(0.0f);
}

std::ostream& operator<<(std::ostream& out, const FrameSpec& spec) {
  const char* const kinds[] = {"Depth", "WholeNumbers", "Cloud", "BackwardCloud", "Scanner"};
  const char* const scenes[] = {"Planes", "Rough", "Wild"};
  return out << "FrameSpec{FrameKind::" << kinds[static_cast<int>(spec.kind)]
             << ", Scene::" << scenes[static_cast<int>(spec.scene)] << ", " << spec.width << ", " << spec.height
             << ", /* seed */ " << spec.seed << "u, " << spec.planes << ", " << spec.noise << ", " << spec.holes << ", "
             << (spec.masked ? "true" : "false") << "}";
}

Parameters Way::parameters() const {
  Parameters parameters = mode == Mode::Paper ? Parameters::forPaper() : Parameters();
  parameters.scan = scan;
  parameters.threads = threads;
  parameters.inverse_depth.stride = stride;
  parameters.inverse_depth.adapt_sensor = adapts;
  return parameters;
}

std::ostream& operator<<(std::ostream& out, const Way& way) {
  const char* const scans[] = {"Columns", "Rows", "Both"};
  return out << "Way{Mode::" << (way.mode == Mode::Paper ? "Paper" : "InverseDepth") << ", "
             << (way.is_measured ? "true" : "false") << ", ScanDirection::" << scans[static_cast<int>(way.scan)] << ", "
             << way.stride << ", " << way.threads << ", " << (way.adapts ? "true" : "false") << "}";
}

rc::Gen<FrameSpec> anyFrame(std::vector<FrameKind> kinds) {
  using rc::gen::inRange;
  return rc::gen::build<FrameSpec>(
      rc::gen::set(&FrameSpec::kind, rc::gen::elementOf(std::move(kinds))),
      rc::gen::set(&FrameSpec::scene,
                   rc::gen::weightedElement<Scene>({{4, Scene::Planes}, {2, Scene::Rough}, {2, Scene::Wild}})),
      rc::gen::set(&FrameSpec::width, inRange(1, 100)), rc::gen::set(&FrameSpec::height, inRange(1, 80)),
      rc::gen::set(&FrameSpec::seed, rc::gen::arbitrary<unsigned>()), rc::gen::set(&FrameSpec::planes, inRange(0, 8)),
      rc::gen::set(&FrameSpec::noise, inRange(0, 120)), rc::gen::set(&FrameSpec::holes, inRange(0, 40)),
      rc::gen::set(&FrameSpec::masked));
}

rc::Gen<FrameSpec> planarFrame(std::vector<FrameKind> kinds) {
  using rc::gen::inRange;
  return rc::gen::build<FrameSpec>(
      rc::gen::set(&FrameSpec::kind, rc::gen::elementOf(std::move(kinds))),
      rc::gen::set(&FrameSpec::width, inRange(48, 120)), rc::gen::set(&FrameSpec::height, inRange(40, 90)),
      rc::gen::set(&FrameSpec::seed, rc::gen::arbitrary<unsigned>()), rc::gen::set(&FrameSpec::planes, inRange(0, 5)),
      rc::gen::set(&FrameSpec::noise, inRange(2, 40)), rc::gen::set(&FrameSpec::holes, inRange(0, 10)));
}

rc::Gen<Way> anyWay(FrameKind kind) {
  using rc::gen::inRange;
  using rc::gen::set;
  std::vector<ScanDirection> scans{ScanDirection::Both, ScanDirection::Columns};
  if (kind != FrameKind::Scanner) scans.push_back(ScanDirection::Rows);
  return rc::gen::build<Way>(set(&Way::mode, rc::gen::element(Mode::InverseDepth, Mode::Paper)), set(&Way::is_measured),
                             set(&Way::scan, rc::gen::elementOf(std::move(scans))), set(&Way::stride, inRange(0, 4)),
                             set(&Way::threads, inRange(1, 4)), set(&Way::adapts));
}

}  // namespace epcc::test
