// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace flinch::train {

/// How a selector was trained: kept in its file for people, and not read at run time.
struct SelectorRecord {
  std::string provenance;  ///< database::Provenance as text
  std::uint64_t scenarios = 0;
  std::string parameters{"{}"};          ///< JSON: each with its value
  double cross_validated_regret_ns = 0;  ///< Training's
  double idle_regret_ns = 0;             ///< Training's
  std::string distribution{"{}"};        ///< JSON text of the store: what it was trained for
  std::string simulation{"{}"};          ///< JSON text of the store

  /// Protection in cross-validation: 0 stands still, 1 is the oracle. None where standing still is
  /// always best.
  std::optional<double> cross_validated_protection() const {
    if (!(idle_regret_ns > 0)) return std::nullopt;
    return 1 - cross_validated_regret_ns / idle_regret_ns;
  }
};

inline constexpr const char* kDamagedRecord =
    "the selector's record of its training is damaged; train it again";

/// Reads the record of a selector's file, which runtime::read_selector_file accepts. None where it
/// has none, as files of before records were kept. Throws Error at `path` for texts that are too
/// long or have control characters, and for scores that are not finite.
std::optional<SelectorRecord> read_selector_record(std::span<const std::byte> file,
                                                   const std::string& path);

}  // namespace flinch::train
