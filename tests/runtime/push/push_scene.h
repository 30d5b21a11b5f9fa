// SPDX-License-Identifier: MIT
#pragma once

#include "database/library/library.h"
#include "models/realism.h"
#include "runtime/push/push_responses.h"

namespace flinch::tests {

/// The synthetic library with recoveries from pushes by rule: the character stands for 0.4 s, is
/// moved for 0.6 s from the front, from behind, from the left or (mirrored) from the right, and
/// takes a step with each foot.
database::ClipLibrary library_with_pushes();

/// The same with two clips of everyday motion, "go_back" and "go_aside": the character stands,
/// takes a step with each foot and stands again.
database::ClipLibrary library_with_walks();

/// The responses of the first of these.
struct PushScene {
  database::ClipLibrary library = library_with_pushes();
  runtime::PreparedLibrary prepared = runtime::prepare(library);
  runtime::PushResponses responses = runtime::prepare_push_responses(prepared);
};

/// A realism model of made-up examples around nothing, `count` of them with random features and
/// qualities; every feature counts. The same seed gives the same.
models::RealismModel random_realism(unsigned seed, std::size_t count);

/// A model that says `quality` of everything.
models::RealismModel constant_realism(float quality);

}  // namespace flinch::tests
