// SPDX-License-Identifier: MIT
#include "models/realism_query.h"

#include <algorithm>
#include <numeric>

namespace flinch::models {
namespace {

constexpr std::size_t kBlock = RealismIndex::kBlock;

// Features by their place in as_array().
constexpr std::size_t kFirstResponse = kConfigurationComponents;
constexpr std::size_t kTaper = 2 * kConfigurationComponents;
constexpr std::size_t kFirstAsked = kTaper + 4;
constexpr std::size_t kTurn = kFirstAsked + 3;
constexpr std::array<std::size_t, RealismIndex::kShared> kShared{
    0, 1, 2, 3, 4, kFirstAsked, kFirstAsked + 1, kFirstAsked + 2};
constexpr std::array<std::size_t, RealismIndex::kOwn> kOwn{kTaper + 1, kTaper + 2, kTaper + 3,
                                                           kTurn};
static_assert(kConfigurationComponents == 5 && kTurn + 1 == kRealismFeatureCount);

void add_squares(const float* points, float x, std::size_t count, float* sums) {
  for (std::size_t i = 0; i < count; ++i) sums[i] += (x - points[i]) * (x - points[i]);
}

using Response = std::array<float, kConfigurationComponents>;

Response response_of(const RealismModel& model, std::size_t example) {
  Response response;
  for (std::size_t k = 0; k < response.size(); ++k)
    response[k] = model.points[(kFirstResponse + k) * model.size() + example];
  return response;
}

/// The nearest examples for each of several widths, which differ in one feature alone.
class NearestByTaper {
 public:
  NearestByTaper(float weight, std::span<const float> log_tapers) : count_(log_tapers.size()) {
    for (std::size_t t = 0; t < count_; ++t) {
      x_[t] = weight * log_tapers[t];
      bound_[t] = std::numeric_limits<float>::infinity();
    }
  }
  /// An example that is farther than this without its width is nearest for none.
  float bound() const { return largest_; }
  void add(float squared, float taper, float quality) {
    std::array<float, RealismQuery::kMaxTapers> all;
    int nearer = 0;
    for (std::size_t t = 0; t < all.size(); ++t) {
      all[t] = squared + (x_[t] - taper) * (x_[t] - taper);
      nearer += all[t] < bound_[t] ? 1 : 0;
    }
    if (nearer == 0) return;
    for (std::size_t t = 0; t < count_; ++t) {
      nearest_[t].add(all[t], quality);
      bound_[t] = nearest_[t].bound();
    }
    largest_ = *std::ranges::max_element(std::span(bound_).first(count_));
  }
  float estimate(std::size_t t, float max_distance) const {
    return nearest_[t].estimate(max_distance);
  }

 private:
  std::size_t count_;
  std::array<float, RealismQuery::kMaxTapers> x_{};
  std::array<float, RealismQuery::kMaxTapers> bound_{};  // 0 where there is no width
  std::array<NearestExamples, RealismQuery::kMaxTapers> nearest_{};
  float largest_ = std::numeric_limits<float>::infinity();
};

}  // namespace

RealismIndex::RealismIndex(const RealismModel& of) : model(&of), size(0), groups(0) {
  const std::size_t count = of.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return response_of(of, i); });

  // Places of the examples in blocks; a group begins a new block.
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> example_at;
  std::vector<Response> distinct;
  for (const std::size_t example : order) {
    const Response response = response_of(of, example);
    if (distinct.empty() || distinct.back() != response) {
      distinct.push_back(response);
      example_at.resize((example_at.size() + kBlock - 1) / kBlock * kBlock, kNone);
    }
    if (example_at.size() % kBlock == 0)
      group_of.push_back(static_cast<std::uint32_t>(distinct.size() - 1));
    example_at.push_back(example);
  }
  example_at.resize((example_at.size() + kBlock - 1) / kBlock * kBlock, kNone);
  size = example_at.size();
  groups = distinct.size();

  for (std::size_t k = 0; k < kConfigurationComponents; ++k) {
    for (const Response& response : distinct) responses.push_back(response[k]);
  }
  const auto column = [&](auto& to, const float* from, float otherwise) {
    for (const std::size_t example : example_at)
      to.push_back(example == kNone ? otherwise : from[example]);
  };
  for (const std::size_t k : flinch::models::kShared)
    column(shared, of.points.data() + k * count, 0);
  for (const std::size_t k : flinch::models::kOwn) column(own, of.points.data() + k * count, 0);
  column(taper, of.points.data() + kTaper * count, 0);
  column(quality, of.quality.data(), 0);
  for (const std::size_t example : example_at)
    padding.push_back(example == kNone ? std::numeric_limits<float>::infinity() : 0);
}

