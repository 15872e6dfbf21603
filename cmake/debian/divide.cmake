# SPDX-License-Identifier: BSD-3-Clause
# Run by CPack between installing the components and packing them. The install components core, geometry and pcl are
# whole libraries; the packages for development hold all of them but what runs, which is in packages of its own. Each
# package gets its copyright file and its Debian changelog.
cmake_minimum_required(VERSION 3.22)

if(NOT CPACK_EPCC_PREFIX STREQUAL "/usr")
  message(STATUS "configured for ${CPACK_EPCC_PREFIX}: folders are not Debian's (preset package has them)")
endif()

# The licence's paragraphs as the copyright file wants them: lines begin with a blank, empty ones hold a dot.
file(READ ${CPACK_EPCC_SOURCE_DIR}/LICENSE license)
if(NOT license MATCHES "\nCopyright \\(c\\) ([^\n]+)\n+(.+[^\n])\n*$")
  message(FATAL_ERROR "LICENSE names no holder of the copyright")
endif()
set(holder "${CMAKE_MATCH_1}")
string(REPLACE "\n" "\n " license " ${CMAKE_MATCH_2}")
string(REPLACE "\n \n" "\n .\n" license "${license}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, if set
set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
foreach(component ${CPACK_COMPONENTS_ALL})
  set(files ${CPACK_TEMPORARY_DIRECTORY}/${component})
  if("${component}_runtime" IN_LIST CPACK_COMPONENTS_ALL)
    file(GLOB_RECURSE libraries ${files}/usr/lib/*.so.*)
    if(NOT libraries)
      message(FATAL_ERROR "component ${component} has no shared library to take out")
    endif()
    file(REMOVE ${libraries})
  endif()
  string(TOUPPER ${component} upper)
  set(documents ${files}/usr/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright.in ${documents}/copyright @ONLY
                 FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${documents}/changelog.Debian @ONLY
                 FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  execute_process(COMMAND gzip -9n ${documents}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
endforeach()
