// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "motion/enum_array.h"

namespace flinch::motion {

/// Returns the enumerator that has this name in a table of names; nothing for an unknown name.
template <class Enum, int count>
std::optional<Enum> enum_named(const EnumArray<Enum, std::string_view, count>& names,
                               std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace flinch::motion
