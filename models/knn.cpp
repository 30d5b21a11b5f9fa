// SPDX-License-Identifier: MIT
#include "models/knn.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace flinch::models {
namespace {

using Lanes = Eigen::Array<float, KnnLeaves::kLeafSize, 1>;

/// Computes distances to kLeafSize points or boxes, four at a time so that the sums stay in
/// registers. Each distance is summed from the first feature to the last.
template <typename Difference>
Lanes sums_of_squares(std::size_t feature_count, const Difference& difference) {
  using Four = Eigen::Array4f;
  Four a = Four::Zero();
  Four b = a;
  Four c = a;
  Four d = a;
  for (std::size_t feature = 0; feature < feature_count; ++feature) {
    const std::size_t at = feature * KnnLeaves::kLeafSize;
    a += difference(feature, at).square();
    b += difference(feature, at + 4).square();
    c += difference(feature, at + 8).square();
    d += difference(feature, at + 12).square();
  }
  Lanes sums;  // not by <<, whose blocks have no fixed size: eight lanes would read beyond a
  sums.segment<4>(0) = a;
  sums.segment<4>(4) = b;
  sums.segment<4>(8) = c;
  sums.segment<4>(12) = d;
  return sums;
}

/// Squared distances between the query and each of a leaf's points.
Lanes distances_to_points(std::span<const float> query, const float* points) {
  return sums_of_squares(query.size(), [&](std::size_t feature, std::size_t at) {
    return Eigen::Array4f(query[feature] - Eigen::Map<const Eigen::Array4f>(points + at));
  });
}

/// Squared distances between the query and kLeafSize boxes. Rounding is monotonic, and the sums are
/// computed in the same order as those to points, so no distance exceeds that to any point in the
/// box, to the bit.
Lanes distances_to_boxes(std::span<const float> query, const float* lower, const float* upper) {
  return sums_of_squares(query.size(), [&](std::size_t feature, std::size_t at) {
    return Eigen::Array4f((Eigen::Map<const Eigen::Array4f>(lower + at) - query[feature])
                              .max(query[feature] - Eigen::Map<const Eigen::Array4f>(upper + at))
                              .max(0.0F));
  });
}

/// Squared distances to each leaf's box.
std::pmr::vector<float> distances_to_leaves(const KnnLeaves& leaves, std::span<const float> query,
                                            MemoryResource memory) {
  std::pmr::vector<float> distances(memory);
  const std::size_t count = leaves.leaf_count();
  distances.reserve(count);
  for (std::size_t first = 0; first < count; first += KnnLeaves::kLeafSize) {
    const std::size_t at = first * query.size();
    const Lanes group = distances_to_boxes(query, &leaves.lower[at], &leaves.upper[at]);
    distances.insert(distances.end(), group.data(),
                     group.data() + std::min(KnnLeaves::kLeafSize, count - first));
  }
  return distances;
}

/// Keeps the nearest so far, as a heap with the farthest on top.
void push_bounded(const Neighbour& next, std::size_t max_count,
                  std::pmr::vector<Neighbour>& found) {
  if (found.size() == max_count) {
    if (!is_nearer(next, found.front())) {
      return;
    }
    std::pop_heap(found.begin(), found.end(), is_nearer);
    found.pop_back();
  }
  found.push_back(next);
  std::push_heap(found.begin(), found.end(), is_nearer);
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

// The few leaves with the nearest boxes are visited first, so that the distance of the k-th
// neighbour is small early; then, in storage order, the others whose box is no farther than that. A
// leaf at exactly that distance may still hold an observation of lower index. (A heap of leaves
// costs more than the visits that it saves.)
std::pmr::vector<Neighbour> nearest(const KnnModel& model, std::span<const double> scaled, int k,
                                    const ClipMask& allowed_clips, MemoryResource memory) {
  constexpr int kNearestLeaves = 4;
  std::pmr::vector<Neighbour> found(memory);
  const auto max_count = std::min(static_cast<std::size_t>(std::max(k, 0)), model.label.size());
  if (max_count == 0) {
    return found;
  }
  found.reserve(max_count);
  std::pmr::vector<float> query(scaled.size(), memory);
  std::transform(scaled.begin(), scaled.end(), query.begin(), knn_coordinate);
  const auto is_too_far = [&](float distance) {
    return found.size() == max_count && distance > found.front().squared_distance;
  };
  const auto visit = [&](std::size_t leaf) {
    const std::size_t first = leaf * KnnLeaves::kLeafSize;
    const Lanes distances = distances_to_points(query, &model.leaves.points[first * query.size()]);
    if (is_too_far(distances.minCoeff())) {
      return;
    }
    for (std::size_t i = 0; i < KnnLeaves::kLeafSize; ++i) {
      const float distance = distances[static_cast<Eigen::Index>(i)];
      const int observation = model.leaves.observation[first + i];
      if (observation >= 0 && !is_too_far(distance) &&
          (allowed_clips.empty() || allowed_clips[static_cast<std::size_t>(
                                        model.label[static_cast<std::size_t>(observation)])])) {
        push_bounded({observation, distance}, max_count, found);
      }
    }
  };
  constexpr float kVisited = std::numeric_limits<float>::infinity();
  auto leaves = distances_to_leaves(model.leaves, query, memory);
  for (int i = 0; i < kNearestLeaves; ++i) {
    const auto next = std::min_element(leaves.begin(), leaves.end());
    if (*next == kVisited) {
      break;
    }
    visit(static_cast<std::size_t>(next - leaves.begin()));
    *next = kVisited;
  }
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    if (leaves[leaf] != kVisited && !is_too_far(leaves[leaf])) {
      visit(leaf);
    }
  }
  std::sort_heap(found.begin(), found.end(), is_nearer);
  return found;
}

std::pmr::vector<Candidate> count_votes(std::span<const Neighbour> neighbours,
                                        std::span<const int> label, KnnVote vote,
                                        MemoryResource memory) {
  struct Tally {
    int clip;
    double votes;
    std::size_t place;  // rank of the clip by its nearest neighbour
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

// Sums of integer steps, which do not depend on the order of neighbours.
std::pmr::vector<Candidate> average_costs(std::span<const Neighbour> neighbours,
                                          const KnnModel& model, const ClipMask& allowed_clips,
                                          MemoryResource memory) {
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
