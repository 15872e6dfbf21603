// SPDX-License-Identifier: BSD-3-Clause
// epcc_track: planes over time.
#include <iostream>

#include "eval/track/track_command.h"

int main(int argc, char** argv) {
  return epcc::trackMain(argc, argv, std::cout, std::cerr);
}
