// SPDX-License-Identifier: BSD-3-Clause
// epcc_line_study: methods for the lines of laser scans, compared.
#include <iostream>

#include "eval/line_study/line_study_command.h"

int main(int argc, char** argv) {
  return epcc::lineStudyMain(argc, argv, std::cout, std::cerr);
}
