// SPDX-License-Identifier: BSD-3-Clause
// epcc_noise: the error of a sensor, measured on its frames.
#include "eval/noise/noise_command.h"
#include "eval/program/command_line.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_noise", epcc::noiseMain, argc, argv);
}
