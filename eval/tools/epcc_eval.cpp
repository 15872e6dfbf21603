// SPDX-License-Identifier: BSD-3-Clause
// epcc_eval: plane segmentation methods scored on labelled frames.
#include <iostream>

#include "eval/batch/eval_command.h"

int main(int argc, char** argv) {
  return epcc::evalMain(argc, argv, std::cout, std::cerr);
}
