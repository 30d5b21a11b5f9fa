// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "runtime/c/flinch.h"

namespace flinch::runtime {

/// The least size of a C struct: that of its first version, or what cannot be left out.
template <class T>
inline constexpr std::size_t kMinSize = sizeof(T);
template <>
inline constexpr std::size_t kMinSize<flinch_threat> = offsetof(flinch_threat, radius);

template <class T>
flinch_status check_struct(const T* value) {
  static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
  if (value == nullptr) return FLINCH_NULL_POINTER;
  const bool fits = value->size >= kMinSize<T> && value->size <= sizeof(T) &&
                    value->size % alignof(std::uint32_t) == 0;
  return fits ? FLINCH_OK : FLINCH_BAD_SIZE;
}

/// What the caller's struct, which was checked, says; what it is too small for is left as in
/// `defaults`.
template <class T>
T read_struct(const T& from, const T& defaults = {}) {
  T value = defaults;
  std::memcpy(&value, &from, from.size);
  return value;
}

/// As much of `value` as the caller's struct, which was checked, has room for.
template <class T>
void write_struct(T& to, T value) {
  value.size = to.size;
  std::memcpy(&to, &value, to.size);
}

}  // namespace flinch::runtime
