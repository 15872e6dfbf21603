// SPDX-License-Identifier: BSD-3-Clause
// The window, or the picture of one: the only file that knows VTK, by way of PCL's visualizer, is its source.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "datasets/files/image.h"
#include "eval/view/view_camera.h"
#include "eval/view/view_scene.h"
#include "eval/view/view_text.h"

namespace epcc {

/// Shows scenes. There must be a display (displayProblem()): without one VTK ends the program.
class ViewWindow {
 public:
  enum class Kind { OnScreen, OffScreen };
  ViewWindow(int width, int height, Kind kind);
  ~ViewWindow();
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /// Takes the place of what was shown; the view stays. Points are squares of `point_size` pixels.
  void show(const ViewScene& scene, double point_size, const ViewTexts& texts);
  /// From there, once show() is called.
  void look(const ViewCamera& camera);
  /// As the mouse has left it.
  ViewCamera camera() const;
  int width() const;
  int height() const;
  double aspect() const { return static_cast<double>(width()) / height(); }

  /// On screen: until the window is closed or `on_key` returns false. Keys have the X Window System's names; a click,
  /// without moving the mouse, is at x to the right and y down, in pixels.
  void run(const std::function<bool(const std::string& key)>& on_key,
           const std::function<void(double x, double y)>& on_click);
  /// What is shown.
  ColorImage picture();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace epcc
