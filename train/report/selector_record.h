// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "train/fit/fixed_parameters.h"
#include "train/fit/selector_record.h"
#include "train/fit/training.h"
#include "train/store/store.h"

namespace flinch::train {

/// What a user chose for a selector, as options of `flinch train`.
struct SelectorChoice {
  Method method = kDefaultMethod;
  std::string feature_set{features::feature_sets().front().name};
  double brawn = CostModel{}.brawn;
  std::string vulnerability{vulnerability_profiles()[0].name};  ///< or a file
  std::optional<std::string> pain{};                            ///< name or file
  std::optional<std::uint64_t> seed{};                          ///< none: the store's
  FixedParameters fixed{};
  bool without_clips = false;
};

/// Returns the record of a selector that was trained on this store. Throws Error where a file that
/// the choice names cannot be read.
SelectorRecord make_selector_record(const SelectorChoice& choice, const Store& store,
                                    const Training& training);

}  // namespace flinch::train
