// SPDX-License-Identifier: BSD-3-Clause
// epcc_scene: labelled frames of rendered scenes.
#include "eval/program/command_line.h"
#include "eval/scene/scene_command.h"

int main(int argc, char** argv) {
  return epcc::runMain("epcc_scene", epcc::sceneMain, argc, argv);
}
