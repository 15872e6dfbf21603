// SPDX-License-Identifier: BSD-3-Clause
// Beams meet faces and circles.
#include "datasets/rendered/floor_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/support/scene_random.h"

namespace epcc {
namespace {

constexpr double kWall = 0.12;      // thickness, metres
constexpr double kClearance = 0.6;  // of the path, metres
constexpr double kPi = 3.14159265358979323846;

double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The four sides of a box, turned by `angle` about its centre.
void addBox(FloorPlan& plan, const Vector2& centre, double width, double depth, double angle) {
  const Vector2 u(0.5 * width * std::cos(angle), 0.5 * width * std::sin(angle));
  const Vector2 v(-0.5 * depth * std::sin(angle), 0.5 * depth * std::cos(angle));
  const Vector2 corners[] = {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
  for (int i = 0; i < 4; ++i) plan.faces.push_back({corners[i], corners[(i + 1) % 4]});
}

/// A wall along an axis between two points.
void addWall(FloorPlan& plan, const Vector2& from, const Vector2& to) {
  const Vector2 size = (to - from).cwiseAbs();
  addBox(plan, 0.5 * (from + to), std::max(size.x(), kWall), std::max(size.y(), kWall), 0.0);
}

/// Through both corridors' ends and into every room.
const std::vector<Vector2>& path() {
  static const std::vector<Vector2> points = {{1.0, 4.5},  {3.0, 4.5},  {3.0, 1.6},  {3.0, 4.4}, {2.6, 4.6},
                                              {2.6, 7.4},  {2.6, 4.5},  {9.4, 4.5},  {9.4, 1.5}, {9.4, 4.5},
                                              {10.4, 4.6}, {10.4, 7.2}, {10.4, 4.5}, {13.0, 4.5}};
  return points;
}

double distanceToPath(const Vector2& point) {
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < path().size(); ++i) {
    const Vector2 from = path()[i - 1], step = path()[i] - from;
    const double t = std::clamp((point - from).dot(step) / step.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - from - t * step).norm());
  }
  return nearest;
}

struct Hit {
  double range = std::numeric_limits<double>::infinity();
  int face = -1;  // -1: nothing, or a pillar
};

Hit castBeam(const FloorPlan& plan, const Vector2& origin, double angle) {
  const Vector2 direction(std::cos(angle), std::sin(angle));
  Hit hit;
  for (std::size_t i = 0; i < plan.faces.size(); ++i) {
    const Vector2 side = plan.faces[i].to - plan.faces[i].from, offset = plan.faces[i].from - origin;
    const double turn = cross(direction, side);
    if (turn == 0.0) continue;
    const double range = cross(offset, side) / turn, along = cross(offset, direction) / turn;
    if (range <= 0.0 || range >= hit.range || along < 0.0 || along > 1.0) continue;
    hit.range = range;
    hit.face = static_cast<int>(i);
  }
  for (const FloorPillar& pillar : plan.pillars) {
    const Vector2 offset = pillar.centre - origin;
    const double along = offset.dot(direction);
    const double inside = pillar.radius * pillar.radius - (offset.squaredNorm() - along * along);
    if (inside < 0.0) continue;
    const double range = along - std::sqrt(inside);
    if (range > 0.0 && range < hit.range) hit = {range, -1};
  }
  return hit;
}

/// Where the face is lost between a beam that hits it and its neighbour, in the frame of the plan.
Vector2 visibleEnd(const FloorPlan& plan, const Vector2& origin, int face, double inside, double outside) {
  for (int step = 0; step < 50; ++step) {
    const double middle = 0.5 * (inside + outside);
    (castBeam(plan, origin, middle).face == face ? inside : outside) = middle;
  }
  const Hit hit = castBeam(plan, origin, inside);
  return origin + hit.range * Vector2(std::cos(inside), std::sin(inside));
}

/// A point of the plan in the frame of the sensor.
Vector2 toSensor(const LaserPose& pose, const Vector2& point) {
  const LaserPose turn{0.0, 0.0, -pose.theta};
  return turn.toWorld(point - Vector2(pose.x, pose.y));
}

/// The first beam, from one end on, that is followed by two of its neighbours; the first one of all if there is none.
template <typename Iterator>
int endBeam(Iterator first, Iterator last, int beams) {
  const auto areNeighbours = [&](int a, int b) {
    const int apart = std::abs(a - b);
    return apart == 1 || apart == beams - 1;
  };
  for (Iterator i = first; last - i >= 3; ++i)
    if (areNeighbours(i[0], i[1]) && areNeighbours(i[1], i[2])) return *i;
  return *first;
}

void describeFace(const FloorPlan& plan, const LaserPose& pose, const LaserScan& scan, SeenFace& seen) {
  const FloorFace& face = plan.faces[static_cast<std::size_t>(seen.face)];
  const Vector2 origin(pose.x, pose.y);
  const auto angleOf = [&](int beam) { return pose.theta + scan.angle_min + beam * scan.angle_increment; };
  // Angles as seen from the face's middle, so that the seam of the scan does not matter.
  const Vector2 middle = 0.5 * (face.from + face.to) - origin;
  const double heading = std::atan2(middle.y(), middle.x());
  const auto place = [&](int beam) { return std::remainder(angleOf(beam) - heading, 2.0 * kPi); };
  std::sort(seen.beams.begin(), seen.beams.end(), [&](int a, int b) { return place(a) < place(b); });
  const double step = std::abs(scan.angle_increment);
  const bool circle = scan.isFullCircle();
  const int beams = static_cast<int>(scan.ranges.size());
  const int first_beam = endBeam(seen.beams.begin(), seen.beams.end(), beams);
  const int last_beam = endBeam(seen.beams.rbegin(), seen.beams.rend(), beams);
  const double first = angleOf(first_beam), last = angleOf(last_beam);
  const auto isEdge = [&](int beam) { return !circle && (beam == 0 || beam + 1 == beams); };
  const auto endOf = [&](int beam, double inside, double outside) {
    return visibleEnd(plan, origin, seen.face, inside, isEdge(beam) ? inside : outside);
  };
  seen.start = toSensor(pose, endOf(first_beam, first, first - step));
  seen.end = toSensor(pose, endOf(last_beam, last, last + step));
  const Vector2 from = toSensor(pose, face.from), side = (toSensor(pose, face.to) - from).normalized();
  Vector2 normal(-side.y(), side.x());
  if (normal.dot(from) < 0.0) normal = -normal;
  seen.alpha = std::atan2(normal.y(), normal.x());
  seen.rho = normal.dot(from);
}

}  // namespace

