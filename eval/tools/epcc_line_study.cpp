// SPDX-License-Identifier: BSD-3-Clause
// epcc_line_study: methods for the lines of laser scans, compared.
#include "eval/line_study/line_study_command.h"
#include "eval/program/command_line.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_line_study", epcc::lineStudyMain, argc, argv);
}
