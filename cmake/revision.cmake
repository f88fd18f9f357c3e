# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors

# stickslip_revision.h, which says what the program is built from: it is looked at
# in each build, and written where that has changed. The file is its own script.
if(CMAKE_SCRIPT_MODE_FILE)
  set(revision "")
  find_package(Git QUIET)
  if(GIT_FOUND)
    execute_process(
      COMMAND ${GIT_EXECUTABLE} describe --always --dirty --abbrev=12 --exclude=*
      WORKING_DIRECTORY ${SOURCE_DIRECTORY}
      OUTPUT_VARIABLE revision
      OUTPUT_STRIP_TRAILING_WHITESPACE
      ERROR_QUIET)
  endif()
  if(NOT revision)
    set(revision unknown)
  endif()
  file(CONFIGURE OUTPUT ${HEADER} CONTENT
"#define STICKSLIP_REVISION \"${revision}\"
#define STICKSLIP_BUILD_TYPE \"${BUILD_TYPE}\"
")
  return()
endif()

set(revision_header ${CMAKE_BINARY_DIR}/revision/stickslip_revision.h)
add_custom_target(stickslip_revision
  COMMAND ${CMAKE_COMMAND}
    -DSOURCE_DIRECTORY=${CMAKE_SOURCE_DIR}
    -DHEADER=${revision_header}
    -DBUILD_TYPE=${CMAKE_BUILD_TYPE}
    -P ${CMAKE_CURRENT_LIST_FILE}
  BYPRODUCTS ${revision_header}
  VERBATIM)
# Only this file sees it.
set_source_files_properties(${CMAKE_SOURCE_DIR}/source/scene/version_report.cc
  PROPERTIES
  INCLUDE_DIRECTORIES ${CMAKE_BINARY_DIR}/revision
  OBJECT_DEPENDS ${revision_header}
  SKIP_PRECOMPILE_HEADERS ON)
