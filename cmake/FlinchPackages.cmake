# SPDX-License-Identifier: MIT
# `cpack` in the build folder makes three .deb packages, of the program, the C library and what games
# are compiled with, and one .tar.gz with all of it; docs/packages.md.
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME flinch)
set(CPACK_PACKAGE_VENDOR "The Flinch authors")
set(CPACK_PACKAGE_CONTACT "The Flinch authors <authors@flinch.invalid>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_COMPONENTS_ALL program runtime development)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${PROJECT_DESCRIPTION}: the program
 Makes libraries of protective motion, simulates every clip against random
 threats, and trains the selector that a game loads.")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}: the C library
 Needs nothing but the C++ standard library.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION}: headers and static libraries
 For games in C, by pkg-config or CMake, and in C++.")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # dependencies are what the files link
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME flinch)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(runtime_package libflinch${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME ${runtime_package})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/packages/triggers)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libflinch-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${runtime_package} (= ${PROJECT_VERSION}), libeigen3-dev (>= 3.4)")

# Our licence and those of what becomes part of the files, where Debian looks for it. scripts/package
# makes it; who installs from a build needs it no more than before.
set(copyright ${PROJECT_BINARY_DIR}/copyright)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_custom_target(flinch_copyright COMMAND Python3::Interpreter
  ${CMAKE_CURRENT_LIST_DIR}/packages/make_copyright.py ${copyright})
foreach(component program runtime development)
  string(TOUPPER ${component} name)
  install(FILES ${copyright} OPTIONAL COMPONENT ${component}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME})
endforeach()
include(CPack)
