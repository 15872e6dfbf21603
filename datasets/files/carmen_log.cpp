// SPDX-License-Identifier: BSD-3-Clause
// Messages of CARMEN, one a line.
#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/files/laser_log.h"
#include "datasets/support/degree.h"
#include "datasets/support/input_error.h"
#include "datasets/support/number_text.h"

namespace epcc {
namespace {

constexpr std::size_t kMostAtEnd = 4;  // words: two, and some room
constexpr int kFewestNothing = 10;     // beams with the same largest range

/// What is wrong with a line.
struct Damage {
  std::string what;
};

/// The words of a message, read from left to right.
class Words {
 public:
  explicit Words(std::string_view line) : words_(wordsOf(line)) {}

  std::size_t left() const { return words_.size() - at_; }
  std::string_view word(const char* name) {
    if (at_ == words_.size()) throw Damage{std::string("ends before ") + name};
    return words_[at_++];
  }
  double number(const char* name) {
    const std::string_view text = word(name);
    const auto value = numberFrom(text);
    if (!value) throw Damage{std::string(name) + " '" + std::string(text.substr(0, 40)) + "' is no number"};
    return *value;
  }
  double finite(const char* name) {
    const double value = number(name);
    if (!std::isfinite(value)) throw Damage{std::string(name) + " is not finite"};
    return value;
  }
  /// A count of words that follow.
  std::size_t count(const char* name) {
    const double value = number(name);
    if (!(value >= 0.0 && value == std::floor(value))) throw Damage{std::string(name) + " is no count"};
    if (value > static_cast<double>(std::min(left(), kMaxScanBeams)))
      throw Damage{std::string(name) + " is " + std::to_string(value).substr(0, std::to_string(value).find('.')) +
                   ", and " + std::to_string(left()) + " words follow"};
    return static_cast<std::size_t>(value);
  }
  std::vector<double> ranges(std::size_t count) {
    std::vector<double> values(count);
    for (double& value : values) value = number("a range");
    return values;
  }
  LaserPose pose() {
    LaserPose pose;
    pose.x = finite("the pose");
    pose.y = finite("the pose");
    pose.theta = finite("the pose");
    return pose;
  }
  /// Behind the timestamp stand a host and the logger's time, and no further message, which has more words than these.
  void end() const {
    if (left() > kMostAtEnd) throw Damage{std::to_string(left()) + " words follow the timestamp"};
  }
  void skip(std::size_t count, const char* name) {
    for (std::size_t i = 0; i < count; ++i) word(name);
  }

 private:
  std::vector<std::string_view> words_;
  std::size_t at_ = 1;  // behind the message's name
};

/// Of a sensor that says nothing but how many beams it has, over half a circle or 100 degrees; the first is on the
/// right.
void setUsualAngles(LaserScan& scan) {
  const std::size_t n = scan.ranges.size();
  const bool narrow = n == 401 || n == 201 || n == 101;
  const double width = narrow ? 100.0 : 180.0;
  const double spaces = static_cast<double>(n % 2 == 0 ? n : n - 1);
  scan.angle_min = -0.5 * width * kDegree;
  scan.angle_increment = width * kDegree / std::max(1.0, spaces);
}

/// FLASER n RANGES x y theta odom_x odom_y odom_theta timestamp host logger_timestamp
LaserRecord readFlaser(Words& words) {
  LaserRecord record;
  const std::size_t n = words.count("the number of readings");
  if (n == 0) throw Damage{"there are no readings"};
  record.scan.ranges = words.ranges(n);
  setUsualAngles(record.scan);
  record.pose = words.pose();
  words.skip(3, "the odometry");
  record.timestamp = words.finite("the timestamp");
  return record;
}

/// type start_angle fov resolution maximum_range accuracy remission_mode n RANGES m REMISSIONS ...
LaserRecord readSensor(Words& words) {
  LaserRecord record;
  words.word("the laser type");
  record.scan.angle_min = words.finite("the start angle");
  words.finite("the field of view");
  record.scan.angle_increment = words.finite("the angular resolution");
  record.scan.range_max = words.number("the maximum range");
  if (!(record.scan.range_max > 0.0)) throw Damage{"the maximum range is not positive"};
  words.skip(2, "the accuracy");
  const std::size_t n = words.count("the number of readings");
  if (n == 0) throw Damage{"there are no readings"};
  if (record.scan.angle_increment == 0.0) throw Damage{"the angular resolution is zero"};
  record.scan.ranges = words.ranges(n);
  words.skip(words.count("the number of remissions"), "the remissions");
  return record;
}

/// ... timestamp host logger_timestamp
LaserRecord readRawLaser(Words& words) {
  LaserRecord record = readSensor(words);
  record.timestamp = words.finite("the timestamp");
  return record;
}

/// ... x y theta robot_x robot_y robot_theta tv rv forward side turn_axis timestamp host logger_timestamp
LaserRecord readRobotLaser(Words& words) {
  LaserRecord record = readSensor(words);
  record.pose = words.pose();
  words.skip(8, "the robot's pose and speed");
  record.timestamp = words.finite("the timestamp");
  return record;
}

struct Message {
  const char* name;
  LaserRecord (*read)(Words&);
};
/// The best first: a log may have the same scans in several messages.
constexpr std::array<Message, 3> kMessages{
    {{"ROBOTLASER1", readRobotLaser}, {"FLASER", readFlaser}, {"RAWLASER1", readRawLaser}}};

/// What FLASER messages do not say.
void setUsualMaximum(std::vector<LaserRecord>& records) {
  double largest = 0.0;
  int beams = 0;
  for (const LaserRecord& record : records)
    for (const double range : record.scan.ranges) {
      if (!std::isfinite(range) || range < largest) continue;
      beams = range > largest ? 1 : beams + 1;
      largest = range;
    }
  if (beams < kFewestNothing) return;
  for (LaserRecord& record : records) record.scan.range_max = largest;
}

}  // namespace

LaserLog readCarmenLog(const std::string& path) {
  LaserLog log;
  std::array<std::vector<LaserRecord>, kMessages.size()> found;
  std::size_t scans = 0, beams = 0;
  try {
    TextLines lines(path);
    std::string_view line;
    while (lines.next(line)) {
      const std::string_view name = line.substr(0, line.find_first_of(" \t"));
      for (std::size_t k = 0; k < kMessages.size(); ++k) {
        if (name != kMessages[k].name) continue;
        try {
          Words words(line);
          LaserRecord record = kMessages[k].read(words);
          words.end();
          found[k].push_back(std::move(record));
          found[k].back().line = lines.number();
          ++scans;
          beams += found[k].back().scan.ranges.size();
        } catch (const Damage& damage) {
          log.addProblem(InputError(path, "line " + std::to_string(lines.number()), damage.what).what());
        }
      }
      checkLogSize(path, lines.number(), scans, beams);
    }
  } catch (const InputError& error) {
    log.addProblem(error.what());
  }
  setUsualMaximum(found[1]);
  for (std::vector<LaserRecord>& records : found)
    if (log.records.empty()) log.records = std::move(records);
  return log;
}

}  // namespace epcc
