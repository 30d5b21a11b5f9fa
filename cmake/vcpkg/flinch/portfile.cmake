# SPDX-License-Identifier: MIT
# Of the checkout that this file is in: docs/packages.md.
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DFLINCH_BUILD_OFFLINE=OFF -DFLINCH_BUILD_TESTS=OFF -DFLINCH_BUILD_JS=OFF
          -DFLINCH_BUILD_PYTHON=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME flinch CONFIG_PATH lib/cmake/flinch)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
