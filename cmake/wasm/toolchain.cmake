# SPDX-License-Identifier: MIT
# Toolchain for WebAssembly: Debian's Clang 16 with wasi-libc and libc++. (The libc++ of Debian's
# Emscripten lacks <memory_resource>.)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(FLINCH_WASM TRUE)
set(CMAKE_C_COMPILER clang-16)
set(CMAKE_CXX_COMPILER clang++-16)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# Clang looks for libc++ beside the host's headers, where Debian does not have it.
set(libcxx /usr/lib/llvm-16)
# Debian's libc++ cannot unwind: what throws ends the instance with a trap.
set(CMAKE_CXX_FLAGS_INIT
  "--sysroot=/usr -stdlib++-isystem ${libcxx}/include/wasm32-wasi/c++/v1 -fignore-exceptions")
set(CMAKE_EXE_LINKER_FLAGS_INIT "--sysroot=/usr -mexec-model=reactor -L${libcxx}/lib/wasm32-wasi")
# Headers and flatc of the host, which CMake does not look for where Debian keeps them.
file(GLOB FlatBuffers_DIR /usr/lib/*/cmake/flatbuffers)
