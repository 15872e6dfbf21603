// SPDX-License-Identifier: BSD-3-Clause
// epcc_consistency: how right the covariances of planes and line segments are.
#include <iostream>

#include "eval/consistency/consistency_command.h"

int main(int argc, char** argv) {
  return epcc::consistencyMain(argc, argv, std::cout, std::cerr);
}
