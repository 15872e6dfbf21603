// SPDX-License-Identifier: BSD-3-Clause
// epcc_segment: planes of organized point clouds and depth images.
#include <iostream>

#include "eval/segment/segment_command.h"

int main(int argc, char** argv) {
  return epcc::segmentMain(argc, argv, std::cout, std::cerr);
}
