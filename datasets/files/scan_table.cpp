// SPDX-License-Identifier: BSD-3-Clause
// Tables of scans: columns by the names of sensor_msgs/LaserScan.
#include <cmath>
#include <optional>
#include <set>

#include "datasets/files/laser_log.h"
#include "datasets/support/input_error.h"
#include "datasets/support/number_text.h"

namespace epcc {
namespace {

constexpr double kNanoseconds = 1e14;  // a time beyond is in these: three million years in seconds

/// Columns of what is known by name; -1 there is none.
struct Columns {
  int time = -1, angle_min = -1, angle_increment = -1, range_min = -1, range_max = -1, x = -1, y = -1, theta = -1;
  int first_range = -1;
  int end_range = -1;  // -1: all that follow
};

/// "field.ranges0" and "%ranges0" -> "ranges0"
std::string_view plainName(std::string_view name) {
  if (!name.empty() && (name[0] == '%' || name[0] == '#')) name.remove_prefix(1);
  constexpr std::string_view kField = "field.";
  if (name.substr(0, kField.size()) == kField) name.remove_prefix(kField.size());
  return name;
}

constexpr std::string_view kRanges = "ranges";

/// "ranges12" -> 12; nothing for "ranges" alone.
std::optional<long> numberOf(std::string_view name) {
  std::string digits;
  for (const char c : name)
    if (c >= '0' && c <= '9') digits += c;
  if (digits.empty() || digits.size() > 9) return std::nullopt;
  return std::stol(digits);
}

/// Of the names of two columns side by side.
bool follows(std::string_view before, std::string_view name) {
  const std::optional<long> first = numberOf(before), second = numberOf(name);
  return first.has_value() == second.has_value() && (!first || *second == *first + 1);
}

Columns findColumns(std::string_view heading, const std::string& path, long line) {
  Columns columns;
  const std::pair<std::string_view, int Columns::*> known[] = {{"time", &Columns::time},
                                                               {"timestamp", &Columns::time},
                                                               {"header.stamp", &Columns::time},
                                                               {"angle_min", &Columns::angle_min},
                                                               {"angle_increment", &Columns::angle_increment},
                                                               {"range_min", &Columns::range_min},
                                                               {"range_max", &Columns::range_max},
                                                               {"x", &Columns::x},
                                                               {"y", &Columns::y},
                                                               {"theta", &Columns::theta}};
  const std::vector<std::string_view> names = fieldsOf(heading);
  const std::string field = "line " + std::to_string(line);
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string_view name = plainName(names[i]);
    for (const auto& [text, member] : known) {
      if (name != text) continue;
      if (!seen.insert(name).second) throw InputError(path, field, "the heading has '" + std::string(name) + "' twice");
      columns.*member = static_cast<int>(i);
    }
    const bool is_range = name.substr(0, kRanges.size()) == kRanges;
    const bool was_range = i > 0 && plainName(names[i - 1]).substr(0, kRanges.size()) == kRanges;
    if (is_range && columns.first_range < 0)
      columns.first_range = static_cast<int>(i);
    else if (is_range && (!was_range || !follows(plainName(names[i - 1]), name)))
      throw InputError(path, field, "the heading has '" + std::string(name) + "' out of order");
    if (!is_range && was_range) columns.end_range = static_cast<int>(i);
  }
  if (columns.angle_min < 0) throw InputError(path, field, "the heading has no angle_min");
  if (columns.angle_increment < 0) throw InputError(path, field, "the heading has no angle_increment");
  if (columns.first_range < 0) throw InputError(path, field, "the heading has no ranges");
  return columns;
}

class Row {
 public:
  Row(std::string_view line, const std::string& path, long number)
      : fields_(fieldsOf(line)), path_(path), number_(number) {}

  double number(int column, const char* name) const {
    const auto at = static_cast<std::size_t>(column);
    if (at >= fields_.size()) fail(std::string("ends before ") + name);
    const auto value = numberFrom(fields_[at]);
    if (!value) fail(std::string(name) + " '" + std::string(fields_[at].substr(0, 40)) + "' is no number");
    return *value;
  }
  double finite(int column, const char* name) const {
    const double value = number(column, name);
    if (!std::isfinite(value)) fail(std::string(name) + " is not finite");
    return value;
  }
  std::vector<double> ranges(const Columns& columns) const {
    const auto first = static_cast<std::size_t>(columns.first_range);
    const std::size_t end = columns.end_range < 0 ? fields_.size() : static_cast<std::size_t>(columns.end_range);
    if (end > fields_.size() || first >= end) fail("ends before its ranges");
    if (end - first > kMaxScanBeams) fail("has more than " + std::to_string(kMaxScanBeams) + " ranges");
    std::vector<double> values;
    for (std::size_t i = first; i < end; ++i)
      // An empty field is a beam without return, as some programs print NaN.
      values.push_back(fields_[i].empty() ? std::nan("") : number(static_cast<int>(i), "a range"));
    return values;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(path_, "line " + std::to_string(number_), what);
  }

 private:
  std::vector<std::string_view> fields_;
  const std::string& path_;
  long number_;
};

LaserRecord readRow(const Row& row, const Columns& columns, long line) {
  LaserRecord record;
  record.line = line;
  LaserScan& scan = record.scan;
  scan.angle_min = row.finite(columns.angle_min, "angle_min");
  scan.angle_increment = row.finite(columns.angle_increment, "angle_increment");
  if (scan.angle_increment == 0.0) row.fail("angle_increment is zero");
  if (columns.range_min >= 0) scan.range_min = row.finite(columns.range_min, "range_min");
  if (columns.range_max >= 0) scan.range_max = row.number(columns.range_max, "range_max");
  if (!(scan.range_max > scan.range_min)) row.fail("range_max is not above range_min");
  if (columns.time >= 0) {
    const double time = row.finite(columns.time, "the time");
    record.timestamp = time > kNanoseconds ? 1e-9 * time : time;
  }
  if (columns.x >= 0 && columns.y >= 0 && columns.theta >= 0)
    record.pose = LaserPose{row.finite(columns.x, "x"), row.finite(columns.y, "y"), row.finite(columns.theta, "theta")};
  scan.ranges = row.ranges(columns);
  return record;
}

}  // namespace

LaserLog readScanTable(const std::string& path) {
  LaserLog log;
  TextLines lines(path);
  std::string_view line;
  bool has_heading = false;
  Columns columns;
  std::size_t beams = 0;
  try {
    while (lines.next(line)) {
      if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
      if (!has_heading) {
        columns = findColumns(line, path, lines.number());
        has_heading = true;
        continue;
      }
      try {
        log.records.push_back(readRow(Row(line, path, lines.number()), columns, lines.number()));
        beams += log.records.back().scan.ranges.size();
      } catch (const InputError& error) {
        log.addProblem(error.what());
      }
      checkLogSize(path, lines.number(), log.records.size(), beams);
    }
  } catch (const InputError& error) {
    log.addProblem(error.what());
  }
  return log;
}

}  // namespace epcc
