// SPDX-License-Identifier: BSD-3-Clause
// What is behind epcc.ScanLineStream: scan lines of numpy go in, Python's functions are called with what comes out.
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/scan_line_stream.h"

namespace epcc::python {

/// A LabelledLine with memory of its own.
struct OwnedLine {
  std::int64_t index;
  double azimuth;
  int height;
  std::vector<LabelRun> runs;
};

/// A ScanLineStream whose callbacks are Python's. They are called when the library is done with a scan line, so that
/// they may do as they like, throw and add scan lines too. Runs under the GIL: scan lines take microseconds, and
/// threads that share a stream take turns.
class LineStream {
 public:
  LineStream(const StreamGeometry& geometry, const StreamOptions& options);
  LineStream(const LineStream&) = delete;

  /// These return whether the scan line was taken: not if it came late or twice. They throw epcc.InputError for what
  /// cannot be one and TypeError for arrays of other numbers. Values are float32 or uint16.
  bool addColumn(std::int64_t index, const pybind11::array& values, std::optional<double> azimuth,
                 std::optional<double> depth_scale);
  bool addRow(std::int64_t index, const pybind11::array& values, std::optional<double> depth_scale);
  bool addColumnAt(double azimuth, const pybind11::array& values, std::optional<double> depth_scale);
  /// N x 3 float32.
  bool addPoints(std::int64_t index, const pybind11::array& points);
  void finish();
  void reset();
  std::vector<StreamPlane> openPlanes() const;

  const ScanLineStream& stream() const { return stream_; }
  const StreamGeometry& geometry() const { return geometry_; }
  /// Functions of one argument, or None.
  pybind11::object on_plane = pybind11::none();
  pybind11::object on_line = pybind11::none();

 private:
  template <typename Add>
  bool addValues(StreamGeometry::Kind kind, const pybind11::array& values, std::optional<double> depth_scale,
                 const Add& add);
  bool taken(bool was_taken);
  void handOut();

  StreamGeometry geometry_;
  ScanLineStream stream_;
  bool is_handing_out_ = false;
  std::deque<std::variant<StreamPlane, OwnedLine>> handed_out_;  // in order, until Python has seen them
};

}  // namespace epcc::python
