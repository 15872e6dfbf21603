// SPDX-License-Identifier: BSD-3-Clause
// epcc_noise: the error of a sensor, measured on its frames.
#include <iostream>

#include "eval/noise/noise_command.h"

int main(int argc, char** argv) {
  return epcc::noiseMain(argc, argv, std::cout, std::cerr);
}
