# SPDX-License-Identifier: BSD-3-Clause
# Debian packages by CPack, divided and named as Debian does it: each library as what runs and as what is for
# development, the Python module, the programs, the viewer. They are built with the prefix /usr: preset package,
# docs/reference/packages.md.
if(NOT BUILD_SHARED_LIBS OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux")
  return()
endif()

set(EPCC_PACKAGE_CONTACT "the EPCC segmentation authors <epcc-segmentation@localhost>" CACHE STRING
    "Maintainer that the Debian packages name")
set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME epcc-segmentation)
set(CPACK_PACKAGE_CONTACT ${EPCC_PACKAGE_CONTACT})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS  # whatever the umask
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE ${CPACK_PACKAGE_NAME})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_THREADS 0)
# dpkg-shlibdeps finds this project's libraries here; the packages that will hold them are named below.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/epcc_segmentation)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/divide.cmake)
set(CPACK_EPCC_SOURCE_DIR ${PROJECT_SOURCE_DIR})
set(CPACK_EPCC_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_COMPONENTS_ALL "")

set(abi ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})  # the libraries' SOVERSION
set(this_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
# Lines as they are read; CPack writes the blanks and dots of the control file.
set(about [[
EPCC finds the planes in depth images and organized point clouds by evolving
principal component clustering: line segments of scan lines first, planes of
neighbouring line segments next, both judged by the noise of the sensor.

]])

# epcc_package(COMPONENT [BINARY] NAME name SECTION section SUMMARY line HOLDS line ... [DEPENDS package ...]
# [RECOMMENDS package ...] [SUGGESTS package ...] [CONTROL file ...]): with BINARY, what its files link is added to
# DEPENDS.
macro(epcc_package component)
  cmake_parse_arguments(ARG BINARY "NAME;SECTION;SUMMARY" "HOLDS;DEPENDS;RECOMMENDS;SUGGESTS;CONTROL" ${ARGN})
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  list(JOIN ARG_HOLDS "\n" holds)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${ARG_SUMMARY}\n${about}${holds}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${ARG_NAME})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${ARG_SECTION})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ${ARG_BINARY})
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${ARG_CONTROL}")
  foreach(relation DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN ARG_${relation} ", " CPACK_DEBIAN_${upper}_PACKAGE_${relation})
  endforeach()
endmacro()

# epcc_library_packages(COMPONENT STEM SUMMARY [LIBRARIES package ...] [DEVELOPMENT package ...]
# [SUGGESTS package ...]): STEM0.1 with the library, which needs LIBRARIES, and STEM-dev, whose headers need
# DEVELOPMENT. (CPack adds scripts that call ldconfig, too; the trigger is Debian's way.)
macro(epcc_library_packages component stem summary)
  string(REPLACE "-" "_" library ${stem})
  cmake_parse_arguments(LIB "" "" "LIBRARIES;DEVELOPMENT;SUGGESTS" ${ARGN})
  epcc_package(${component}_runtime BINARY NAME ${stem}${abi} SECTION libs SUMMARY "${summary}"
    HOLDS "This package holds the shared library." DEPENDS ${LIB_LIBRARIES}
    CONTROL ${PROJECT_BINARY_DIR}/debian/${component}/shlibs ${PROJECT_SOURCE_DIR}/cmake/debian/library/triggers)
  file(WRITE ${PROJECT_BINARY_DIR}/debian/${component}/shlibs
       "${library} ${abi} ${stem}${abi} (>= ${PROJECT_VERSION})\n")
  epcc_package(${component} NAME ${stem}-dev SECTION libdevel SUMMARY "${summary} (development files)"
    HOLDS "This package holds the C++ headers and what CMake and pkg-config need."
    DEPENDS "${stem}${abi} ${this_version}" ${LIB_DEVELOPMENT} SUGGESTS ${LIB_SUGGESTS})
endmacro()

set(core_library "libepcc-core${abi} ${this_version}")
set(core_headers "libepcc-core-dev ${this_version}")
epcc_library_packages(core libepcc-core "planes of depth images and organized clouds"
  DEVELOPMENT "libeigen3-dev (>= 3.3)" SUGGESTS libepcc-geometry-dev libepcc-segmentation-dev)
if(TARGET epcc_geometry)
  set(geometry_library "libepcc-geometry${abi} ${this_version}")
  epcc_library_packages(geometry libepcc-geometry "polygons and meshes of planes in depth images"
    LIBRARIES ${core_library} DEVELOPMENT ${core_headers})
endif()
if(TARGET epcc_segmentation)
  epcc_library_packages(pcl libepcc-segmentation "planes of organized point clouds, for PCL"
    LIBRARIES ${core_library} DEVELOPMENT ${core_headers} libpcl-dev)
endif()

if(TARGET epcc_python)
  # The module is for one version of Python.
  foreach(part MAJOR MINOR)
    get_directory_property(python_${part} DIRECTORY epcc_segmentation/python DEFINITION Python3_VERSION_${part})
  endforeach()
  math(EXPR next_minor "${python_MINOR} + 1")
  epcc_package(python BINARY NAME python3-epcc SECTION python
    SUMMARY "planes of depth images and organized clouds, in Python"
    HOLDS "This package holds the module epcc for Python ${python_MAJOR}.${python_MINOR}, which works"
          "on numpy arrays."
    DEPENDS "python3 (>= ${python_MAJOR}.${python_MINOR})" "python3 (<< ${python_MAJOR}.${next_minor})" python3-numpy
    CONTROL ${PROJECT_SOURCE_DIR}/cmake/debian/python/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/python/prerm)
endif()
if(EPCC_BUILD_TOOLS)
  set(viewer "")
  if(TARGET epcc_view)
    set(viewer epcc-viewer)
    epcc_package(viewer BINARY NAME epcc-viewer SECTION science SUMMARY "planes of depth images and clouds in a window"
      HOLDS "This package holds epcc_view, which shows frames with their planes and lets"
            "sensor and parameters be changed by keys." DEPENDS ${core_library} ${geometry_library})
  endif()
  epcc_package(tools BINARY NAME epcc-tools SECTION science SUMMARY "programs for planes of depth images and clouds"
    HOLDS "This package holds epcc_segment (planes of frames and folders), epcc_track"
          "(planes over time), epcc_eval (methods scored on labelled frames),"
          "epcc_noise (the noise of a sensor), epcc_lines (lines of laser scans),"
          "epcc_scene and epcc_compare."
    DEPENDS ${core_library} ${geometry_library} RECOMMENDS ${viewer} SUGGESTS libepcc-core-dev python3-epcc)
endif()

include(CPack)
