# SPDX-License-Identifier: MIT
# FLANN::FLANN, from Debian's libflann-dev. Its own CMake package leaves out lz4,
# which its headers call inline.
find_path(FLANN_INCLUDE_DIR flann/flann.hpp)
find_library(FLANN_LIBRARY flann_cpp)
find_library(FLANN_LZ4_LIBRARY lz4)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLANN
  REQUIRED_VARS FLANN_LIBRARY FLANN_LZ4_LIBRARY FLANN_INCLUDE_DIR)
if(FLANN_FOUND AND NOT TARGET FLANN::FLANN)
  add_library(FLANN::FLANN UNKNOWN IMPORTED)
  set_target_properties(FLANN::FLANN PROPERTIES IMPORTED_LOCATION ${FLANN_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${FLANN_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES ${FLANN_LZ4_LIBRARY})
endif()
mark_as_advanced(FLANN_INCLUDE_DIR FLANN_LIBRARY FLANN_LZ4_LIBRARY)
