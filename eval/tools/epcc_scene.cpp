// SPDX-License-Identifier: BSD-3-Clause
// epcc_scene: labelled frames of rendered scenes.
#include <iostream>

#include "eval/scene/scene_command.h"

int main(int argc, char** argv) {
  return epcc::sceneMain(argc, argv, std::cout, std::cerr);
}
