# SPDX-License-Identifier: BSD-3-Clause
# Man pages of the programs and what bash completes, both written from each program's --help when it is built.
option(EPCC_WITH_TOOL_PAGES "Write and install man pages and bash completion of the programs (needs Python)" ON)

# epcc_install_tool_pages(COMPONENT program ...)
function(epcc_install_tool_pages component)
  if(NOT EPCC_WITH_TOOL_PAGES)
    return()
  endif()
  find_package(Python3 3.8 QUIET COMPONENTS Interpreter)
  if(NOT Python3_FOUND OR (CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR))
    message(STATUS "without Python, or where programs cannot be run, man pages and bash completion are left out")
    return()
  endif()

  set(writer ${PROJECT_SOURCE_DIR}/scripts/tool_pages)
  file(GLOB sources CONFIGURE_DEPENDS ${writer}/*.py ${writer}/*.in)
  set(see_also epcc_compare epcc_eval epcc_lines epcc_noise epcc_scene epcc_segment epcc_track epcc_view)
  set(man_pages "")
  set(completions "")
  foreach(tool ${ARGN})
    set(man ${PROJECT_BINARY_DIR}/man/${tool}.1.gz)
    set(completion ${PROJECT_BINARY_DIR}/completions/${tool})
    add_custom_command(OUTPUT ${man} ${completion}
      COMMAND ${Python3_EXECUTABLE} -B ${writer}/write_pages.py $<TARGET_FILE:${tool}> --man ${man}
              --completion ${completion} --see-also ${see_also}
      DEPENDS ${tool} epcc_segment ${sources} COMMENT "Man page and completion of ${tool}" VERBATIM)
    list(APPEND man_pages ${man})
    list(APPEND completions ${completion})
  endforeach()
  add_custom_target(${component}_pages ALL DEPENDS ${man_pages} ${completions})
  install(FILES ${man_pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
  install(FILES ${completions} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${component})
endfunction()
