// SPDX-License-Identifier: BSD-3-Clause
// epcc_accuracy: the numbers and pictures of docs/research/accuracy.md.
#include "eval/accuracy/accuracy_command.h"
#include "eval/program/command_line.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_accuracy", epcc::accuracyMain, argc, argv);
}
