// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "runtime/c/flinch.h"

namespace flinch::runtime {

/// Smallest valid size of a C struct: the size of its first version, or up to its last required
/// member.
template <class T>
inline constexpr std::size_t kMinSize = sizeof(T);
template <>
inline constexpr std::size_t kMinSize<flinch_threat> = offsetof(flinch_threat, radius);
template <>
inline constexpr std::size_t kMinSize<flinch_library_info> = offsetof(flinch_library_info,
                                                                      kind_count);
template <>
inline constexpr std::size_t kMinSize<flinch_look_ahead_options> =
    offsetof(flinch_look_ahead_options, budget_us);
template <>
inline constexpr std::size_t kMinSize<flinch_reaction> = offsetof(flinch_reaction, ball_axis);

template <class T>
flinch_status check_struct(const T* value) {
  static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
  if (value == nullptr) return FLINCH_NULL_POINTER;
  const bool fits = value->size >= kMinSize<T> && value->size <= sizeof(T) &&
                    value->size % alignof(std::uint32_t) == 0;
  return fits ? FLINCH_OK : FLINCH_BAD_SIZE;
}

/// Returns the values of the caller's struct, which was checked; members that it is too small to
/// hold are as in `defaults`.
template <class T>
T read_struct(const T& from, const T& defaults = {}) {
  T value = defaults;
  std::memcpy(&value, &from, from.size);
  return value;
}

/// Writes as much of `value` as the caller's struct, which was checked, has room for.
template <class T>
void write_struct(T& to, T value) {
  value.size = to.size;
  std::memcpy(&to, &value, to.size);
}

}  // namespace flinch::runtime
