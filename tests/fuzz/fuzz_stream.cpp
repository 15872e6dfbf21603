// SPDX-License-Identifier: BSD-3-Clause
// Scan lines of cameras, scanners and clouds in any order, with any values, into a stream.
#include <cmath>
#include <map>

#include "epcc_segmentation/scan_line_stream.h"
#include "tests/fuzz/fuzz_frame.h"
#include "tests/fuzz/fuzz_settings.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/segmentation_check.h"
#include "tests/fuzz/targets.h"

namespace epcc::fuzz {
namespace {

constexpr int kMostLines = 120;
using Kind = StreamGeometry::Kind;

/// What a stream hands out, held against what it promises.
class StreamCheck {
 public:
  StreamCheck(ScanLineStream& stream, int height) : height_(height) {
    stream.onLine([this](const LabelledLine& line) { take(line); });
    stream.onPlane([this](const StreamPlane& plane) { take(plane); });
  }
  /// After finish() or reset(): indices may begin anew.
  void beginAnew() { has_line_ = false; }
  /// After reset(): ids begin anew.
  void forget() {
    beginAnew();
    planes_.clear();
  }
  std::size_t planes() const { return planes_.size(); }

 private:
  void take(const LabelledLine& line) {
    require(!has_line_ || line.index > last_line_, "lines come in order");
    has_line_ = true;
    last_line_ = line.index;
    std::int32_t next = 0;
    for (const LabelRun& run : line) {
      require(next <= run.first && run.first <= run.last && run.last < height_, "runs are in order, in the line");
      require(run.plane > 0 && planes_.count(run.plane) == 0, "a plane comes behind its lines");
      next = run.last + 1;
    }
  }
  void take(const StreamPlane& plane) {
    require(plane.id > 0 && planes_.emplace(plane.id, 0).second, "an id comes once");
    require(plane.first_line <= plane.last_line && has_line_ && plane.last_line <= last_line_,
            "a plane comes behind its lines");
    require(plane.segments > 0 && plane.plane.pixel_count > 0, "a plane has pixels");
    checkPlane(plane.plane, Eigen::Vector3d::Zero());
  }

