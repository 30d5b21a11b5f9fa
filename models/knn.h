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
  majority,          ///< each neighbour one vote
  inverse_distance,  ///< each 1 / (distance + 1e-6)
};

/// The k nearest observations vote. Exact.
struct KnnModel {
  int k = 1;
  KnnVote vote = KnnVote::majority;
  int feature_count = 0;
  std::vector<double> points;  ///< row-major, scaled, one row of feature_count an observation
  std::vector<int> label;      ///< clip index, one an observation
};

struct Neighbour {
  int observation = 0;
  double squared_distance = 0;
};

/// The order of neighbours: by distance, then by the lower index.
inline bool nearer(const Neighbour& a, const Neighbour& b) {
  return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                  : a.observation < b.observation;
}

/// |a - b|^2, summed from the first feature to the last; `b` points to a.size() values.
double squared_distance(std::span<const double> a, const double* b);

/// The k nearest observations whose label is allowed (all when `allowed_clips` is empty), nearest
/// first, ties by the lower index; fewer when there are not k.
std::pmr::vector<Neighbour> nearest(const KnnModel& model, std::span<const double> scaled, int k,
                                    const ClipMask& allowed_clips,
                                    Memory memory = std::pmr::get_default_resource());

/// What the neighbours, nearest first, vote for: more votes first, then the clip with the nearer
/// neighbour. `label` is the clip index of each observation. Empty only without neighbours.
std::pmr::vector<Candidate> count_votes(std::span<const Neighbour> neighbours,
                                        std::span<const int> label, KnnVote vote,
                                        Memory memory = std::pmr::get_default_resource());

}  // namespace flinch::models
