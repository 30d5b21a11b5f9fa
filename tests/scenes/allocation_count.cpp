// SPDX-License-Identifier: MIT
// In a separate file: where the compiler inlines only one of the operators, it reports a mismatched
// free().
#include "tests/scenes/allocation_count.h"

#include <cstdlib>
#include <new>

namespace {
thread_local std::size_t count = 0;
thread_local std::size_t bytes = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++count;
  bytes += size;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  ++count;
  bytes += size;
  const auto boundary = static_cast<std::size_t>(alignment);
  // aligned_alloc requires a multiple of the alignment.
  if (void* memory = std::aligned_alloc(boundary, (size + boundary - 1) / boundary * boundary)) {
    return memory;
  }
  throw std::bad_alloc();
}

// std::stable_sort calls this one; the standard library's own would not match our delete.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++count;
  bytes += size;
  return std::malloc(size);
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

std::size_t flinch::tests::allocation_count() {
  return count;
}

std::size_t flinch::tests::allocated_bytes() {
  return bytes;
}
