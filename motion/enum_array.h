// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace flinch::motion {

/// The `count` enumerators of an enum that starts at 0 and leaves none out, in their order.
template <class Enum, int count>
constexpr std::array<Enum, count> all_enumerators() {
  std::array<Enum, count> all{};
  for (int i = 0; i < count; ++i) all[static_cast<std::size_t>(i)] = static_cast<Enum>(i);
  return all;
}

/// `count` values in an array that is indexed by such an enum. An aggregate: `{a, b}` gives the
/// values in the order of the enumerators; the values are value-initialised where none are given.
/// An enumerator outside the enum is undefined behaviour, as an index outside an array.
template <class Enum, class T, int count>
struct EnumArray {
  std::array<T, count> values{};  ///< in the order of the enumerators

  constexpr T& operator[](Enum key) { return values[static_cast<std::size_t>(key)]; }
  constexpr const T& operator[](Enum key) const { return values[static_cast<std::size_t>(key)]; }
  constexpr T* begin() { return values.data(); }
  constexpr const T* begin() const { return values.data(); }
  constexpr T* end() { return values.data() + count; }
  constexpr const T* end() const { return values.data() + count; }
  constexpr T* data() { return values.data(); }
  constexpr const T* data() const { return values.data(); }
  static constexpr std::size_t size() { return count; }

  friend bool operator==(const EnumArray&, const EnumArray&) = default;
};

/// The sum of the values, added in the order of the enumerators.
template <class Enum, class T, int count>
constexpr T sum(const EnumArray<Enum, T, count>& array) {
  T total{};
  for (const T& value : array) total += value;
  return total;
}

}  // namespace flinch::motion
