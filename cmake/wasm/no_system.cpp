// SPDX-License-Identifier: MIT
// WebAssembly without a system: nothing is imported. Debian's libc++ for it cannot unwind, so what
// would throw ends the instance with a trap, which JavaScript sees as a WebAssembly.RuntimeError.
// Only memory that runs out does so: files and input are checked, and refused by a status, before
// anything is made of them.
#include <cstddef>
#include <cstdint>

extern "C" {

void* __cxa_allocate_exception(std::size_t /*size*/) noexcept {
  __builtin_trap();
}

void __cxa_throw(void* /*exception*/, void* /*type*/, void (* /*destroy*/)(void*)) {
  __builtin_trap();
}

// Called by libc++'s messages before it aborts.
std::uint16_t __wasi_fd_close(int /*file*/) {
  __builtin_trap();
}

std::uint16_t __wasi_fd_seek(int /*file*/, std::int64_t /*offset*/, std::uint8_t /*whence*/,
                             std::uint64_t* /*position*/) {
  __builtin_trap();
}

std::uint16_t __wasi_fd_write(int /*file*/, const void* /*buffers*/, std::size_t /*count*/,
                              std::size_t* /*written*/) {
  __builtin_trap();
}
}
