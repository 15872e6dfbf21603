// SPDX-License-Identifier: BSD-3-Clause
// epcc_view: planes of point clouds and depth images in a window.
#include <iostream>

#include "eval/view/view_command.h"

int main(int argc, char** argv) {
  return epcc::viewMain(argc, argv, std::cout, std::cerr);
}
