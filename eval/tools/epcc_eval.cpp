// SPDX-License-Identifier: BSD-3-Clause
// epcc_eval: plane segmentation methods scored on labelled frames.
#include "eval/batch/eval_command.h"
#include "eval/program/command_line.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_eval", epcc::evalMain, argc, argv);
}
