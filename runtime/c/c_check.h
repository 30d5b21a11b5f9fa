// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

#include "runtime/c/c_handle.h"
#include "runtime/c/c_struct.h"

namespace flinch::runtime {

template <class T>
flinch_status check_one(const T* argument) {
  if constexpr (std::is_base_of_v<HandleHeader, T>) {
    return check_handle(argument);
  } else {
    return check_struct(argument);
  }
}

/// Returns the first error in handles and structs, in the order of the arguments.
template <class... Arguments>
flinch_status check(const Arguments*... arguments) {
  flinch_status status = FLINCH_OK;
  static_cast<void>((((status = check_one(arguments)) == FLINCH_OK) && ...));
  return status;
}

inline bool is_index(int index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

/// Makes a handle for the result of `make`.
template <class Handle, class Make>
flinch_status make_handle(Handle** out, const Make& make) try {
  *out = new Handle(make());
  return FLINCH_OK;
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

}  // namespace flinch::runtime
