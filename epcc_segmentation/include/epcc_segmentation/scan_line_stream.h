// SPDX-License-Identifier: BSD-3-Clause
// Scan lines as they arrive, planes as they are finished: the paper mode without a frame (Sec. 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/export.h"
#include "epcc_segmentation/paper_parameters.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "epcc_segmentation/status.h"
#include "epcc_segmentation/stream_geometry.h"

namespace epcc {

/// What steers a stream beside its geometry.
struct StreamOptions {
  /// Parameters of Algorithms 1 and 2, as in Parameters::paper.
  PaperParameters paper;

  /// The sensor's error. Nothing: it is measured on the first `measured_lines` scan lines, which wait until then.
  std::optional<SensorModel> sensor;

  /// Scan lines that a sensor without a model is measured on, lost ones among them. [32, 4096] scan lines, default 512.
  /// Raise it if too little is flat at the start (ScanLineStream::measuredBlocks()); lower it if planes come too late.
  int measured_lines = 512;

  /// Scan lines that Algorithm 1 waits for, to take them side by side in vectors. The result does not depend on it.
  /// [1, 32] scan lines, default 32, the fastest. Lower it if planes come too late; one at a time costs
  /// three to five times as much.
  int lines_at_once = 32;

  /// Scan lines after which a plane is handed out though it goes on, and begins anew: a floor seen all round, a wall
  /// passed by. [0, 10 000 000] scan lines; 0, the default: a turn of a scanner whose azimuth step is known, else ten
  /// million.
  std::int64_t longest_plane = 0;
};

/// A plane of a stream.
struct StreamPlane {
  std::int64_t id = 0;          ///< 1, 2, ... in the order in which they became large enough
  Plane plane;                  ///< in the sensor's frame; confidence is 1
  std::int64_t first_line = 0;  ///< index of the first scan line with a segment of it ...
  std::int64_t last_line = 0;   ///< ... and of the last one
  std::int64_t segments = 0;    ///< line segments of it
  bool is_cut = false;          ///< StreamOptions::longest_plane was reached: what follows has another id
};

/// Pixels of a scan line with one label.
struct LabelRun {
  std::int32_t first = 0;  ///< place in the scan line: row of a column, column of a row
  std::int32_t last = 0;   ///< the last one of them
  std::int64_t plane = 0;  ///< StreamPlane::id
};

/// The labels of a scan line, final. What is in no run belongs to no plane.
struct LabelledLine {
  std::int64_t index = 0;          ///< of the scan line, as it was given or counted; see StreamGeometry::ringShift()
  double azimuth = 0.0;            ///< as it was given, radians; 0 if none was; of staggered rings its own column's
  const LabelRun* runs = nullptr;  ///< in order; valid during the call only
  std::size_t run_count = 0;       ///< how many there are

  /// The first run: `for (const LabelRun& run : line)` goes through all.
  const LabelRun* begin() const { return runs; }
  /// Behind the last run.
  const LabelRun* end() const { return runs + run_count; }
};

/// Segments scan lines as they come: a rolling readout, a spinning scanner, a file larger than memory. Algorithm 1
/// takes some scan lines at a time, Algorithm 2 one after another; what no coming scan line can touch is handed out and
/// forgotten, so that memory stays bounded on a stream without end. Labels and planes are those of the whole frame's
/// column scan in the paper mode (Parameters::forPaper() with ScanDirection::Columns; of rows with Rows): labels to the
/// pixel, planes to rounding. Of a scanner with staggered rings that is the cloud whose columns are its scan lines.
///
///     epcc::ScanLineStream stream(epcc::StreamGeometry::scanner(elevations, azimuth_step), options);
///     stream.onPlane([](const epcc::StreamPlane& plane) { ... });
///     while (receive(azimuth, ranges))
///       if (!stream.addColumnAt(azimuth, ranges)) std::cerr << stream.error() << '\n';
///     stream.finish();
///
/// Once it is warm, nothing is allocated. Not for use from two threads at once, nor after it was moved away. Nothing is
/// thrown but std::bad_alloc by the constructor and openPlanes(); what a callback throws ends the stream with
/// Status::Failed.
class EPCC_CORE_EXPORT ScanLineStream {
 public:
  /// What is wrong with geometry or options shows at once in status() and error(), and with every scan line.
  explicit ScanLineStream(const StreamGeometry& geometry, const StreamOptions& options = StreamOptions());
  ~ScanLineStream();
  /// Takes over the stream; the other is not for use afterwards.
  ScanLineStream(ScanLineStream&&) noexcept;
  /// Takes over the stream; the other is not for use afterwards.
  ScanLineStream& operator=(ScanLineStream&&) noexcept;

  /// Called with each plane that is finished: no coming scan line can add to it, and the labels of all of its scan
  /// lines have been handed out. Only what has PaperParameters::min_segments and min_points is a plane. Called from
  /// within the functions below; it must not call them.
  void onPlane(std::function<void(const StreamPlane&)> callback);
  /// Called with the labels of each scan line, in order, as soon as it is certain which of its planes are large enough:
  /// as a rule after about min_segments more scan lines, and StreamOptions::lines_at_once; at most after min_segments
  /// times look_back (PaperParameters::Planes), or as many as it takes to reach min_points.
  void onLine(std::function<void(const LabelledLine&)> callback);

