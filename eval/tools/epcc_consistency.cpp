// SPDX-License-Identifier: BSD-3-Clause
// epcc_consistency: how right the covariances of planes and line segments are.
#include "eval/consistency/consistency_command.h"
#include "eval/program/command_line.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_consistency", epcc::consistencyMain, argc, argv);
}
