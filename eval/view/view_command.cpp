// SPDX-License-Identifier: BSD-3-Clause
// A session and a window, joined: keys and clicks go to the session, what it shows goes to the window.
#include "eval/view/view_command.h"

#include <ostream>

#include "datasets/files/png_io.h"
#include "eval/program/command_line.h"
#include "eval/segment/segment_input.h"
#include "eval/segment/segment_output.h"
#include "eval/view/display.h"
#include "eval/view/view_options.h"
#include "eval/view/view_session.h"
#include "eval/view/view_text.h"
#include "eval/view/view_window.h"

namespace epcc {
namespace {

constexpr const char* kProgram = "epcc_view";

/// Empty if the snapshot takes no input's place.
std::string snapshotProblem(const ViewOptions& options, const std::vector<SegmentInput>& inputs) {
  SegmentOptions outputs = options.input;
  outputs.overlay = options.snapshot;
  for (const SegmentInput& input : inputs) {
    const std::string problem = checkOutputs(outputs, {input});
    if (!problem.empty()) return problem;
  }
  return {};
}

/// Draws what has changed.
void update(const ViewSession& session, const ViewChange& change, ViewWindow& window) {
  if (!change.redraw && !change.look) return;
  const ViewScene scene = session.scene();
  if (change.look) window.look(viewFrom(session.place(), scene, window.aspect()));
  window.show(scene, session.pointSize(), viewTexts(session));
}

void writeSnapshot(const ViewSession& session, const ViewOptions& options) {
  OutputPaths paths;
  paths.overlay = options.snapshot;
  refuseSpecialFiles(paths);
  ViewWindow window(options.width, options.height, ViewWindow::Kind::OffScreen);
  update(session, {true, true, false}, window);
  writeRgb(options.snapshot, window.picture());
}

void runWindow(ViewSession& session, const ViewOptions& options) {
  ViewWindow window(options.width, options.height, ViewWindow::Kind::OnScreen);
  update(session, {true, true, false}, window);
  window.run(
      [&](const std::string& key) {
        const std::optional<ViewCommand> command = commandOf(key);
        const ViewChange change = command ? session.press(*command) : ViewChange();
        update(session, change, window);
        return !change.quit;
      },
      [&](double x, double y) {
        const ViewScene scene = session.scene();
        const int point = pointAt(scene, window.camera(), window.width(), window.height(), x, y);
        update(session, session.select(point < 0 ? 0 : scene.points[static_cast<std::size_t>(point)].label), window);
      });
}

/// The first input that can be used, if there is one.
void skipUnusable(ViewSession& session) {
  while (!session.problem().empty() && session.index() + 1 < session.size()) session.press(ViewCommand::NextInput);
}

int view(const ViewOptions& options, std::ostream& err) {
  const InputList list = listInputs(options.input);
  std::string misuse = list.usage_problem;
  if (misuse.empty() && !options.snapshot.empty()) misuse = snapshotProblem(options, list.inputs);
  if (!misuse.empty()) return reportProblem(kProgram, err, misuse, kExitUsage);
  const std::string no_display = displayProblem();
  if (!no_display.empty()) return reportProblem(kProgram, err, no_display, kExitInput);

  ViewSession session(options.input, list.inputs, options.style);
  if (options.snapshot.empty()) skipUnusable(session);
  std::string notice = session.notice();
  bool quit = false;
  for (const std::string& key : options.keys) {
    quit |= session.press(*commandOf(key)).quit;
    if (!session.notice().empty()) notice = session.notice();
  }
  if (!session.problem().empty()) return reportProblem(kProgram, err, session.problem(), kExitInput);
  if (options.snapshot.empty()) {
    if (!quit) runWindow(session, options);
  } else {
    writeSnapshot(session, options);
    if (!notice.empty()) err << kProgram << ": " << notice << '\n';
    if (!session.doubt().empty()) err << kProgram << ": " << session.input().path << ": " << session.doubt() << '\n';
  }
  return kExitDone;
}

}  // namespace

int viewMain(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  ViewOptions options;
  if (const auto done = parseViewOptions(argc, argv, options, out, err)) return *done;
  return runProgram(kProgram, out, err, [&] { return view(options, err); });
}

}  // namespace epcc