std::size_t RealismQuery::memory_size(const RealismIndex& index) {
  return index.size + 2 * index.group_of.size() + index.groups;
}

RealismQuery::RealismQuery(const RealismIndex& index, const RealismFeatures& features,
                           std::span<float> memory) noexcept
    : index_(&index),
      shared_(memory.data()),
      block_shared_(shared_ + index.size),
      group_distance_(block_shared_ + index.group_of.size()),
      block_bound_(group_distance_ + index.groups) {
  const auto x = as_array(features);
  std::copy(index.padding.begin(), index.padding.end(), shared_);
  for (std::size_t k = 0; k < kShared.size(); ++k) {
    const float weight = index.model->weight[kShared[k]];
    if (weight != 0)
      add_squares(index.shared.data() + k * index.size, weight * x[kShared[k]], index.size,
                  shared_);
  }
  for (std::size_t block = 0; block < index.group_of.size(); ++block) {
    const float* const first = shared_ + block * kBlock;
    block_shared_[block] = *std::min_element(first, first + kBlock);
  }
}

void RealismQuery::estimate(const RealismFeatures& features, std::span<const float> log_tapers,
                            std::span<float> estimates) noexcept {
  const RealismIndex& index = *index_;
  const auto& weights = index.model->weight;
  const auto x = as_array(features);
  std::fill_n(group_distance_, index.groups, 0.0F);
  for (std::size_t k = 0; k < kConfigurationComponents; ++k) {
    add_squares(index.responses.data() + k * index.groups,
                weights[kFirstResponse + k] * x[kFirstResponse + k], index.groups, group_distance_);
  }
  const std::size_t blocks = index.group_of.size();
  for (std::size_t block = 0; block < blocks; ++block)
    block_bound_[block] = block_shared_[block] + group_distance_[index.group_of[block]];

  NearestByTaper nearest(weights[kTaper], log_tapers);
  const auto compare = [&](std::size_t block) {
    const std::size_t first = block * kBlock;
    const float response = group_distance_[index.group_of[block]];
    std::array<float, kBlock> sums;
    for (std::size_t i = 0; i < kBlock; ++i) sums[i] = response + shared_[first + i];
    for (std::size_t k = 0; k < kOwn.size(); ++k) {
      add_squares(index.own.data() + k * index.size + first, weights[kOwn[k]] * x[kOwn[k]], kBlock,
                  sums.data());
    }
    for (std::size_t i = 0; i < kBlock; ++i) {
      if (sums[i] < nearest.bound())
        nearest.add(sums[i], index.taper[first + i], index.quality[first + i]);
    }
  };
  // The most promising block comes first and then its group, so that the others have a bound to be
  // below: one block alone holds fewer examples than an estimate needs.
  const auto best = static_cast<std::size_t>(std::min_element(block_bound_, block_bound_ + blocks) -
                                             block_bound_);
  const std::uint32_t group = index.group_of[best];
  compare(best);
  const auto compare_where = [&](bool is_in_group) {
    for (std::size_t block = 0; block < blocks; ++block) {
      if (block_bound_[block] < nearest.bound() &&
          (index.group_of[block] == group) == is_in_group && block != best)
        compare(block);
    }
  };
  compare_where(true);
  compare_where(false);
  for (std::size_t t = 0; t < log_tapers.size(); ++t)
    estimates[t] = nearest.estimate(t, index.model->max_distance);
}

}  // namespace flinch::models
