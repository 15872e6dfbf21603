// SPDX-License-Identifier: BSD-3-Clause
// epcc_accuracy: the numbers and pictures of docs/research/accuracy.md.
#include <iostream>

#include "eval/accuracy/accuracy_command.h"

int main(int argc, char** argv) {
  return epcc::accuracyMain(argc, argv, std::cout, std::cerr);
}
