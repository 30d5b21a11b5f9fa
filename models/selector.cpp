// SPDX-License-Identifier: MIT
#include "models/selector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace flinch::models {
namespace {

std::pmr::vector<Candidate> single_candidate(const Candidate& candidate, MemoryResource memory) {
  return {std::size_t{1}, candidate, memory};
}

/// Returns the unit of a network's costs against the threat with these features, N·s.
float unit_of_costs(const Selector& selector, const features::FeatureVector& x) {
  if (!selector.costs) return 1;
  const std::vector<double>& damage_ns = selector.costs->reference_damage_ns;
  const std::size_t kind = selector.layout.kind_in(x);
  return kind < damage_ns.size() ? static_cast<float>(damage_ns[kind] / damage_ns.front()) : 1.0F;
}

}  // namespace

std::pmr::vector<Candidate> candidates(const SvmModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       MemoryResource memory, std::size_t max_count) {
  std::pmr::vector<char> allowed(model.label.size(), memory);
  int count = 0;
  for (std::size_t c = 0; c < model.label.size(); ++c) {
    allowed[c] = allowed_clips[static_cast<std::size_t>(model.label[c])];
    count += allowed[c];
  }
  if (count == 0) {
    return single_candidate({.clip = idle}, memory);
  }
  const auto machines = static_cast<float>(count * (count - 1) / 2);
  const auto ranked = rank(model, scaled, allowed, std::max(max_count, std::size_t{1}), memory);
  std::pmr::vector<Candidate> candidates(memory);
  candidates.reserve(ranked.size());
  for (const auto& [c, votes] : ranked) {
    const float vote = count == 1 ? 1.0F : static_cast<float>(votes) / machines;
    candidates.push_back({.clip = model.label[c], .vote = vote});
  }
  return candidates;
}

std::pmr::vector<Candidate> candidates(const KnnModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       MemoryResource memory) {
  // No mask here: an observation holds costs of allowed clips even where its label is not allowed.
  if (model.vote == KnnVote::cost) {
    auto averages = average_costs(nearest(model, scaled, model.k, ClipMask(memory), memory), model,
                                  allowed_clips, memory);
    return averages.empty() ? single_candidate({.clip = idle}, memory) : std::move(averages);
  }
  const auto neighbours = nearest(model, scaled, model.k, allowed_clips, memory);
  if (neighbours.empty()) {
    return single_candidate({.clip = idle}, memory);
  }
  return count_votes(neighbours, model.label, model.vote, memory);
}

std::pmr::vector<Candidate> candidates(const NetworkModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       MemoryResource memory, std::size_t max_count) {
  auto expected =
      expected_costs(model, scaled, allowed_clips, memory, std::max(max_count, std::size_t{1}));
  return expected.empty() ? single_candidate({.clip = idle}, memory) : std::move(expected);
}

std::pmr::vector<Candidate> candidates(const PairwiseModel& model, std::span<const double> scaled,
                                       const ClipMask& allowed_clips, int idle,
                                       MemoryResource memory, std::size_t max_count) {
  auto ranked = rank(model, scaled, allowed_clips, std::max(max_count, std::size_t{1}), memory);
  return ranked.empty() ? single_candidate({.clip = idle}, memory) : std::move(ranked);
}

std::pmr::vector<Candidate> candidates(const Selector& selector, const features::FeatureVector& x,
                                       motion::Target threatened, MemoryResource memory,
                                       std::size_t max_count) {
  std::array<double, features::kMaxFeatures> room{};
  const auto scaled = std::span(room).first(static_cast<std::size_t>(selector.layout.size()));
  selector.scaling.apply(x, scaled);
  const ClipMask allowed = allowed_clips(selector.clips, selector.idle, threatened, memory);
  return std::visit(
      [&](const auto& model) {
        using Model = std::remove_cvref_t<decltype(model)>;
        if constexpr (std::is_same_v<Model, NetworkModel>) {
          auto ranked = candidates(model, scaled, allowed, selector.idle, memory, max_count);
          const float unit = unit_of_costs(selector, x);
          for (Candidate& candidate : ranked) candidate.expected_cost_ns *= unit;
          return ranked;
        } else if constexpr (!std::is_same_v<Model, KnnModel>) {
          return candidates(model, scaled, allowed, selector.idle, memory, max_count);
        } else {
          auto ranked = candidates(model, scaled, allowed, selector.idle, memory);
          ranked.resize(std::clamp(max_count, std::size_t{1}, ranked.size()));
          return ranked;
        }
      },
      selector.model);
}

int select(const Selector& selector, const features::FeatureVector& x, motion::Target threatened) {
  return candidates(selector, x, threatened, std::pmr::get_default_resource(), 1).front().clip;
}

ClipMask allowed_clips(std::span<const ClipSummary> clips, int idle, motion::Target threatened,
                       MemoryResource memory) {
  ClipMask allowed(clips.size(), false, memory);
  for (std::size_t i = 0; i < clips.size(); ++i) {
    allowed[i] =
        static_cast<int>(i) == idle || features::is_allowed(threatened, clips[i].annotation);
  }
  return allowed;
}

}  // namespace flinch::models