  /// The column `index` of a camera: geometry.height() depths, `stride` floats apart, `scale` metres per unit; <= 0,
  /// NaN and Inf are not measured. Indices rise; what is left out counts as lost: scan lines without a sample. False,
  /// and the column is left out, if it comes late or twice (Status::OutOfOrder), is none of the camera's
  /// (SizeMismatch), is null (EmptyCloud), if the scale is not positive (InvalidCamera), or if the stream's scan lines
  /// are others (UnsupportedScan).
  bool addColumn(std::int64_t index, const float* depth, std::ptrdiff_t stride = 1, double scale = 1.0);
  /// The same of 16-bit values, millimetres unless the scale says otherwise, `stride` values apart; 0 and 65535 are not
  /// measured: all as DepthView has it.
  bool addColumn(std::int64_t index, const std::uint16_t* depth, std::ptrdiff_t stride = 1, double scale = 0.001);
  /// The same as addColumn() of a camera that is read row by row.
  bool addRow(std::int64_t index, const float* depth, std::ptrdiff_t stride = 1, double scale = 1.0);
  /// The same of 16-bit values, millimetres unless the scale says otherwise; 0 and 65535 are not measured.
  bool addRow(std::int64_t index, const std::uint16_t* depth, std::ptrdiff_t stride = 1, double scale = 0.001);
  /// A column of a scanner: ranges, one a ring, `scale` metres per unit, at an azimuth in radians about the z-up axis,
  /// 0 forward and growing to the left. `index` counts the columns of all turns, lost ones too. With staggered rings
  /// the azimuth is the column's, to which each ring's own is added (StreamGeometry::scanner()); a scan line is
  /// complete, and goes to Algorithm 1, when the last of its rings has looked at it.
  bool addColumn(std::int64_t index, double azimuth, const float* ranges, std::ptrdiff_t stride = 1,
                 double scale = 1.0);
  /// The same of 16-bit values, millimetres unless the scale says otherwise; 0 and 65535 are not measured.
  bool addColumn(std::int64_t index, double azimuth, const std::uint16_t* ranges, std::ptrdiff_t stride = 1,
                 double scale = 0.001);
  /// The same where nobody counts: the place follows from the azimuth and the geometry's azimuth step. A column that
  /// lies up to half a turn behind the last one is late (Status::OutOfOrder).
  bool addColumnAt(double azimuth, const float* ranges, std::ptrdiff_t stride = 1, double scale = 1.0);
  /// The same of 16-bit values, millimetres unless the scale says otherwise; 0 and 65535 are not measured.
  bool addColumnAt(double azimuth, const std::uint16_t* ranges, std::ptrdiff_t stride = 1, double scale = 0.001);
  /// A column of a cloud: x, y, z of point i at xyz + stride * i, metres, the sensor's frame (DepthFrame::fromPoints).
  bool addPoints(std::int64_t index, const float* xyz, std::ptrdiff_t stride = 3);

  /// The stream has ended, or a frame of it: hands out all that is left, open planes too. The next scan line, of any
  /// index, begins anew; ids go on.
  bool finish();
  /// Forgets all that is not handed out yet, also an error, and begins anew with id 1.
  void reset();

  /// Fills `planes` with those that can grow still and are large enough already, by id, as they are after the scan
  /// lines that Algorithm 2 has seen: up to StreamOptions::lines_at_once fewer than were added, and as many more as
  /// staggered rings are columns apart.
  void openPlanes(std::vector<StreamPlane>& planes) const;

  /// How the last scan line, or finish(), ended.
  Status status() const noexcept;
  /// What was wrong, in words; empty if nothing was.
  const std::string& error() const noexcept;

  /// Scan lines taken since the beginning or reset().
  std::int64_t taken() const noexcept;
  /// Scan lines counted as lost: indices that were left out.
  std::int64_t lost() const noexcept;
  /// Scan lines refused as late or repeated.
  std::int64_t refused() const noexcept;

  /// The model in use: the given one, or the measured one once it is; before that the generic one.
  const SensorModel& sensor() const noexcept;
  /// Whether the scan lines still wait for the sensor to be measured.
  bool isMeasuring() const noexcept;
  /// Flat image blocks that the sensor was measured on; 0: none were found, sensor() is generic.
  std::size_t measuredBlocks() const noexcept;

 private:
  struct State;
  std::int64_t indexAt(double azimuth) const;
  bool accepts(StreamGeometry::Kind kind, double azimuth, const void* values);
  bool add(std::int64_t index, double azimuth, const float* values, std::ptrdiff_t stride);
  template <typename T>
  bool addScaled(StreamGeometry::Kind kind, std::int64_t index, double azimuth, const T* values, std::ptrdiff_t stride,
                 double scale);
  bool fail(Status status, const std::string& error);
  template <typename Work>
  bool guarded(const Work& work);

  std::unique_ptr<State> state_;
};

}  // namespace epcc
