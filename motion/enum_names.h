// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace flinch::motion {

/// Returns the enumerator's name: the one at its index in `names`.
template <class Enum, std::size_t size>
constexpr std::string_view name_of(const std::array<std::string_view, size>& names, Enum value) {
  return names[static_cast<std::size_t>(value)];
}

/// Returns the enumerator whose name is at the same index in `names`; nothing for an unknown name.
template <class Enum, std::size_t size>
std::optional<Enum> enum_named(const std::array<std::string_view, size>& names,
                               std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace flinch::motion
