// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"

namespace flinch::runtime {

/// Calls `use` with the caller's array of threats, which may be of a smaller, older struct.
template <class Use>
flinch_status with_threats(const flinch_threat* threats, std::int32_t count,
                           const flinch_character& character, const Use& use) {
  if (count < 0 || count > FLINCH_MOST_THREATS) return FLINCH_BAD_INDEX;
  if (threats == nullptr && count > 0) return FLINCH_NULL_POINTER;
  std::array<features::Threat, FLINCH_MOST_THREATS> all;
  const auto* bytes = reinterpret_cast<const std::byte*>(threats);
  for (std::int32_t i = 0; i < count; ++i) {
    const auto* threat =
        reinterpret_cast<const flinch_threat*>(bytes + static_cast<std::size_t>(i) * threats->size);
    if (const flinch_status status = check(threat)) return status;
    if (threat->size != threats->size) return FLINCH_BAD_SIZE;
    all[static_cast<std::size_t>(i)] = threat_of(*threat, character.content->library->selector());
  }
  return use(std::span<const features::Threat>(all).first(static_cast<std::size_t>(count)));
}

}  // namespace flinch::runtime
