# SPDX-License-Identifier: MIT
# Installs the run time's libraries, with looking ahead and the reaction to a hit, and the public
# headers as the CMake package `flinch`, its C interface also for pkg-config, and the program.
# The offline libraries stay behind: a game has no use for them, and the program does their work.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

flinch_link_closure(runtime_libraries flinch_reaction)
flinch_link_closure(lookahead_libraries flinch_lookahead)
list(APPEND runtime_libraries ${lookahead_libraries})
list(REMOVE_DUPLICATES runtime_libraries)
list(FILTER runtime_libraries INCLUDE REGEX "^flinch_")
list(REMOVE_ITEM runtime_libraries flinch_flags)
install(TARGETS ${runtime_libraries} EXPORT flinch
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)

# The public headers alone. They keep their folder, as in `#include "runtime/character.h"`, but for
# that of the C interface.
foreach(header IN LISTS FLINCH_PUBLIC_HEADERS)
  cmake_path(GET header PARENT_PATH folder)
  set(destination ${CMAKE_INSTALL_INCLUDEDIR}/flinch/${folder})
  if(header STREQUAL "runtime/c/flinch.h")
    set(destination ${CMAKE_INSTALL_INCLUDEDIR})
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${destination}
    COMPONENT development)
endforeach()

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/flinch)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/flinchConfig.cmake.in
  ${PROJECT_BINARY_DIR}/flinchConfig.cmake INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/flinchConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/flinchConfig.cmake
  ${PROJECT_BINARY_DIR}/flinchConfigVersion.cmake DESTINATION ${package_directory}
  COMPONENT development)
install(EXPORT flinch NAMESPACE flinch:: FILE flinchTargets.cmake DESTINATION ${package_directory}
  COMPONENT development)

# The C interface, as one library: `flinch::flinch`, and for all build systems `flinch.pc`, which
# finds its prefix from where it is.
install(TARGETS flinch_shared flinch_static EXPORT flinch_c
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT flinch_c NAMESPACE flinch:: FILE flinchCTargets.cmake
  DESTINATION ${package_directory} COMPONENT development)
file(RELATIVE_PATH to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/flinch.pc.in ${PROJECT_BINARY_DIR}/flinch.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/flinch.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT license)

if(TARGET flinch)
  install(TARGETS flinch RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/trials.sql DESTINATION ${CMAKE_INSTALL_DATADIR}/flinch
    COMPONENT program)
  if(TARGET flinch_manual)
    install(DIRECTORY ${FLINCH_MANUAL}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR}
      COMPONENT program)
    install(FILES ${FLINCH_MANUAL}/bash/flinch
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
  endif()
  # Where the program finds its pages (program/page.h).
  if(TARGET flinch_report_page)
    install(FILES ${FLINCH_REPORT_PAGE} DESTINATION ${CMAKE_INSTALL_DATADIR}/flinch
      COMPONENT program)
  endif()
  if(TARGET flinch_page)
    install(FILES ${FLINCH_PAGE} DESTINATION ${CMAKE_INSTALL_DATADIR}/flinch RENAME page.html
      COMPONENT program)
  endif()
endif()
