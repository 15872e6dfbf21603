#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and runs the programs of tests/install_consumer/program with what pkg-config says, and nothing else:
# build_with_pkg_config.sh SOURCES BUILD_FOLDER [LIBRARY...], of core, geometry and pcl. In the environment, CXX and
# PKG_CONFIG_PATH; PKG_CONFIG_FLAGS=--static as for a static program; RUN_PATH, where the system finds shared libraries.
set -euo pipefail

sources=$1 folder=$2
shift 2
if (($# == 0)); then set -- core geometry pcl; fi
mkdir -p "$folder"
compiler=("${CXX:-g++}")
if [[ -n ${CMAKE_CXX_COMPILER_LAUNCHER:-} ]]; then compiler=("$CMAKE_CXX_COMPILER_LAUNCHER" "${compiler[@]}"); fi
read -ra more <<<"${PKG_CONFIG_FLAGS:-}"
for library; do
  package=epcc_$library
  if [[ $library == pcl ]]; then package=epcc_segmentation; fi
  read -ra compile < <(pkg-config "${more[@]}" --cflags "$package")
  read -ra link < <(pkg-config "${more[@]}" --libs "$package")
  "${compiler[@]}" -std=c++17 "${compile[@]}" -c "$sources/use_$library.cpp" -o "$folder/use_$library.o"
  "${CXX:-g++}" "$folder/use_$library.o" -o "$folder/use_$library" "${link[@]}"
  LD_LIBRARY_PATH=${RUN_PATH:-} "$folder/use_$library"
done
