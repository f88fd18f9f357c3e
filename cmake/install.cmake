# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors

# What 'cmake --install' puts where. With '--component solver' it is the solver
# alone: find_package(stickslip) then gives stickslip::solver; together with the
# component program also stickslip::stickslip, all that the program consists of.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/stickslip)

install(TARGETS stickslip_solver EXPORT solver
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT solver)
install(EXPORT solver
  NAMESPACE stickslip::
  FILE solver_targets.cmake
  DESTINATION ${package_directory} COMPONENT solver)
foreach(module ${solver_modules})
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/stickslip/${module}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/stickslip COMPONENT solver)
endforeach()
# Headers that serve all modules.
file(GLOB common_headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/include/stickslip/*.h)
install(FILES ${common_headers}
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/stickslip COMPONENT solver)

file(STRINGS ${CMAKE_SOURCE_DIR}/include/stickslip/version.h version_line
  REGEX " version.*= *\"")
string(REGEX REPLACE ".*\"([0-9.]+).*" "\\1" stickslip_version "${version_line}")
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/stickslip-config.cmake.in
  ${CMAKE_BINARY_DIR}/stickslip-config.cmake
  INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(
  ${CMAKE_BINARY_DIR}/stickslip-config-version.cmake
  VERSION ${stickslip_version}
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_BINARY_DIR}/stickslip-config.cmake
  ${CMAKE_BINARY_DIR}/stickslip-config-version.cmake
  DESTINATION ${package_directory} COMPONENT solver)

install(TARGETS stickslip_library EXPORT program
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT program)
install(EXPORT program
  NAMESPACE stickslip::
  FILE program_targets.cmake
  DESTINATION ${package_directory} COMPONENT program)
file(GLOB modules LIST_DIRECTORIES true CONFIGURE_DEPENDS
  RELATIVE ${CMAKE_SOURCE_DIR}/include/stickslip
  ${CMAKE_SOURCE_DIR}/include/stickslip/*)
foreach(module ${modules})
  if(NOT module IN_LIST solver_modules AND NOT module MATCHES "\\.h$")
    install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/stickslip/${module}
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/stickslip COMPONENT program)
  endif()
endforeach()
install(TARGETS stickslip
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/parameters
  DESTINATION ${CMAKE_INSTALL_DATADIR}/stickslip COMPONENT program)
