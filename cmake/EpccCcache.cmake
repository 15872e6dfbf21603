# SPDX-License-Identifier: BSD-3-Clause
# Compile through ccache where it is installed. Paths below the sources count relative to them, so that a fresh clone
# anywhere else, as CI has it, finds what another one has compiled.
find_program(EPCC_CCACHE ccache)
if(EPCC_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(epcc_launcher ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${EPCC_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${epcc_launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${epcc_launcher})
endif()
