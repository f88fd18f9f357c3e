# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors

# The reference of all classes and functions, where Doxygen is installed:
# `ninja doxygen` writes build/reference, and fails on any warning.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  set(DOXYGEN_PROJECT_NAME stickslip)
  set(DOXYGEN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/reference)
  set(DOXYGEN_STRIP_FROM_PATH ${CMAKE_SOURCE_DIR}/include)
  set(DOXYGEN_STRIP_FROM_INC_PATH ${CMAKE_SOURCE_DIR}/include)
  set(DOXYGEN_FILE_PATTERNS *.h *.dox)
  set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
  set(DOXYGEN_GENERATE_LATEX NO)
  set(DOXYGEN_HAVE_DOT NO)
  set(DOXYGEN_QUIET YES)
  set(DOXYGEN_EXTRACT_ALL YES)
  set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
  # Files and namespaces without a docstring of their own.
  set(DOXYGEN_SHOW_NAMESPACES NO)
  # Macros of deal.II that declare exceptions.
  set(DOXYGEN_ENABLE_PREPROCESSING YES)
  set(DOXYGEN_MACRO_EXPANSION YES)
  doxygen_add_docs(doxygen
    ${CMAKE_SOURCE_DIR}/include ${CMAKE_SOURCE_DIR}/doc/main_page.dox
    COMMENT "Reference in ${CMAKE_BINARY_DIR}/reference/html/index.html")
endif()
