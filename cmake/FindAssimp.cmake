# SPDX-License-Identifier: MIT
# Assimp::Assimp, from Debian's libassimp-dev. Its own CMake package names targets of packages that
# it does not install.
find_path(Assimp_INCLUDE_DIR assimp/Importer.hpp)
find_library(Assimp_LIBRARY assimp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Assimp REQUIRED_VARS Assimp_LIBRARY Assimp_INCLUDE_DIR)
if(Assimp_FOUND AND NOT TARGET Assimp::Assimp)
  add_library(Assimp::Assimp UNKNOWN IMPORTED)
  set_target_properties(Assimp::Assimp PROPERTIES IMPORTED_LOCATION ${Assimp_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${Assimp_INCLUDE_DIR})
endif()
mark_as_advanced(Assimp_INCLUDE_DIR Assimp_LIBRARY)
