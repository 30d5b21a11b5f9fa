// SPDX-License-Identifier: MIT
#include "models/knn.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flinch::models {
namespace {

constexpr auto kLeaf = static_cast<std::size_t>(KnnLeaves::kLeafSize);
using Lanes = Eigen::Array<float, KnnLeaves::kLeafSize, 1>;
using ConstLanes = Eigen::Map<const Lanes>;

/// Squared distances from the query to each of a leaf's points, each summed from the first feature
/// to the last.
Lanes distances_to_points(std::span<const float> query, const float* points) {
  Lanes sum = Lanes::Zero();
  for (std::size_t feature = 0; feature < query.size(); ++feature) {
    sum += (query[feature] - ConstLanes(points + feature * kLeaf)).square();
  }
  return sum;
}

/// Squared distances from the query to kLeafSize boxes. Rounding keeps order, and the sums go as
/// those to points do: so none is above the distance to any point in its box, to the bit.
Lanes distances_to_boxes(std::span<const float> query, const float* lower, const float* upper) {
  Lanes sum = Lanes::Zero();
  for (std::size_t feature = 0; feature < query.size(); ++feature) {
    const std::size_t at = feature * kLeaf;
    sum += (ConstLanes(lower + at) - query[feature])
               .max(query[feature] - ConstLanes(upper + at))
               .max(0.0F)
               .square();
  }
  return sum;
}

struct Leaf {
  float squared_distance;
  std::uint32_t index;
};

bool is_farther(const Leaf& a, const Leaf& b) {
  return a.squared_distance > b.squared_distance;
}

/// Leaves as a heap with the nearest on top.
std::pmr::vector<Leaf> leaves_by_distance(const KnnLeaves& leaves, std::span<const float> query,
                                          Memory memory) {
  std::pmr::vector<Leaf> heap(memory);
  const std::size_t count = leaves.leaf_count();
  heap.reserve(count);
  for (std::size_t first = 0; first < count; first += kLeaf) {
    const std::size_t at = first * query.size();
    const Lanes distances = distances_to_boxes(query, &leaves.lower[at], &leaves.upper[at]);
    for (std::size_t i = 0; i < std::min(kLeaf, count - first); ++i) {
      heap.push_back(
          {distances[static_cast<Eigen::Index>(i)], static_cast<std::uint32_t>(first + i)});
    }
  }
  std::make_heap(heap.begin(), heap.end(), is_farther);
  return heap;
}

/// The nearest so far, as a heap with the farthest on top.
void enter(const Neighbour& next, std::size_t most, std::pmr::vector<Neighbour>& found) {
  if (found.size() == most) {
    if (!nearer(next, found.front())) {
      return;
    }
    std::pop_heap(found.begin(), found.end(), nearer);
    found.pop_back();
  }
  found.push_back(next);
  std::push_heap(found.begin(), found.end(), nearer);
}

}  // namespace

float squared_distance(std::span<const float> a, const float* b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const float difference = a[i] - b[i];
    sum += difference * difference;
  }
  return sum;
}

// Leaf after leaf, the nearest box first, until the next box is farther than the k-th neighbour. At
// the very same distance a leaf may still hold an observation of lower index.
std::pmr::vector<Neighbour> nearest(const KnnModel& model, std::span<const double> scaled, int k,
                                    const ClipMask& allowed_clips, Memory memory) {
  std::pmr::vector<Neighbour> found(memory);
  const auto most = std::min(static_cast<std::size_t>(std::max(k, 0)), model.label.size());
  if (most == 0) {
    return found;
  }
  found.reserve(most);
  std::pmr::vector<float> query(scaled.size(), memory);
  std::transform(scaled.begin(), scaled.end(), query.begin(), knn_coordinate);
  auto leaves = leaves_by_distance(model.leaves, query, memory);
  while (!leaves.empty() && (found.size() < most ||
                             leaves.front().squared_distance <= found.front().squared_distance)) {
    const std::size_t first = leaves.front().index * kLeaf;
    std::pop_heap(leaves.begin(), leaves.end(), is_farther);
    leaves.pop_back();
    const Lanes distances = distances_to_points(query, &model.leaves.points[first * query.size()]);
    for (std::size_t i = 0; i < kLeaf; ++i) {
      const float distance = distances[static_cast<Eigen::Index>(i)];
      const int observation = model.leaves.observation[first + i];
      if (observation < 0 || (found.size() == most && distance > found.front().squared_distance) ||
          (!allowed_clips.empty() && !allowed_clips[static_cast<std::size_t>(
                                         model.label[static_cast<std::size_t>(observation)])])) {
        continue;
      }
      enter({observation, distance}, most, found);
    }
  }
  std::sort_heap(found.begin(), found.end(), nearer);
  return found;
}

