// SPDX-License-Identifier: BSD-3-Clause
// epcc_lines: line segments of laser scans.
#include "eval/lines/lines_command.h"
#include "eval/program/command_line.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_lines", epcc::linesMain, argc, argv);
}
