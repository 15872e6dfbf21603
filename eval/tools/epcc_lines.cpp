// SPDX-License-Identifier: BSD-3-Clause
// epcc_lines: line segments of laser scans.
#include <iostream>

#include "eval/lines/lines_command.h"

int main(int argc, char** argv) {
  return epcc::linesMain(argc, argv, std::cout, std::cerr);
}
