# SPDX-License-Identifier: BSD-3-Clause
# Compile options shared by every target of the project.

option(EPCC_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" ON)

function(epcc_set_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # No contraction to fused multiply-add: labels must not depend on the processor.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wpedantic
                         -fno-math-errno -ffp-contract=off)
  if(EPCC_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