std::pmr::vector<Candidate> count_votes(std::span<const Neighbour> neighbours,
                                        std::span<const int> label, KnnVote vote, Memory memory) {
  struct Tally {
    int clip;
    double votes;
    std::size_t place;  // in the order of each clip's nearest neighbour
  };
  std::pmr::vector<Tally> tallies(memory);
  tallies.reserve(neighbours.size());
  double cast = 0;
  for (const Neighbour& neighbour : neighbours) {
    const int clip = label[static_cast<std::size_t>(neighbour.observation)];
    const double weight =
        vote == KnnVote::majority ? 1 : 1 / (std::sqrt(double{neighbour.squared_distance}) + 1e-6);
    auto tally = std::find_if(tallies.begin(), tallies.end(),
                              [clip](const Tally& other) { return other.clip == clip; });
    if (tally == tallies.end()) {
      tally = tallies.insert(tally, {clip, 0, tallies.size()});
    }
    tally->votes += weight;
    cast += weight;
  }
  // Not std::stable_sort, which allocates.
  std::sort(tallies.begin(), tallies.end(), [](const Tally& a, const Tally& b) {
    return a.votes != b.votes ? a.votes > b.votes : a.place < b.place;
  });
  std::pmr::vector<Candidate> candidates(memory);
  candidates.reserve(neighbours.size());
  for (const Tally& tally : tallies) {
    candidates.push_back({tally.clip, static_cast<float>(tally.votes / cast)});
  }
  return candidates;
}

// Sums of whole steps, which no order of neighbours changes.
std::pmr::vector<Candidate> average_costs(std::span<const Neighbour> neighbours,
                                          const KnnModel& model, const ClipMask& allowed_clips,
                                          Memory memory) {
  const auto clips = static_cast<std::size_t>(model.clip_count);
  std::pmr::vector<std::uint32_t> sums(clips, 0, memory);
  std::pmr::vector<std::uint32_t> counts(clips, 0, memory);
  for (const Neighbour& neighbour : neighbours) {
    const std::uint16_t* costs =
        &model.cost[static_cast<std::size_t>(neighbour.observation) * clips];
    for (std::size_t clip = 0; clip < clips; ++clip) {
      const std::uint32_t tried = costs[clip] != KnnModel::kUntried ? 1U : 0U;
      sums[clip] += tried * costs[clip];
      counts[clip] += tried;
    }
  }
  std::pmr::vector<Candidate> candidates(memory);
  candidates.reserve(clips);
  for (std::size_t clip = 0; clip < clips; ++clip) {
    if (counts[clip] > 0 && allowed_clips[clip]) {
      const float mean = static_cast<float>(sums[clip]) / static_cast<float>(counts[clip]);
      candidates.push_back({static_cast<int>(clip), 0, model.cost_step_ns * mean});
    }
  }
  // Not std::stable_sort, which allocates.
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.expected_cost_ns != b.expected_cost_ns ? a.expected_cost_ns < b.expected_cost_ns
                                                    : a.clip < b.clip;
  });
  return candidates;
}

}  // namespace flinch::models