LaserSensor LaserSensor::halfCircle() {
  LaserSensor sensor;
  sensor.beams = 181;
  sensor.angle_min = -0.5 * kPi;
  sensor.angle_increment = kPi / 180.0;
  return sensor;
}

FloorPlan officeFloor(std::uint64_t seed) {
  FloorPlan plan;
  const Vector2 outer[] = {{0.0, 0.0}, {14.0, 0.0}, {14.0, 9.0}, {0.0, 9.0}};
  for (int i = 0; i < 4; ++i) plan.faces.push_back({outer[i], outer[(i + 1) % 4]});
  // The corridor runs from y = 3.5 to 5.5; its walls have two doors each.
  const double lower_doors[] = {2.5, 3.5, 9.0, 10.0}, upper_doors[] = {2.1, 3.1, 9.9, 10.9};
  for (const auto& [y, doors] : {std::pair(3.5, lower_doors), std::pair(5.5, upper_doors)}) {
    addWall(plan, {0.0, y}, {doors[0], y});
    addWall(plan, {doors[1], y}, {doors[2], y});
    addWall(plan, {doors[3], y}, {14.0, y});
  }
  addWall(plan, {6.5, 0.0}, {6.5, 3.5});
  addWall(plan, {7.2, 5.5}, {7.2, 9.0});
  addBox(plan, {5.0, 5.3}, 0.4, 0.4, 0.0);  // square pillars
  addBox(plan, {12.0, 3.7}, 0.4, 0.4, 0.0);
  plan.pillars = {{{4.4, 1.2}, 0.2}, {{11.6, 2.2}, 0.25}, {{5.2, 7.4}, 0.15}, {{12.6, 7.6}, 0.2}};

  SceneRandom random(seed, 71);
  for (int boxes = 0; boxes < 12;) {
    const Vector2 centre(random.uniform(0.5, 13.5), random.uniform(0.5, 8.5));
    const double width = random.uniform(0.3, 1.0), depth = random.uniform(0.3, 0.8), angle = random.uniform(0.0, kPi);
    if (std::abs(centre.y() - 4.5) < 1.9 || distanceToPath(centre) < kClearance + 0.5) continue;
    addBox(plan, centre, width, depth, angle);
    ++boxes;
  }
  return plan;
}

