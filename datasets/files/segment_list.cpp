// SPDX-License-Identifier: BSD-3-Clause
// Prints line segments, one a line.
#include "datasets/files/segment_list.h"

#include <charconv>

#include "datasets/support/atomic_file.h"

namespace epcc {
namespace {

constexpr const char* kHeading =
    "scan,line,first_px,last_px,samples,label,start_x_m,start_y_m,start_z_m,end_x_m,end_y_m,end_z_m,"
    "mean_t1_m,mean_t2_m,var_t1_m2,cov_t1_t2_m2,var_t2_m2,residual_var_m2,"
    "theta1_per_m,theta2_per_m,var_theta1_per_m2,cov_theta1_theta2_per_m2,var_theta2_per_m2\n";

/// The shortest text that reads back as the same number, whatever the locale.
template <typename Number>
void append(Number value, std::string& text) {
  char buffer[40];
  text += ',';
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

void append(const LineSegment& segment, std::string& text) {
  text += segment.scan == ScanDirection::Rows ? "row" : "column";
  for (const int value : {segment.line, segment.first, segment.last, segment.samples, segment.label})
    append(value, text);
  for (const Vector3& point : {segment.start, segment.end})
    for (int k = 0; k < 3; ++k) append(point(k), text);
  append(segment.mean(0), text);
  append(segment.mean(1), text);
  append(segment.covariance(0, 0), text);
  append(segment.covariance(0, 1), text);
  append(segment.covariance(1, 1), text);
  append(segment.variance, text);
  append(segment.theta(0), text);
  append(segment.theta(1), text);
  append(segment.theta_covariance(0, 0), text);
  append(segment.theta_covariance(0, 1), text);
  append(segment.theta_covariance(1, 1), text);
  text += '\n';
}

}  // namespace

std::string segmentListCsv(const std::vector<LineSegment>& segments) {
  std::string text = kHeading;
  for (const LineSegment& segment : segments) append(segment, text);
  return text;
}

void writeSegmentList(const std::string& path, const std::vector<LineSegment>& segments) {
  writeTextFile(path, segmentListCsv(segments));
}

}  // namespace epcc