  int height_;
  bool has_line_ = false;
  std::int64_t last_line_ = 0;
  std::map<std::int64_t, int> planes_;
};

StreamOptions takeOptions(FuzzInput& input) {
  StreamOptions options;
  options.paper = takeParameters(input).paper;
  options.sensor = takeSensor(input);
  options.measured_lines = input.oneIn(8) ? input.raw<std::int16_t>() : 32;
  options.lines_at_once = input.oneIn(8) ? input.raw<std::int16_t>() : 1 + input.byte() % 32;
  if (input.oneIn(4)) options.longest_plane = input.raw<std::int16_t>();
  if (!input.oneIn(2)) options.paper.min_segments = 1 + input.byte() % 4;
  return options;
}

StreamGeometry takeGeometry(Kind kind, const FuzzFrame& frame, FuzzInput& input) {
  const double step = input.oneIn(8) ? input.anyNumber() : -2.0 * M_PI / frame.width;
  PinholeCamera camera = frame.camera;
  switch (kind) {
    case Kind::CameraColumns:
      if (input.oneIn(4)) camera.width = 0;
      return StreamGeometry::cameraColumns(camera);
    case Kind::CameraRows:
      if (input.oneIn(4)) camera.height = 0;
      return StreamGeometry::cameraRows(camera);
    case Kind::Points: {
      const int height = input.oneIn(8) ? input.raw<std::int8_t>() : frame.height;
      const auto projection = static_cast<Projection>(input.byte() % 3);
      return StreamGeometry::points(height, projection, input.oneIn(2) ? step : 0.0);
    }
    default:
      break;
  }
  std::vector<double> elevations, offsets;
  const bool staggered = input.oneIn(3), is_odd = input.oneIn(8);
  for (int ring = 0; ring < frame.height; ++ring) {
    elevations.push_back(is_odd ? input.anyNumber() : 0.4 - 0.8 * ring / std::max(1, frame.height - 1));
    if (staggered) offsets.push_back(is_odd ? input.anyNumber() : 0.02 * (ring % 4));
  }
  return StreamGeometry::scanner(elevations, step, offsets);
}

/// One scan line, with an index that rises, or not.
bool addLine(ScanLineStream& stream, Kind kind, const FuzzFrame& frame, std::int64_t index, FuzzInput& input) {
  const bool is_row = kind == Kind::CameraRows;
  const int lines = is_row ? frame.height : frame.width;
  const auto line = static_cast<std::ptrdiff_t>(((index % lines) + lines) % lines);
  const bool is_short = input.oneIn(4);
  if (kind == Kind::Points) return stream.addPoints(index, frame.values.data() + 3 * line, 3 * frame.width);
  const float* const depth = frame.values.data() + (is_row ? line * frame.width : line);
  const std::uint16_t* const units = frame.millimetres.data() + (is_row ? line * frame.width : line);
  const std::ptrdiff_t stride = is_row ? 1 : frame.width;
  if (is_row) return is_short ? stream.addRow(index, units) : stream.addRow(index, depth);
  if (kind == Kind::CameraColumns)
    return is_short ? stream.addColumn(index, units, stride) : stream.addColumn(index, depth, stride);
  const double azimuth = input.oneIn(16) ? input.anyNumber() : -2.0 * M_PI * static_cast<double>(line) / frame.width;
  if (input.oneIn(2)) return stream.addColumn(index, azimuth, depth, stride);
  return is_short ? stream.addColumnAt(azimuth, units, stride) : stream.addColumnAt(azimuth, depth, stride);
}

/// The values of each scan line, as large as the geometry may ask for.
FuzzFrame takeValues(Kind kind, FuzzInput& input) {
  FuzzFrame frame = FuzzFrame::takeDepth(input);
  if (kind == Kind::Points) frame.kind = input.oneIn(2) ? FuzzFrame::Kind::Scan : FuzzFrame::Kind::Cloud;
  return frame;
}

bool runStream(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  const auto kind = static_cast<Kind>(input.byte() % 4);
  const StreamOptions options = takeOptions(input);
  FuzzFrame frame = takeValues(kind, input);
  const StreamGeometry geometry = takeGeometry(kind, frame, input);
  const FuzzScene scene = FuzzScene::take(input);
  const int lines = input.byte() % (kMostLines + 1);
  const std::int64_t first = input.oneIn(8) ? input.raw<std::int64_t>() : 0;
  const std::size_t actions = 3 * static_cast<std::size_t>(lines);
  std::vector<std::uint8_t> steps(actions);
  for (std::uint8_t& step : steps) step = input.byte();
  frame.fill(scene, Eigen::Isometry3d::Identity(), input);
  frame.millimetres.assign(static_cast<std::size_t>(frame.width * frame.height), 1500);
  if (kind == Kind::Points && geometry.height() > frame.height) return false;  // it would read beyond the frame

  ScanLineStream stream(geometry, options);
  StreamCheck check(stream, geometry.height());
  const bool usable = stream.status() == Status::Ok;
  if (!usable) requireOneLine(stream.error());
  FuzzInput choices(steps.data(), steps.size());
  std::vector<StreamPlane> open;
  auto index = static_cast<std::uint64_t>(first);
  bool all = usable;
  for (int i = 0; i < lines; ++i) {
    const bool added = addLine(stream, kind, frame, static_cast<std::int64_t>(index), choices);
    if (!added) requireOneLine(stream.error());
    require(usable || !added, "a stream that cannot be used takes nothing");
    all = all && added;
    const std::uint8_t what = choices.byte();
    index += what % 32 == 31 ? static_cast<std::uint64_t>(choices.raw<std::int8_t>()) : 1;
    if (what % 32 == 30) {
      stream.finish();
      check.beginAnew();
    }
    if (what % 64 == 29) {
      stream.reset();
      check.forget();
    }
    if (what % 32 == 28) stream.openPlanes(open);
  }
  const bool finished = stream.finish();
  require(stream.taken() >= 0 && stream.lost() >= 0 && stream.refused() >= 0, "scan lines are counted");
  return finished && all;
}

std::vector<std::string> streamSeeds() {
  std::vector<std::string> seeds;
  for (char kind = 0; kind < 4; ++kind) {
    std::string seed(1, kind);
    seed += std::string("\2\0\0\0", 4);                         // the paper's parameters
    seed += std::string("\2\2\1\x10", 4);                       // axial, 2 mm, 0.001/m, a pixel
    seed += std::string("\0\0\7\0\0\1", 6);                     // eight lines at once, small planes
    seed += std::string("\x1f\0\x17\0\0\2\5\0\0\0\0\0\0", 13);  // 32x24
    if (kind == 3) seed += std::string("\0", 1);                // a camera's points
    seed += std::string(kind == 0 || kind == 1 ? "\0\0" : kind == 2 ? "\0\0\0" : "\0\0\0\0", kind < 2 ? 2 : 1 + kind);
    seed += std::string("\2\0\x08\x04\x10\xf0\x08\x18", 8);  // two planes
    seed += std::string("\x18\0", 2);                        // 24 lines
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace

const FuzzTarget kStream{runStream, streamSeeds};

}  // namespace epcc::fuzz
