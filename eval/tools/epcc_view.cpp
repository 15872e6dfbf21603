// SPDX-License-Identifier: BSD-3-Clause
// epcc_view: planes of point clouds and depth images in a window.
#include "eval/program/command_line.h"
#include "eval/view/view_command.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_view", epcc::viewMain, argc, argv);
}
