// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>

namespace flinch::tests {

/// Whether this build has sanitizers and was not asked for all samples.
inline bool draws_fewer_samples() {
#ifdef FLINCH_SANITIZED
  return std::getenv("FLINCH_ALL_SAMPLES") == nullptr;
#else
  return false;
#endif
}

/// Returns how many samples a test draws out of `all`. Under sanitizers a sample takes ten to
/// twenty times as long, and they look at memory, not at numbers: a tenth of the samples, at least
/// one, runs the same code. scripts/soak draws all of them there too, by FLINCH_ALL_SAMPLES.
inline int samples(int all) {
  return draws_fewer_samples() ? std::max(all / 10, 1) : all;
}

/// Returns how many samples a test draws that scripts/soak lets draw `soak` of them, by
/// FLINCH_SOAK.
inline int soak_samples(int gate, int soak) {
  return std::getenv("FLINCH_SOAK") != nullptr ? soak : samples(gate);
}

}  // namespace flinch::tests
