// SPDX-License-Identifier: BSD-3-Clause
// epcc_track: planes over time.
#include "eval/program/command_line.h"
#include "eval/track/track_command.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_track", epcc::trackMain, argc, argv);
}
