// SPDX-License-Identifier: BSD-3-Clause
// The keys of epcc_view: one table for what they do and for the help.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace epcc {

/// What a key asks for.
enum class ViewCommand {
  NextInput,
  PreviousInput,
  FirstInput,
  LastInput,
  NextSensor,
  PreviousSensor,
  SwitchMode,
  NextParameter,
  PreviousParameter,
  RaiseParameter,
  LowerParameter,
  ResetParameters,
  NextPlane,
  PreviousPlane,
  SelectNone,
  NextSurface,
  SwitchOutlines,
  SwitchOutlineKind,
  SwitchNormals,
  SwitchUnlabelled,
  LargerPoints,
  SmallerPoints,
  NextPlace,
  SamePlace,
  SwitchTexts,
  SwitchHelp,
  Quit
};

/// One line of the table. Names are those of the X Window System: "n", "Right", "Prior", ...
struct ViewKey {
  ViewCommand command;
  std::vector<const char*> names;
  const char* shown;  ///< the keys as a person reads them
  const char* effect;
};

const std::vector<ViewKey>& viewKeys();

/// What a key asks for; capital letters count as small ones unless they have a meaning of their own.
std::optional<ViewCommand> commandOf(const std::string& key);

/// The names in "n,n,plus", as --keys has them; nothing, and `unknown` says which, if one of them does nothing.
std::optional<std::vector<std::string>> keysFrom(const std::string& text, std::string& unknown);

/// One line for each key, for the window.
std::string keyHelp();

}  // namespace epcc
