// SPDX-License-Identifier: BSD-3-Clause
// Keys are looked up in one table; the first name of a line is the one to type after --keys.
#include "eval/view/view_keys.h"

#include <cctype>
#include <cstdio>
#include <cstring>
#include <sstream>

namespace epcc {

const std::vector<ViewKey>& viewKeys() {
  using C = ViewCommand;
  static const std::vector<ViewKey> keys = {
      {C::NextInput, {"n", "Right", "Next", "space"}, "n, right", "next input"},
      {C::PreviousInput, {"p", "Left", "Prior", "BackSpace"}, "p, left", "previous input"},
      {C::FirstInput, {"Home"}, "home", "first input"},
      {C::LastInput, {"End"}, "end", "last input"},
      {C::NextSensor, {"s"}, "s", "next sensor model: as given, auto, presets"},
      {C::PreviousSensor, {"S"}, "S", "previous sensor model"},
      {C::SwitchMode, {"m"}, "m", "the other mode: inverse-depth or paper"},
      {C::NextParameter, {"Down"}, "down", "next parameter"},
      {C::PreviousParameter, {"Up"}, "up", "previous parameter"},
      {C::RaiseParameter, {"plus", "+", "equal", "KP_Add"}, "+", "raise the parameter"},
      {C::LowerParameter, {"minus", "-", "KP_Subtract"}, "-", "lower the parameter"},
      {C::ResetParameters, {"0", "KP_0"}, "0", "parameters and sensor as the program was started"},
      {C::NextPlane, {"Tab"}, "tab, click", "select a plane and read its numbers"},
      {C::PreviousPlane, {"b", "ISO_Left_Tab"}, "b", "select the plane before it"},
      {C::SelectNone, {"Escape"}, "esc", "select none"},
      {C::NextSurface, {"f"}, "f", "points, mesh (faces), or both"},
      {C::SwitchOutlines, {"o"}, "o", "outlines on or off"},
      {C::SwitchOutlineKind, {"c"}, "c", "outlines as polygons or as contours of the pixels"},
      {C::SwitchNormals, {"a"}, "a", "normals (arrows) on or off"},
      {C::SwitchUnlabelled, {"u"}, "u", "points on no plane on or off"},
      {C::LargerPoints, {"period", ">", "greater"}, ".", "larger points"},
      {C::SmallerPoints, {"comma", "<", "less"}, ",", "smaller points"},
      {C::NextPlace, {"v"}, "v", "look from the sensor, from behind it, from above"},
      {C::SamePlace, {"r"}, "r", "look from there anew"},
      {C::SwitchTexts, {"t"}, "t", "texts on or off"},
      {C::SwitchHelp, {"h", "question", "F1"}, "h", "this help on or off"},
      {C::Quit, {"q"}, "q", "quit"},
  };
  return keys;
}

namespace {

std::optional<ViewCommand> commandNamed(const std::string& name) {
  for (const ViewKey& key : viewKeys())
    for (const char* known : key.names)
      if (name == known) return key.command;
  return std::nullopt;
}

}  // namespace

std::optional<ViewCommand> commandOf(const std::string& key) {
  const std::optional<ViewCommand> command = commandNamed(key);
  if (command || key.size() != 1) return command;
  return commandNamed(std::string(1, static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])))));
}

std::optional<std::vector<std::string>> keysFrom(const std::string& text, std::string& unknown) {
  std::vector<std::string> keys;
  std::istringstream stream(text);
  for (std::string key; std::getline(stream, key, ',');) {
    if (!commandOf(key)) {
      unknown = key;
      return std::nullopt;
    }
    keys.push_back(key);
  }
  return keys;
}

std::string keyHelp() {
  std::string help;
  for (const ViewKey& key : viewKeys()) {
    char line[120];
    std::snprintf(line, sizeof line, "%-11s %s\n", key.shown, key.effect);
    help += line;
  }
  return help + "mouse       left turns, right or wheel zooms, middle moves\n";
}

}  // namespace epcc
