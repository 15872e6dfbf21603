# SPDX-License-Identifier: BSD-3-Clause
# Script of the test: install, look at the headers, configure, build and run the outside programs.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif()
endfunction()

string(REPLACE "," ";" components "${COMPONENTS}")
file(REMOVE_RECURSE ${WORK_DIR})
set(prefix ${WORK_DIR}/prefix)
# The libraries' folder only: nothing else of the build is installed.
run(${CMAKE_COMMAND} --install ${BUILD_DIR}/epcc_segmentation --prefix ${prefix} --config "${CONFIG}")

# The public headers and no others; those of the PCL class where it was built.
file(GLOB_RECURSE expected RELATIVE ${INCLUDE_DIR} ${INCLUDE_DIR}/*)
if(NOT "pcl" IN_LIST components)
  list(FILTER expected EXCLUDE REGEX "/epcc_segmentation\\.h$|/pcl/")
endif()
file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*)
list(SORT headers)
list(SORT expected)
if(NOT headers STREQUAL expected)
  message(FATAL_ERROR "installed headers: ${headers}\nexpected: ${expected}")
endif()

foreach(component ${components})
  set(build ${WORK_DIR}/${component})
  run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${build} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${CONFIG}
      -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_CXX_FLAGS=${FLAGS}
      -DCMAKE_PREFIX_PATH=${prefix} -DEPCC_COMPONENT=${component})
  run(${CMAKE_COMMAND} --build ${build} --config "${CONFIG}")
  run(${build}/use_${component})
endforeach()

# A component that does not exist is refused.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/unknown -G ${GENERATOR}
                        -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${prefix} -DEPCC_COMPONENT=unknown
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
if(result EQUAL 0)
  message(FATAL_ERROR "find_package(epcc_segmentation COMPONENTS unknown) succeeded")
endif()
