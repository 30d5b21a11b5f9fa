// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "models/candidate.h"
#include "models/clip_mask.h"

namespace flinch::models {

/// A linear machine for each pair of clips, on the products of features: with z = (1, x) the terms
/// are z_i z_j of i <= j. Whichever clip wins most of its pairs is chosen.
///
/// A machine only says who wins, so its weights matter up to a factor, and they and the terms are
/// whole numbers: every sum is exact, whatever its order and whatever instructions the compiler
/// finds.
struct PairwiseModel {
  int feature_count = 0;
  std::vector<int> clip;  ///< clip index of each class, rising
  /// Which machine decides between classes (0,1), (0,2), …, (1,2), …; kNone where nothing is known
  /// of them, and the first wins.
  std::vector<int> machine;
  /// One row of row_size() a machine, in the order of the terms, with any numbers behind them. For
  /// the first class where the sum is 0 or above.
  std::vector<std::int16_t> weights;

  static constexpr int kNone = -1;
  /// Terms are in units of 1/1024, and as features count within [-2, 2], none is beyond 4.
  static constexpr int kTermBits = 10;
  static constexpr int kMaxTerm = 4 << kTermBits;
  /// The sizes of a machine's weights add up to no more, so that a sum has room in 32 bits.
  static constexpr std::int32_t kMaxWeightSum = 0x7FFF'FFFF / kMaxTerm;

  static std::size_t term_count(std::size_t feature_count) {
    return (feature_count + 1) * (feature_count + 2) / 2;
  }
  /// Whole vectors of numbers, whatever a processor's are.
  static std::size_t row_size(std::size_t feature_count) {
    return (term_count(feature_count) + 15) / 16 * 16;
  }
  std::size_t row_size() const { return row_size(static_cast<std::size_t>(feature_count)); }
};

/// The terms of scaled features, kMaxFeatures at the most, then zeros: `terms` has row_size() of
/// them. Far beyond what machines were fitted to, [-1, 1], nothing is known, so nothing goes beyond
/// [-2, 2].
void expand(std::span<const double> scaled, std::span<std::int16_t> terms);

/// Whether class a < b wins against b.
bool beats(const PairwiseModel& model, std::span<const std::int16_t> terms, std::size_t a,
           std::size_t b);

/// The best `max_count` of the allowed clips that the model knows, by falling share of the pairs
/// won, ties by the lower index; as many pairs are decided as that takes. `scaled` has
/// feature_count values.
std::pmr::vector<Candidate> rank(const PairwiseModel& model, std::span<const double> scaled,
                                 const ClipMask& allowed_clips, std::size_t max_count,
                                 MemoryResource memory = std::pmr::get_default_resource());

}  // namespace flinch::models
