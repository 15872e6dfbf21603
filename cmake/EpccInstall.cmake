# SPDX-License-Identifier: BSD-3-Clause
# How a library of the project is installed: for CMake's find_package and for pkg-config, below any prefix.
set(EPCC_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/epcc_segmentation)
set(EPCC_PKGCONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# epcc_install_library(TARGET COMPONENT c DESCRIPTION text [NEEDS package ...] [NEEDS_INSIDE package ...]
# [FLAGS_INSIDE flag ...]): the library, its export file and TARGET.pc. NEEDS are the pkg-config packages that its
# headers include. What it needs inside, a shared library brings along itself; with a static one the program links it.
function(epcc_install_library target)
  cmake_parse_arguments(ARG "" "COMPONENT;DESCRIPTION" "NEEDS;NEEDS_INSIDE;FLAGS_INSIDE" ${ARGN})
  install(TARGETS ${target} EXPORT ${target}Targets COMPONENT ${ARG_COMPONENT})
  install(EXPORT ${target}Targets NAMESPACE epcc:: DESTINATION ${EPCC_PACKAGE_DIR} COMPONENT ${ARG_COMPONENT})
  # The library without what is for development: a Debian package of its own (EpccPackages.cmake).
  if(BUILD_SHARED_LIBS)
    install(TARGETS ${target} LIBRARY COMPONENT ${ARG_COMPONENT}_runtime NAMELINK_SKIP EXCLUDE_FROM_ALL)
  endif()

  set(needs ${ARG_NEEDS})
  set(flags "")
  if(NOT BUILD_SHARED_LIBS)
    list(APPEND needs ${ARG_NEEDS_INSIDE})
    set(flags ${ARG_FLAGS_INSIDE})
  endif()
  list(JOIN needs ", " needs)
  list(JOIN flags " " flags)
  # From the folder that the file lies in to the prefix, wherever that is.
  file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_PREFIX}/${EPCC_PKGCONFIG_DIR} ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" to_prefix "${to_prefix}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/library.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${target}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${target}.pc DESTINATION ${EPCC_PKGCONFIG_DIR}
          COMPONENT ${ARG_COMPONENT})
endfunction()
