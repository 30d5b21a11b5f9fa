# SPDX-License-Identifier: MIT
# Installs the run time's libraries and headers as the CMake package `flinch`, its C interface also
# for pkg-config, the reaction to a hit as the package's component `reaction`, and the program.
# The offline libraries stay behind: a game has no use for them, and the program does their work.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

flinch_link_closure(runtime_libraries flinch_runtime)
list(FILTER runtime_libraries INCLUDE REGEX "^flinch_")
list(REMOVE_ITEM runtime_libraries flinch_flags)
install(TARGETS ${runtime_libraries} EXPORT flinch ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

# Headers keep their folder: `#include "runtime/response/response.h"`.
foreach(library IN LISTS runtime_libraries)
  get_target_property(folder ${library} SOURCE_DIR)
  file(GLOB headers CONFIGURE_DEPENDS ${folder}/*.h)
  file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${folder})
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/flinch/${name})
endforeach()

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/flinch)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/flinchConfig.cmake.in
  ${PROJECT_BINARY_DIR}/flinchConfig.cmake INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/flinchConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/flinchConfig.cmake
  ${PROJECT_BINARY_DIR}/flinchConfigVersion.cmake DESTINATION ${package_directory})
install(EXPORT flinch NAMESPACE flinch:: FILE flinchTargets.cmake DESTINATION ${package_directory})

# The C interface, as one library: `flinch::flinch`, and for all build systems `flinch.pc`, which
# finds its prefix from where it is.
install(TARGETS flinch_shared flinch_static EXPORT flinch_c
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES ${PROJECT_SOURCE_DIR}/runtime/flinch.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT flinch_c NAMESPACE flinch:: FILE flinchCTargets.cmake
  DESTINATION ${package_directory})
file(RELATIVE_PATH to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/flinch.pc.in ${PROJECT_BINARY_DIR}/flinch.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/flinch.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# The reaction links ODE, which the package then looks for as this build did.
if(TARGET flinch_reaction)
  flinch_link_closure(reaction_libraries flinch_reaction)
  list(FILTER reaction_libraries INCLUDE REGEX "^flinch_")
  list(REMOVE_ITEM reaction_libraries flinch_flags ${runtime_libraries})
  install(TARGETS ${reaction_libraries} EXPORT flinch_reaction
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT flinch_reaction NAMESPACE flinch:: FILE flinchReactionTargets.cmake
    DESTINATION ${package_directory})
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/FindODE.cmake DESTINATION ${package_directory})
  foreach(header reaction/reacting_character reaction/reaction reaction/reaction_clips
          reaction/recovery sim/rehearsal/rehearsal sim/rehearsal/simulator sim/simulation_options)
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/${header}.h
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/flinch/${folder})
  endforeach()
endif()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(TARGET flinch)
  install(TARGETS flinch RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
