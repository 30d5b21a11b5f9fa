// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "models/realism.h"

namespace flinch::models {

/// The examples nearest to a point, as they are found.
class NearestExamples {
 public:
  /// Keeps an example at this squared distance if it is among the nearest so far.
  void add(float squared, float quality) {
    if (!(squared < squared_.back())) return;
    std::size_t at = kRealismNeighbours - 1;
    for (; at > 0 && squared < squared_[at - 1]; --at) {
      squared_[at] = squared_[at - 1];
      quality_[at] = quality_[at - 1];
    }
    squared_[at] = squared;
    quality_[at] = quality;
  }
  /// Squared distance that an example must be below to be kept.
  float bound() const { return squared_.back(); }
  /// See estimate_realism().
  float estimate(float max_distance) const {
    constexpr float kLeastDistance = 1e-4F;  // an example at the point itself decides nearly alone
    if (!(std::sqrt(squared_.front()) <= max_distance)) return 0;
    float sum = 0;
    float weights = 0;
    for (std::size_t i = 0; i < kRealismNeighbours; ++i) {
      const float weight = 1 / std::max(std::sqrt(squared_[i]), kLeastDistance);
      sum += weight * quality_[i];
      weights += weight;
    }
    return sum / weights;
  }

 private:
  static constexpr std::array<float, kRealismNeighbours> farthest() {
    std::array<float, kRealismNeighbours> all{};
    for (float& one : all) one = std::numeric_limits<float>::infinity();
    return all;
  }
  std::array<float, kRealismNeighbours> squared_ = farthest();
  std::array<float, kRealismNeighbours> quality_{};
};

/// Estimates many pushed motions of one character and one asked push at a time. What they have in
/// common is compared once; examples are then looked at from the most similar on, in blocks, until
/// no other can be nearer. The estimates are those of estimate_realism(), but for the order in
/// which distances are summed.
class RealismQuery {
 public:
  /// Floats of memory that a query of this model needs.
  static std::size_t memory_size(const RealismModel& model);

  /// `features` have the character and the asked push; the rest is ignored. `model` and `memory`
  /// (of memory_size()) must outlive this.
  RealismQuery(const RealismModel& model, const RealismFeatures& features,
               std::span<float> memory) noexcept;

  /// Writes the estimates for the same response, deformation and turn with each of `log_tapers` (at
  /// most kMaxTapers) to `estimates`.
  void estimate(const RealismFeatures& features, std::span<const float> log_tapers,
                std::span<float> estimates) const noexcept;

  static constexpr std::size_t kMaxTapers = 8;

 private:
  const RealismModel* model_;
  std::size_t padded_;   // number of examples, in whole blocks
  const float* shared_;  // squared distance by what is common, in the order of the blocks
  const float* points_;  // the other features in that order, one feature after the other
  const float* quality_;
  const float* block_bound_;  // least of `shared_` in each block
};

}  // namespace flinch::models
