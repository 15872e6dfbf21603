// SPDX-License-Identifier: BSD-3-Clause
// Runs the kernel of Algorithm 1 and lifts its records into space.
#include "metric/strip_lines.h"

namespace epcc {

namespace {

/// A record of Algorithm 1 in double precision; `direction` is that of t1.
ClusteredLine lineOf(const LineRecord& record, const Eigen::Vector3d& direction) {
  ClusteredLine line;
  line.first = record.first;
  line.last = record.last;
  LinePrototype& p = line.prototype;
  p.statistics.n = static_cast<int>(record.n);
  p.statistics.mean = Eigen::Vector2d(record.mean[0], record.mean[1]);
  p.statistics.covariance << record.scatter[0], record.scatter[2], record.scatter[2], record.scatter[1];
  p.statistics.covariance /= p.statistics.n - 1.0;
  p.variance = static_cast<double>(record.residuals) / (p.statistics.n - 1.0);
  p.normal = Eigen::Vector2d(record.normal[0], record.normal[1]).normalized();
  // Eqs. 3-8 inverted: z = t1 / sqrt(1 + u^2), x = u z, y = t2.
  const auto lift = [&direction, &p](const float* sample) {
    const Eigen::Vector2d t = p.project(Eigen::Vector2d(sample[0], sample[1]));
    return Eigen::Vector3d(t.x() * direction.x(), t.y(), t.x() * direction.z());
  };
  line.a = lift(record.first_sample);
  line.b = lift(record.last_sample);
  return line;
}

}  // namespace

void StripLines::cluster(const ScanStrip& strip, const ClusteringRule& rule, const SegmentNumbers& numbers, int lines) {
  found_.capacity = capacity(strip.height, rule);
  records_.resize(static_cast<std::size_t>(found_.capacity) * kStripLines);
  found_.records = records_.data();
  found_.first_number = numbers.first;
  found_.number_step = numbers.step;
  found_.numbers = numbers.numbers;
  found_.number_stride = numbers.stride;
  clusterLines(strip, rule, workspace_, found_, lines);
}

void StripLines::list(int line, const Eigen::Vector3d& direction, std::vector<ClusteredLine>& segments) const {
  segments.clear();
  const LineRecord* records = found_.records + line * found_.capacity;
  for (int k = 0; k < found_.count[line]; ++k) segments.push_back(lineOf(records[k], direction));
}

}  // namespace epcc
