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

# The public headers and no others; those of the PCL class and of the geometry where they were built.
file(GLOB_RECURSE expected RELATIVE ${INCLUDE_DIR} ${INCLUDE_DIR}/*)
if(NOT "pcl" IN_LIST components)
  list(FILTER expected EXCLUDE REGEX "/epcc_segmentation\\.h$|/pcl/")
endif()
if(NOT "geometry" IN_LIST components)
  list(FILTER expected EXCLUDE REGEX "/(plane_edges|surface_[a-z]+)\\.h$")
endif()
file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*)
list(SORT headers)
list(SORT expected)
if(NOT headers STREQUAL expected)
  message(FATAL_ERROR "installed headers: ${headers}\nexpected: ${expected}")
endif()

# build_and_run(NAME COMPONENT FLAGS RUN [option ...]): an outside program, built with other flags than the library.
function(build_and_run name component flags run)
  set(build ${WORK_DIR}/${name})
  run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${build} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${CONFIG}
      -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} "-DCMAKE_CXX_FLAGS=${FLAGS} ${flags}"
      -DCMAKE_PREFIX_PATH=${prefix} -DEPCC_COMPONENT=${component} ${ARGN})
  run(${CMAKE_COMMAND} --build ${build} --config "${CONFIG}")
  if(run)
    run(${build}/use_${component})
  endif()
endfunction()

# What this processor cannot run is built all the same.
set(has_avx2 FALSE)
if(EXISTS /proc/cpuinfo)
  file(READ /proc/cpuinfo cpuinfo)
  if(cpuinfo MATCHES "[ \t]avx2[ \n]")
    set(has_avx2 TRUE)
  endif()
endif()
set(variants "plain||TRUE")
if(CMAKE_HOST_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND variants "native|-march=native|TRUE" "avx2|-mavx2|${has_avx2}")
endif()
foreach(variant ${variants})
  string(REPLACE "|" ";" parts "${variant}")
  list(GET parts 0 name)
  list(GET parts 1 flags)
  list(GET parts 2 run)
  build_and_run(core_${name} core "${flags}" ${run})
  if("geometry" IN_LIST components)
    build_and_run(geometry_${name} geometry "${flags}" ${run})
  endif()
  if("pcl" IN_LIST components)
    build_and_run(pcl_${name} pcl "${flags}" ${run})
    build_and_run(pcl_${name}_headers pcl "${flags}" ${run} -DEPCC_NO_PRECOMPILE=ON)
  endif()
endforeach()

# A shared library shows its public functions and no steps inside.
function(check_symbols library shown hidden)
  file(GLOB_RECURSE shared ${prefix}/*/${library})
  if(NOT shared)
    return()
  endif()
  execute_process(COMMAND nm -D --defined-only -C ${shared} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
  if(NOT result EQUAL 0 OR NOT symbols MATCHES "${shown}")
    message(FATAL_ERROR "${library} does not show ${shown}")
  endif()
  if(symbols MATCHES "${hidden}")
    message(FATAL_ERROR "${library} shows ${CMAKE_MATCH_0}")
  endif()
endfunction()
check_symbols(libepcc_core.so "epcc::PlaneExtractor::extract"
  "InverseDepthPipeline|LineClustering|LineGrowing|MetricPipeline")
check_symbols(libepcc_geometry.so "epcc::surfacePolygons" "GeosShapes|OutlineArcs|PixelRays")

# A version that is not this minor one is refused: before 1.0 each may change the interface.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/other_version -G ${GENERATOR}
                        -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${prefix} -DEPCC_COMPONENT=core
                        -DEPCC_WANTED_VERSION=0.0
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
if(result EQUAL 0)
  message(FATAL_ERROR "find_package(epcc_segmentation 0.0) succeeded")
endif()

# As a folder of another project: the libraries alone, and none of this project's strictness.
run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/../subproject -B ${WORK_DIR}/subproject -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DEPCC_SOURCE_DIR=${EPCC_SOURCE_DIR})

# A component that does not exist is refused, with the reason.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/unknown -G ${GENERATOR}
                        -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${prefix} -DEPCC_COMPONENT=unknown
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE error)
if(result EQUAL 0)
  message(FATAL_ERROR "find_package(epcc_segmentation COMPONENTS unknown) succeeded")
elseif(NOT error MATCHES "component unknown: there is none of this name")
  message(FATAL_ERROR "find_package(epcc_segmentation COMPONENTS unknown) does not say why: ${error}")
endif()
