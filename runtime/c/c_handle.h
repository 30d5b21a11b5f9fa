// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "runtime/c/flinch.h"

#ifdef FLINCH_CHECK_HANDLES
#include <atomic>
#endif

namespace flinch::runtime {

/// First member of every C handle: identifies its kind, so that a wrong handle is detected. A
/// handle has a `kMark` of its kind and a smart pointer `content` to its object.
struct HandleHeader {
  explicit HandleHeader(std::uint32_t mark_of_kind) : mark(mark_of_kind) {}

  std::uint32_t mark;
#ifdef FLINCH_CHECK_HANDLES
  HandleHeader* next_freed = nullptr;
#endif
};

template <class Handle>
flinch_status check_handle(const Handle* handle) {
  if (handle == nullptr) return FLINCH_NULL_POINTER;
  return handle->mark == Handle::kMark ? FLINCH_OK : FLINCH_BAD_HANDLE;
}

#ifdef FLINCH_CHECK_HANDLES
/// Marks a handle as freed, releases its content and keeps the handle itself, so that later uses
/// are detected for as long as the program runs. The list keeps leak checkers quiet and is safe for
/// any number of threads.
template <class Handle>
void release_handle(Handle* handle) {
  static std::atomic<HandleHeader*> freed{nullptr};
  handle->content.reset();
  handle->mark = 0;
  handle->next_freed = freed.load();
  while (!freed.compare_exchange_weak(handle->next_freed, handle)) {
  }
}
#else
template <class Handle>
void release_handle(Handle* handle) {
  delete handle;
}
#endif

template <class Handle>
flinch_status free_handle(Handle* handle) {
  if (handle == nullptr) return FLINCH_OK;
  const flinch_status status = check_handle(handle);
  if (status == FLINCH_OK) release_handle(handle);
  return status;
}

}  // namespace flinch::runtime
