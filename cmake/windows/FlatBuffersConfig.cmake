# SPDX-License-Identifier: MIT
# The host's FlatBuffers without the other headers of the host beside it, which are not those of
# Windows.
find_path(FLATBUFFERS_HEADERS flatbuffers/flatbuffers.h REQUIRED NO_CMAKE_FIND_ROOT_PATH)
find_program(FLATBUFFERS_COMPILER flatc REQUIRED NO_CMAKE_FIND_ROOT_PATH)
set(headers ${PROJECT_BINARY_DIR}/host_headers)
file(MAKE_DIRECTORY ${headers})
file(CREATE_LINK ${FLATBUFFERS_HEADERS}/flatbuffers ${headers}/flatbuffers SYMBOLIC)
add_library(flatbuffers::flatbuffers INTERFACE IMPORTED)
target_include_directories(flatbuffers::flatbuffers INTERFACE ${headers})
add_executable(flatbuffers::flatc IMPORTED)
set_target_properties(flatbuffers::flatc PROPERTIES IMPORTED_LOCATION ${FLATBUFFERS_COMPILER})
