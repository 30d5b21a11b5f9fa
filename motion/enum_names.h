// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace flinch::motion {

/// Returns the enumerator whose name is at the same index in `names`; nothing for an unknown name.
template <class Enum, std::size_t size>
std::optional<Enum> enum_named(const std::array<std::string_view, size>& names,
                               std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace flinch::motion
