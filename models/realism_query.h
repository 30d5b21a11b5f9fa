// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "models/realism.h"

namespace flinch::models {

/// Nearer examples count as if they were this far: one at the point itself decides nearly alone.
inline constexpr float kLeastDistance = 1e-4F;

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
  /// See estimate_realism().
  float estimate(float max_distance) const {
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

/// The examples of a model in the order in which queries read them: those with the same response
/// stand together, in blocks, so that what a block cannot be nearer than is known at once.
struct RealismIndex {
  static constexpr std::size_t kBlock = 8;
  static constexpr std::size_t kShared = kConfigurationComponents + 3;  ///< character, asked push
  static constexpr std::size_t kOwn = 4;                                ///< deformation, turn

  /// Of a sound model, which must outlive it. Allocates.
  explicit RealismIndex(const RealismModel& model);

  const RealismModel* model;
  std::size_t size;                      ///< number of examples, in whole blocks
  std::size_t groups;                    ///< number of different responses
  std::vector<std::size_t> first_block;  ///< of each group, and the number of blocks
  std::vector<float> responses;          ///< weighted, one component of all groups after the other
  /// Weighted features, one of all examples after the other.
  std::vector<float> shared;
  std::vector<float> own;
  std::vector<float> taper;
  std::vector<float> quality;
  std::array<float, 2> taper_range;  ///< least and largest of `taper`
  std::vector<float> padding;        ///< 0 for an example, infinite for what fills a block
};

/// Estimates many pushed motions of one character and one asked push at a time. What they have in
/// common is compared once; then only blocks are compared that can hold a nearer example than those
/// found. The estimates are those of estimate_realism(), but for the order in which distances are
/// summed.
class RealismQuery {
 public:
  /// Floats of memory that a query needs.
  static std::size_t memory_size(const RealismIndex& index);

  /// Of `features`, only those of the character and of the asked push are read. `memory` has at
  /// least memory_size() floats; it and `index` must outlive this.
  RealismQuery(const RealismIndex& index, const RealismFeatures& features,
               std::span<float> memory) noexcept;

  /// Writes the estimates for the same response, deformation and turn with each of `log_tapers`
  /// to `estimates`.
  void estimate(const RealismFeatures& features, std::span<const float> log_tapers,
                std::span<float> estimates) noexcept;

  /// Examples that may be among the nearest for some width.
  struct Kept {
    float* squared;  ///< distance by everything but the width
    float* taper;    ///< weighted
    float* quality;
  };

 private:
  const RealismIndex* index_;
  float* shared_;          // squared distance by what is common, of every example
  float* block_shared_;    // least of a block
  float* group_shared_;    // least of a group
  float* group_distance_;  // squared distance by the response, of every group
  Kept kept_;
};

}  // namespace flinch::models
