# SPDX-License-Identifier: MIT
# Toolchain for Windows of 64 bits: Debian's GCC 12 with MinGW-w64.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
# The host's flatc, and headers that are the same everywhere.
set(FlatBuffers_DIR ${CMAKE_CURRENT_LIST_DIR})
file(GLOB Eigen3_DIR /usr/share/eigen3/cmake)
# What is made needs no library of GCC's beside it.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR ${CMAKE_CURRENT_LIST_DIR}/wine)
