// SPDX-License-Identifier: BSD-3-Clause
// epcc_compare: the paper's comparison and studies on rendered scenes.
#include "eval/comparison/compare_command.h"
#include "eval/program/command_line.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_compare", epcc::compareMain, argc, argv);
}
