// SPDX-License-Identifier: BSD-3-Clause
// epcc_segment: planes of organized point clouds and depth images.
#include "eval/program/command_line.h"
#include "eval/segment/segment_command.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_segment", epcc::segmentMain, argc, argv);
}
