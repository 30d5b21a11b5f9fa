// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/candidate.h"
#include "models/clip_mask.h"

namespace flinch::models {

/// How neighbours are weighted.
enum class KnnVote : std::uint8_t {
  majority,          ///< one vote per neighbour, for its label
  inverse_distance,  ///< a vote of 1 / (distance + 1e-6) per neighbour
  cost,              ///< no votes: each clip's cost, averaged over the neighbours
};

/// The points in search order: leaves of kLeafSize nearby points each; the last leaf is padded with
/// points at infinity. build_leaves() makes them from the rest of the model.
struct KnnLeaves {
  static constexpr std::size_t kLeafSize = 16;
  std::vector<int> observation;  ///< kLeafSize per leaf; -1 for padding
  /// leaf by leaf; in each, all points' values of the first feature, then of the second, …
  std::vector<float> points;
  /// Bounding box of each leaf's points. Boxes are grouped like points, kLeafSize at a time: the
  /// lower bounds of each feature, then the upper bounds. The last group is padded with infinity.
  std::vector<float> lower, upper;

  std::size_t leaf_count() const { return observation.size() / kLeafSize; }
};

/// Largest k. Votes of more neighbours than this would take a game too long to count, and sums of
/// their costs have room.
inline constexpr int kMaxNeighbours = 1000;

/// The k nearest observations vote, or their costs are averaged. Exact search, in single precision.
struct KnnModel {
  int k = 1;
  KnnVote vote = KnnVote::majority;
  int feature_count = 0;
  std::vector<float> points;  ///< row-major, scaled, one row of feature_count per observation
  std::vector<int> label;     ///< clip index, one per observation
  /// Where `vote` is cost, otherwise empty: one row per observation with the cost of each of
  /// clip_count clips, in units of cost_step_ns; kUntried where a clip was not tried.
  std::vector<std::uint16_t> cost;
  int clip_count = 0;
  float cost_step_ns = 0;
  KnnLeaves leaves;

  static constexpr std::uint16_t kUntried = 0xFFFF;
};

/// Builds the model's leaves. Call it once, after the other members are set and before any query.
/// All points must be finite.
void build_leaves(KnnModel& model);

struct Neighbour {
  int observation = 0;
  float squared_distance = 0;
};

/// Order of neighbours: by distance, then by the lower index.
inline bool is_nearer(const Neighbour& a, const Neighbour& b) {
  return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                  : a.observation < b.observation;
}

/// Returns |a - b|^2, summed from the first feature to the last. `b` points to a.size() values.
float squared_distance(std::span<const float> a, const float* b);

/// Converts a scaled feature for distances; values beyond a million are clamped.
inline float knn_coordinate(double scaled) {
  constexpr float kMaxCoordinate = 1e6F;
  // Not std::clamp, which lets NaN through.
  return scaled > -kMaxCoordinate
             ? (scaled < kMaxCoordinate ? static_cast<float>(scaled) : kMaxCoordinate)
             : -kMaxCoordinate;
}

/// Returns the k nearest observations whose label is allowed (all when `allowed_clips` is empty),
/// nearest first, ties by the lower index; fewer when there are fewer than k.
std::pmr::vector<Neighbour> nearest(const KnnModel& model, std::span<const double> scaled, int k,
                                    const ClipMask& allowed_clips,
                                    MemoryResource memory = std::pmr::get_default_resource());

/// Counts the votes of the neighbours, which are sorted nearest first. Candidates are sorted by
/// votes, then by the nearer neighbour. `label` is the clip index of each observation. Empty only
/// without neighbours.
std::pmr::vector<Candidate> count_votes(std::span<const Neighbour> neighbours,
                                        std::span<const int> label, KnnVote vote,
                                        MemoryResource memory = std::pmr::get_default_resource());

/// Returns the allowed clips that were tried on any of the neighbours, by their average cost there;
/// ties by the lower index. The model's `vote` is cost.
std::pmr::vector<Candidate> average_costs(std::span<const Neighbour> neighbours,
                                          const KnnModel& model, const ClipMask& allowed_clips,
                                          MemoryResource memory = std::pmr::get_default_resource());

}  // namespace flinch::models
