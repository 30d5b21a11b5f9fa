// SPDX-License-Identifier: MIT
#include "models/knn.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flinch::models {

double squared_distance(std::span<const double> a, const double* b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = a[i] - b[i];
    sum += difference * difference;
  }
  return sum;
}

// The nearest so far are a heap with the farthest on top. Observations come by rising index, so one
// that is as far as the top is behind it in order and does not enter.
std::pmr::vector<Neighbour> nearest(const KnnModel& model, std::span<const double> scaled, int k,
                                    const ClipMask& allowed_clips, Memory memory) {
  std::pmr::vector<Neighbour> found(memory);
  const auto most = std::min(static_cast<std::size_t>(std::max(k, 0)), model.label.size());
  if (most == 0) {
    return found;
  }
  found.reserve(most);
  for (std::size_t i = 0; i < model.label.size(); ++i) {
    if (!allowed_clips.empty() && !allowed_clips[static_cast<std::size_t>(model.label[i])]) {
      continue;
    }
    const Neighbour next{static_cast<int>(i),
                         squared_distance(scaled, &model.points[i * scaled.size()])};
    if (found.size() == most) {
      if (next.squared_distance >= found.front().squared_distance) {
        continue;
      }
      std::pop_heap(found.begin(), found.end(), nearer);
      found.pop_back();
    }
    found.push_back(next);
    std::push_heap(found.begin(), found.end(), nearer);
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
        vote == KnnVote::majority ? 1 : 1 / (std::sqrt(neighbour.squared_distance) + 1e-6);
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

}  // namespace flinch::models
