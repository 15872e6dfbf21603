// SPDX-License-Identifier: BSD-3-Clause
// Numbers of a plane with what they are uncertain by, from the fit's covariance.
#include "eval/view/view_text.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <sstream>

#include "datasets/support/input_error.h"

namespace epcc {
namespace {

constexpr std::size_t kLineBytes = 100;  // what a window holds

std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string formatted(const char* format, ...) {
  char text[200];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

/// Words in lines of at most kLineBytes, where no word is longer.
std::string wrapped(const std::string& text) {
  std::string lines;
  std::size_t length = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits = length + 1 + word.size() <= kLineBytes;
    if (!lines.empty()) lines += fits ? ' ' : '\n';
    length = fits ? length + 1 + word.size() : word.size();
    lines += word;
  }
  return lines;
}

std::string inputLine(const ViewSession& session) {
  const std::string path = printable(session.input().path, kLineBytes);
  return session.size() > 1 ? formatted("[%zu/%zu] ", session.index() + 1, session.size()) + path : path;
}

std::string summary(const ViewSession& session) {
  if (!session.problem().empty()) return "cannot be used: " + printable(session.problem(), 2 * kLineBytes);
  const PlaneSegmentation& result = session.result();
  std::size_t measured = 0, labelled = 0;
  for (const ViewPoint& point : session.scene().points) {
    ++measured;
    if (point.label > 0) ++labelled;
  }
  return formatted("%dx%d, %zu planes, %zu of %zu points on them, %.1f ms", result.width, result.height,
                   result.planes.size(), labelled, measured, 1e3 * session.seconds());
}

std::string parameterLines(const ViewSession& session) {
  std::string lines;
  for (std::size_t i = 0; i < session.fields().size(); ++i) {
    const ParameterField& field = *session.fields()[i];
    const std::string name = field.name;
    const std::string value = valueText(field, field.get(session.parameters()));
    lines += formatted("\n%c %-17s %s %s", i == session.field() ? '>' : ' ', name.substr(name.rfind('.') + 1).c_str(),
                       value.c_str(), field.unit);
  }
  return lines;
}

/// What the chosen parameter is, and when to change it.
std::string advice(const ParameterField& field) {
  const std::string name = field.name;
  const std::string effect = field.choices.empty()
                                 ? std::string("Raise it if ") + field.raise + "; lower it if " + field.lower
                                 : std::string(field.advice);
  return wrapped(name.substr(name.rfind('.') + 1) + ": " + field.meaning + ". " + effect + ".");
}

std::string coefficientLines(const Plane& plane) {
  std::string lines;
  for (int k = 0; k < 4; ++k)
    lines += formatted("%c = %9.5f +- %.5f%s\n", "abcd"[k], plane.coefficients(k),
                       std::sqrt(std::max(0.0, plane.coefficients_covariance(k, k))), k == 3 ? " m" : "");
  return lines;
}

/// The selected surface, where polygons are drawn.
std::string polygonLine(const ViewSession& session, std::size_t index) {
  const std::vector<SurfacePolygon>& surfaces = session.surfaces().polygons.surfaces;
  if (index >= surfaces.size()) return {};
  const SurfacePolygon& surface = surfaces[index];
  std::size_t holes = 0;
  for (const SurfacePiece& piece : surface.pieces) holes += piece.holes.size();
  return formatted("\npolygon of %.3f m2, %zu %s, %zu %s, within %.3f x %.3f m", surface.area, surface.pieces.size(),
                   surface.pieces.size() == 1 ? "piece" : "pieces", holes, holes == 1 ? "hole" : "holes",
                   surface.extent.length, surface.extent.width);
}

std::string planeLines(const ViewSession& session) {
  const auto index = static_cast<std::size_t>(session.style().selected - 1);
  const Plane& plane = session.result().planes[index];
  const PlaneSummary& summary = session.summaries()[index];
  return formatted("plane %d of %zu, %s: a x + b y + c z + d = 0\n", summary.id, session.result().planes.size(),
                   summary.kind.c_str()) +
         coefficientLines(plane) +
         formatted("%zu pixels, %.3f m2, rms %.1f mm, confidence %.2f\n", summary.pixels, summary.area,
                   1e3 * summary.rms, summary.confidence) +
         formatted("%.3f m from the sensor, centroid %.3f m, tilt %.1f deg", summary.distance,
                   summary.centroid_distance, summary.tilt) +
         polygonLine(session, index);
}

}  // namespace

ViewTexts viewTexts(const ViewSession& session) {
  ViewTexts texts;
  if (session.showsHelp()) texts.top = keyHelp();
  if (!session.showsTexts()) return texts;
  if (!session.showsHelp()) {
    const bool is_paper = session.parameters().mode == Mode::Paper;
    texts.top = inputLine(session) + '\n' + summary(session) + '\n' + "sensor " +
                printable(session.sensorName(), kLineBytes) + ", mode " + (is_paper ? "paper" : "inverse-depth") +
                parameterLines(session);
    if (!session.notice().empty()) texts.top += "\n" + wrapped(session.notice());
    if (!session.doubt().empty()) texts.top += "\n" + wrapped("doubtful: " + session.doubt());
  }
  texts.bottom = session.style().selected > 0
                     ? planeLines(session)
                     : advice(*session.fields()[session.field()]) + "\nh: help, tab or click: select a plane";
  return texts;
}

}  // namespace epcc
