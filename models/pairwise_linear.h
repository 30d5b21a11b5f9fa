// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "models/candidate.h"
#include "models/clip_mask.h"

namespace flinch::models {

/// One linear machine per pair of clips, on products of features: with z = (1, x), the terms are
/// z_i z_j for i <= j. The clip that wins most of its pairs is chosen.
///
/// A machine only says which clip wins, so its weights may have any positive scale. Weights and
/// terms are integers: every sum is exact, whatever the order of additions and whatever
/// instructions the compiler selects.
struct PairwiseModel {
  int feature_count = 0;
  std::vector<int> clip;  ///< clip index of each class, ascending
  /// Index of the machine for the class pairs (0,1), (0,2), …, (1,2), …; kNone where there is no
  /// data on a pair, which the first class then wins.
  std::vector<int> machine;
  /// One row of row_size() per machine: one weight per term, in the order of the terms, then
  /// padding with arbitrary numbers. The first class wins where the sum is 0 or more.
  std::vector<std::int16_t> weights;

  static constexpr int kNone = -1;
  /// Terms are in units of 1/1024. Features are clamped to [-2, 2], so no term exceeds 4.
  static constexpr int kTermBits = 10;
  static constexpr int kMaxTerm = 4 << kTermBits;
  /// Upper bound on the sum of a machine's absolute weights, so that every sum fits into 32 bits.
  static constexpr std::int32_t kMaxWeightSum = 0x7FFF'FFFF / kMaxTerm;

  static std::size_t term_count(std::size_t feature_count) {
    return (feature_count + 1) * (feature_count + 2) / 2;
  }
  /// Number of terms, rounded up to a multiple of 16 so that rows fill whole SIMD vectors.
  static std::size_t row_size(std::size_t feature_count) {
    return (term_count(feature_count) + 15) / 16 * 16;
  }
  std::size_t row_size() const { return row_size(static_cast<std::size_t>(feature_count)); }
};

/// Computes the terms of at most kMaxFeatures scaled features, then zeros; `terms` has row_size()
/// elements. Machines were fitted in [-1, 1] and are unreliable far outside, so features are
/// clamped to [-2, 2].
void expand(std::span<const double> scaled, std::span<std::int16_t> terms);

/// Returns whether class a < b wins against b.
bool beats(const PairwiseModel& model, std::span<const std::int16_t> terms, std::size_t a,
           std::size_t b);

/// Returns the best `max_count` of the allowed clips that the model knows, sorted by descending
/// share of pairs won, ties by the lower index. Decides only as many pairs as that takes. `scaled`
/// has feature_count values.
std::pmr::vector<Candidate> rank(const PairwiseModel& model, std::span<const double> scaled,
                                 const ClipMask& allowed_clips, std::size_t max_count,
                                 MemoryResource memory = std::pmr::get_default_resource());

}  // namespace flinch::models
