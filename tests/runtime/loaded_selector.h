// SPDX-License-Identifier: MIT
#pragma once

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "runtime/library.h"
#include "tests/runtime/made_up_selector.h"

namespace flinch::tests {

/// The authored clips with a model over made-up observations, loaded as a game does; not loaded
/// where that fails.
inline runtime::Library loaded_selector(int observation_count, ModelKind model,
                                        std::uint64_t seed = 1) {
  const std::string file = made_up_selector(database::authored_library(motion::default_character()),
                                            observation_count, model, seed)
                               .file();
  runtime::Library library;
  library.load(std::as_bytes(std::span(file)));
  return library;
}

}  // namespace flinch::tests
