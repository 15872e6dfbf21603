// SPDX-License-Identifier: BSD-3-Clause
// Prints segments, one a line.
#include "eval/lines/line_list.h"

#include <charconv>

namespace epcc {
namespace {

constexpr const char* kHeading =
    "scan,line,timestamp_s,pose_x_m,pose_y_m,pose_theta_rad,first_beam,last_beam,points,start_x_m,start_y_m,end_x_m,"
    "end_y_m,world_start_x_m,world_start_y_m,world_end_x_m,world_end_y_m,alpha_rad,rho_m,var_alpha_rad2,"
    "cov_alpha_rho_rad_m,var_rho_m2,start_var_x_m2,start_cov_x_y_m2,start_var_y_m2,end_var_x_m2,end_cov_x_y_m2,"
    "end_var_y_m2,residual_var_m2,chi_squared\n";

/// Fields of a line, with commas between them.
class Fields {
 public:
  explicit Fields(std::string& text) : text_(text) {}
  template <typename Number>
  void add(Number value) {
    char buffer[40];
    begin();
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  }
  void add(const Vector2& point) {
    add(point.x());
    add(point.y());
  }
  void add(const Matrix2& covariance) {
    add(covariance(0, 0));
    add(covariance(0, 1));
    add(covariance(1, 1));
  }
  void addEmpty(int count) {
    for (int i = 0; i < count; ++i) begin();
  }

 private:
  void begin() {
    if (!first_) text_ += ',';
    first_ = false;
  }
  std::string& text_;
  bool first_ = true;
};

void append(const LaserRecord& record, const LaserLine& line, std::size_t scan, std::size_t number, std::string& text) {
  Fields fields(text);
  fields.add(scan);
  fields.add(number);
  if (record.timestamp)
    fields.add(*record.timestamp);
  else
    fields.addEmpty(1);
  if (record.pose) {
    fields.add(record.pose->x);
    fields.add(record.pose->y);
    fields.add(record.pose->theta);
  } else {
    fields.addEmpty(3);
  }
  for (const int value : {line.first, line.last, line.points}) fields.add(value);
  fields.add(line.start);
  fields.add(line.end);
  if (record.pose) {
    fields.add(record.pose->toWorld(line.start));
    fields.add(record.pose->toWorld(line.end));
  } else {
    fields.addEmpty(4);
  }
  fields.add(line.alpha);
  fields.add(line.rho);
  fields.add(line.covariance);
  fields.add(line.start_covariance);
  fields.add(line.end_covariance);
  fields.add(line.variance);
  fields.add(line.chi_squared);
  text += '\n';
}

}  // namespace

std::string lineListCsv(const LaserLog& log, const LogLines& lines) {
  std::string text = kHeading;
  for (std::size_t scan = 0; scan < lines.scans.size(); ++scan)
    for (std::size_t number = 0; number < lines.scans[scan].lines.size(); ++number)
      append(log.records[scan], lines.scans[scan].lines[number], scan, number, text);
  return text;
}

}  // namespace epcc
