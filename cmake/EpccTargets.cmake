# SPDX-License-Identifier: BSD-3-Clause
# What every target of the project shares.

option(EPCC_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" ${PROJECT_IS_TOP_LEVEL})

option(EPCC_COUNT_LINES "Count how often each line of the libraries runs, for scripts/coverage.sh" OFF)

# epcc_count_lines(TARGET): with EPCC_COUNT_LINES. The core's tests are not counted: it takes half as long again to
# compile them. What counts knows where its counts go: to a folder that is the same for all clones, so that ccache shares
# it between them, below the build of the one that runs (GCOV_PREFIX in the tests' preset).
function(epcc_count_lines target)
  if(EPCC_COUNT_LINES)
    target_compile_options(${target} PRIVATE --coverage "-fprofile-dir=/tmp/epcc-lines")
    target_link_options(${target} INTERFACE --coverage)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "SHARED_LIBRARY")
      target_link_options(${target} PRIVATE --coverage)
    endif()
  endif()
endfunction()

function(epcc_set_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    # No contraction to fused multiply-add: labels must not depend on the processor.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wpedantic
                           -fno-math-errno -ffp-contract=off)
    if(EPCC_WARNINGS_AS_ERRORS)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
endfunction()

# epcc_keep_kernels_apart(TARGET): a kernel's source includes itself, once for each vector unit; a unity build
# (CMAKE_UNITY_BUILD), as the presets have it, leaves such sources alone.
function(epcc_keep_kernels_apart target)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    file(STRINGS ${source} kernel REGEX "hwy/foreach_target.h" LIMIT_COUNT 1)
    if(kernel)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

# epcc_add_library(NAME SOURCES a.cpp ... [PUBLIC lib ...] [PRIVATE lib ...]): the library of one room; its headers are
# included by their path from the project's top.
function(epcc_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  epcc_set_options(${name})
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  if(room MATCHES "^(datasets|eval/measures)")  # what coverage.sh looks at
    epcc_count_lines(${name})
  endif()
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()