FloorScan scanFloor(const FloorPlan& plan, const LaserSensor& sensor, const LaserPose& pose, std::uint64_t seed) {
  FloorScan result;
  LaserScan& scan = result.record.scan;
  scan.angle_min = sensor.angle_min;
  scan.angle_increment = sensor.angle_increment;
  scan.range_max = sensor.range_max;
  scan.ranges.resize(static_cast<std::size_t>(sensor.beams));
  result.record.pose = pose;
  result.labels.assign(scan.ranges.size(), 0);
  std::vector<int> number(plan.faces.size(), 0);
  SceneRandom random(seed, 72);
  for (int beam = 0; beam < sensor.beams; ++beam) {
    const auto at = static_cast<std::size_t>(beam);
    const Hit hit = castBeam(plan, {pose.x, pose.y}, pose.theta + scan.angle(at));
    const double error = random.normal();  // of every beam, so that noise does not depend on what is seen
    if (!(hit.range < sensor.range_max)) {
      scan.ranges[at] = sensor.range_max;
      continue;
    }
    scan.ranges[at] = hit.range + (sensor.noise_a + sensor.noise_b * hit.range) * error;
    if (hit.face < 0) continue;
    int& label = number[static_cast<std::size_t>(hit.face)];
    if (label == 0) {
      result.faces.push_back({hit.face, {}, Vector2::Zero(), Vector2::Zero(), 0.0, 0.0});
      label = static_cast<int>(result.faces.size());
    }
    result.labels[at] = label;
    result.faces[static_cast<std::size_t>(label - 1)].beams.push_back(beam);
  }
  for (SeenFace& seen : result.faces) describeFace(plan, pose, scan, seen);
  return result;
}

std::vector<FloorScan> scanOffice(const LaserSensor& sensor, int count, std::uint64_t seed) {
  const FloorPlan plan = officeFloor(seed);
  double length = 0.0;
  for (std::size_t i = 1; i < path().size(); ++i) length += (path()[i] - path()[i - 1]).norm();
  std::vector<FloorScan> scans;
  SceneRandom random(seed, 73);
  for (int k = 0; k < count; ++k) {
    double left = length * (k + 0.5) / count;
    std::size_t i = 1;
    for (; i + 1 < path().size() && left > (path()[i] - path()[i - 1]).norm(); ++i)
      left -= (path()[i] - path()[i - 1]).norm();
    const Vector2 step = (path()[i] - path()[i - 1]).normalized(), at = path()[i - 1] + left * step;
    const LaserPose pose{at.x(), at.y(), std::atan2(step.y(), step.x()) + random.uniform(-0.3, 0.3)};
    scans.push_back(scanFloor(plan, sensor, pose, seed * 100003 + static_cast<std::uint64_t>(k)));
    scans.back().record.timestamp = 0.5 * k;
  }
  return scans;
}

}  // namespace epcc
