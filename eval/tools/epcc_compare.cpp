// SPDX-License-Identifier: BSD-3-Clause
// epcc_compare: the paper's comparison and studies on rendered scenes.
#include <iostream>

#include "eval/comparison/compare_command.h"

int main(int argc, char** argv) {
  return epcc::compareMain(argc, argv, std::cout, std::cerr);
}
