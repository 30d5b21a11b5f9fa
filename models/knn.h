// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/candidate.h"
#include "models/clip_mask.h"

namespace flinch::models {

/// How neighbours count.
enum class KnnVote : std::uint8_t {
  majority,          ///< each neighbour's label has one vote
  inverse_distance,  ///< each 1 / (distance + 1e-6)
  cost,              ///< no votes: what each clip cost, averaged over the neighbours
};

/// The points in the order in which they are searched: leaves of kLeafSize near points each, what
/// is missing in the last one infinitely far. Made by build_leaves() from the rest of a model.
struct KnnLeaves {
  static constexpr int kLeafSize = 16;
  std::vector<int> observation;  ///< kLeafSize a leaf; -1 where there is none
  std::vector<float> points;  ///< a leaf after another: of each feature, the values of its points
  /// The box about each leaf's points, kLeafSize leaves at a time like the points: of each feature
  /// the lower bounds, then of each the upper ones. Behind the last leaf nothing but infinity.
  std::vector<float> lower, upper;

  std::size_t leaf_count() const { return observation.size() / kLeafSize; }
};

/// The k nearest observations vote, or tell what clips cost. Exact. Single precision throughout.
struct KnnModel {
  int k = 1;
  KnnVote vote = KnnVote::majority;
  int feature_count = 0;
  std::vector<float> points;  ///< row-major, scaled, one row of feature_count an observation
  std::vector<int> label;     ///< clip index, one an observation
  /// Where `vote` is cost, else empty: what each of clip_count clips cost, one row an observation,
  /// in units of cost_step_ns; kUntried where it was not tried.
  std::vector<std::uint16_t> cost;
  int clip_count = 0;
  float cost_step_ns = 0;
  KnnLeaves leaves;

  static constexpr std::uint16_t kUntried = 0xFFFF;
};

/// Makes the model's leaves: to be called once the rest is there, before it is asked. Every point
/// is finite.
void build_leaves(KnnModel& model);

struct Neighbour {
  int observation = 0;
  float squared_distance = 0;
};

/// The order of neighbours: by distance, then by the lower index.
inline bool is_nearer(const Neighbour& a, const Neighbour& b) {
  return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                  : a.observation < b.observation;
}

/// |a - b|^2, summed from the first feature to the last; `b` points to a.size() values.
float squared_distance(std::span<const float> a, const float* b);

/// Scaled features as distances take them; beyond a million it is all the same.
inline float knn_coordinate(double scaled) {
  constexpr float kMaxCoordinate = 1e6F;
  // Not std::clamp, which lets through what is not a number.
  return scaled > -kMaxCoordinate
             ? (scaled < kMaxCoordinate ? static_cast<float>(scaled) : kMaxCoordinate)
             : -kMaxCoordinate;
}

/// The k nearest observations whose label is allowed (all when `allowed_clips` is empty), nearest
/// first, ties by the lower index; fewer when there are not k.
std::pmr::vector<Neighbour> nearest(const KnnModel& model, std::span<const double> scaled, int k,
                                    const ClipMask& allowed_clips,
                                    MemoryResource memory = std::pmr::get_default_resource());

/// What the neighbours, nearest first, vote for: more votes first, then the clip with the nearer
/// neighbour. `label` is the clip index of each observation. Empty only without neighbours.
std::pmr::vector<Candidate> count_votes(std::span<const Neighbour> neighbours,
                                        std::span<const int> label, KnnVote vote,
                                        MemoryResource memory = std::pmr::get_default_resource());

/// The allowed clips that were tried on any of the neighbours, by what they cost there on average;
/// ties by the lower index. `model` votes by cost.
std::pmr::vector<Candidate> average_costs(std::span<const Neighbour> neighbours,
                                          const KnnModel& model, const ClipMask& allowed_clips,
                                          MemoryResource memory = std::pmr::get_default_resource());

}  // namespace flinch::models
