# SPDX-License-Identifier: MIT
# Installs the run time's libraries and headers as the CMake package `flinch`,
# and the program.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY FLINCH_LIBRARIES)
get_property(runtime_libraries GLOBAL PROPERTY FLINCH_RUNTIME_LIBRARIES)
