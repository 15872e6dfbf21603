// SPDX-License-Identifier: BSD-3-Clause
// Scans, methods, scores, tables.
#include "eval/line_study/line_study.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <numeric>

#include "baselines/laser_line_methods.h"
#include "datasets/support/quantile.h"
#include "epcc_segmentation/range_noise.h"
#include "eval/line_study/image_column_lines.h"
#include "eval/report/table.h"

namespace epcc {
namespace {

struct Found {
  std::vector<std::int32_t> labels;
  std::vector<ScoredLine> lines;
};
using Method = std::function<Found(const LaserScan&)>;

Method epccMethod(const SensorModel& noise, const LaserLineParameters& parameters) {
  return [=](const LaserScan& scan) {
    LaserLineExtractor extractor(noise, parameters);
    LaserLines lines;
    Found found;
    if (!extractor.extract(scan, lines)) return found;
    found.labels = lines.labels;
    for (const LaserLine& line : lines.lines) found.lines.push_back({line.alpha, line.rho, line});
    return found;
  };
}

using LineMethod = std::vector<MethodLine> (*)(const LaserScan&, const LaserMethodParameters&);

Found foundBy(const LaserScan& scan, const std::vector<MethodLine>& lines) {
  Found found{beamLabels(scan, lines), {}};
  for (const MethodLine& line : lines) found.lines.push_back({line.alpha, line.rho, {}});
  return found;
}

Method otherMethod(LineMethod method, const LaserMethodParameters& parameters) {
  return [=](const LaserScan& scan) { return foundBy(scan, method(scan, parameters)); };
}

LineScores scoreMethod(const Method& method, const std::vector<FloorScan>& scans) {
  using Clock = std::chrono::steady_clock;
  LineScores sum;
  for (const FloorScan& scan : scans) {
    const auto start = Clock::now();
    const Found found = method(scan.record.scan);
    const std::chrono::duration<double> taken = Clock::now() - start;
    sum += scoreLines(scan, found.labels, found.lines);
    sum.seconds += taken.count();
  }
  return sum;
}

double mean(const std::vector<double>& values) {
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double shareBelow(const std::vector<double>& values, double limit) {
  const auto below = std::count_if(values.begin(), values.end(), [&](double value) { return value <= limit; });
  return values.empty() ? 0.0 : 100.0 * static_cast<double>(below) / static_cast<double>(values.size());
}

std::string count(long value) {
  return std::to_string(value);
}

}  // namespace

std::vector<LineStudyRow> runLineStudy(const LineStudyOptions& options) {
  std::vector<LineStudyRow> rows;
  for (const auto& [name, sensor] :
       {std::pair("0.5°, 360°", LaserSensor::allRound()), std::pair("1°, 180°", LaserSensor::halfCircle())}) {
    std::vector<FloorScan> scans;
    std::vector<LaserScan> plain;
    for (int plan = 0; plan < options.plans; ++plan)
      for (FloorScan& scan : scanOffice(sensor, options.scans, static_cast<std::uint64_t>(plan))) {
        plain.push_back(scan.record.scan);
        scans.push_back(std::move(scan));
      }
    const SensorModel noise = SensorModel::polynomial(0.0, sensor.noise_b, sensor.noise_a);
    LaserLineParameters pieces = options.parameters;
    pieces.join_hidden = false;
    // Each with the distance at which it finds most: of 20, 25, ... 100 mm.
    LaserMethodParameters splitting, sampling;
    splitting.distance = options.split_distance;
    sampling.distance = options.ransac_distance;
    const std::pair<const char*, Method> methods[] = {
        {"EPCC, noise given", epccMethod(noise, options.parameters)},
        {"EPCC, noise measured", epccMethod(estimateRangeNoise(plain).model(), options.parameters)},
        {"EPCC, hidden parts not joined", epccMethod(noise, pieces)},
        {"Split-and-Merge", otherMethod(splitAndMergeLines, splitting)},
        {"PCL RANSAC line", otherMethod(ransacLines, sampling)}};
    for (const auto& [method_name, method] : methods) rows.push_back({name, method_name, scoreMethod(method, scans)});
    // An image's column sees less than half a circle.
    if (scans.front().record.scan.isFullCircle()) continue;
    const Method column = [&](const LaserScan& scan) { return foundBy(scan, imageColumnLines(scan, noise)); };
    rows.push_back({name, "Algorithm 1 of image columns", scoreMethod(column, scans)});
  }
  return rows;
}

std::string lineStudyTables(const std::vector<LineStudyRow>& rows) {
  Table regions{{{"sensor", false},
                 {"method", false},
                 {"faces"},
                 {"correct"},
                 {"over"},
                 {"under"},
                 {"missed"},
                 {"noise"},
                 {"angle, mrad"},
                 {"position, mm"},
                 {"ms a scan"}},
                {}};
  Table consistency{{{"sensor", false},
                     {"method", false},
                     {"lines"},
                     {"NEES, mean"},
                     {"median"},
                     {"mean where sigma alpha < 50 mrad"},
                     {"within 3 sigma, %"},
                     {"median end error, mm"},
                     {"ends within 3 sigma, %"}},
                    {}};
  for (const LineStudyRow& row : rows) {
    const LineScores& s = row.scores;
    regions.rows.push_back({row.sensor, row.method, count(s.faces), count(s.regions.correct), count(s.regions.over),
                            count(s.regions.under), count(s.regions.missed), count(s.regions.noise),
                            numberCell(1e3 * median(s.angle_errors), 2), numberCell(1e3 * median(s.distance_errors), 2),
                            numberCell(1e3 * s.seconds / static_cast<double>(std::max(1L, s.scans)), 3)});
    if (s.line_nees.empty()) continue;
    // Chi squared with two degrees of freedom, at the probability of three sigma in one.
    constexpr double kThreeSigma = 11.829;
    consistency.rows.push_back(
        {row.sensor, row.method, count(static_cast<long>(s.line_nees.size())), numberCell(mean(s.line_nees), 2),
         numberCell(median(s.line_nees), 2), numberCell(mean(s.clear_line_nees), 2),
         numberCell(shareBelow(s.line_nees, kThreeSigma), 1), numberCell(1e3 * median(s.end_errors), 1),
         numberCell(shareBelow(s.end_nees, kThreeSigma), 1)});
  }
  return markdownTable(regions) + "\n" + markdownTable(consistency);
}

LineMap floorMap(const LineStudyOptions& options) {
  const LaserSensor sensor = LaserSensor::allRound();
  LaserLog log;
  for (FloorScan& scan : scanOffice(sensor, options.scans, 0)) log.records.push_back(std::move(scan.record));
  const SensorModel noise = SensorModel::polynomial(0.0, sensor.noise_b, sensor.noise_a);
  return logMap(log, findLines(log, noise, options.parameters, 1), "Floor plan 0");
}

}  // namespace epcc
