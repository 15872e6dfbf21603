// SPDX-License-Identifier: BSD-3-Clause
// Opens the display the way VTK will. Xlib's macros stay in this file.
#include "eval/view/display.h"

#ifdef EPCC_WITH_X11
#include <X11/Xlib.h>

#include <cstdlib>
#endif

namespace epcc {

#ifdef EPCC_WITH_X11
std::string displayProblem() {
  static const std::string remedy = "; on a machine without a screen use xvfb-run -a epcc_view ... --snapshot OUT.png";
  const char* const name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') return "display: DISPLAY is not set" + remedy;
  Display* const display = XOpenDisplay(nullptr);
  if (display == nullptr) return "display: " + std::string(name) + " cannot be opened" + remedy;
  int opcode = 0, event = 0, error = 0;
  const bool draws = XQueryExtension(display, "GLX", &opcode, &event, &error) != 0;
  XCloseDisplay(display);
  return draws ? std::string() : "display: " + std::string(name) + " has no OpenGL (GLX)" + remedy;
}
#else
std::string displayProblem() {
  return {};
}
#endif

}  // namespace epcc
