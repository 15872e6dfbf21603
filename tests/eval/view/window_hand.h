// SPDX-License-Identifier: BSD-3-Clause
// Eyes and hands for a window of another program: what its pixels are, keys and clicks.
#pragma once

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "datasets/files/image.h"

namespace epcc::test {

/// Waits until it holds, 20 s at most (more on a machine that is busy).
inline bool waitFor(const std::function<bool()>& condition) {
  for (int i = 0; i < 400; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

class WindowHand {
 public:
  explicit WindowHand(const std::string& display) : display_(XOpenDisplay(display.c_str())) {
    // A window that is not shown yet, or no more, has no picture: no reason to end the test's process.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  }
  WindowHand(const WindowHand&) = delete;
  WindowHand& operator=(const WindowHand&) = delete;
  ~WindowHand() {
    if (display_ != nullptr) XCloseDisplay(display_);
  }

  /// Finds the window with this title.
  bool find(const std::string& title) {
    return display_ != nullptr && waitFor([&] { return (window_ = below(DefaultRootWindow(display_), title)) != 0; });
  }
  void key(const char* name) {
    XKeyEvent event = {};
    event.keycode = XKeysymToKeycode(display_, XStringToKeysym(name));
    XEvent sent = {};
    for (const int type : {KeyPress, KeyRelease}) {
      event.type = type;
      sent.xkey = event;
      send(sent, type == KeyPress ? KeyPressMask : KeyReleaseMask);
    }
  }
  void click(int x, int y) {
    XEvent sent = {};
    sent.xbutton.button = Button1;
    sent.xbutton.x = x;
    sent.xbutton.y = y;
    for (const int type : {ButtonPress, ButtonRelease}) {
      sent.xbutton.type = type;
      send(sent, type == ButtonPress ? ButtonPressMask : ButtonReleaseMask);
    }
  }
  /// As the button in the corner of a window does it.
  void close() {
    XEvent sent = {};
    sent.xclient.type = ClientMessage;
    sent.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
    sent.xclient.format = 32;
    sent.xclient.data.l[0] = static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
    send(sent, NoEventMask);
  }
  ColorImage picture() {
    XWindowAttributes size = {};
    XGetWindowAttributes(display_, window_, &size);
    XImage* const image = XGetImage(display_, window_, 0, 0, static_cast<unsigned>(size.width),
                                    static_cast<unsigned>(size.height), AllPlanes, ZPixmap);
    if (image == nullptr) return {};
    ColorImage result(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const unsigned long pixel = XGetPixel(image, x, y);
        result.at(y, x) = {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
                           static_cast<std::uint8_t>(pixel)};
      }
    XDestroyImage(image);
    return result;
  }

 private:
  Window below(Window parent, const std::string& title) {
    char* name = nullptr;
    const bool is_it = XFetchName(display_, parent, &name) != 0 && name == title;
    if (name != nullptr) XFree(name);
    if (is_it) return parent;
    Window root = 0, up = 0, found = 0;
    Window* children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display_, parent, &root, &up, &children, &count) == 0) return 0;
    for (unsigned i = 0; i < count && found == 0; ++i) found = below(children[i], title);
    if (children != nullptr) XFree(children);
    return found;
  }
  void send(XEvent& event, long mask) {
    event.xany.display = display_;
    event.xany.window = window_;
    XSendEvent(display_, window_, True, mask, &event);
    XFlush(display_);
  }

  Display* display_;
  Window window_ = 0;
};

}  // namespace epcc::test
