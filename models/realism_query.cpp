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

/// The smallest squared distances so far.
class SmallestDistances {
 public:
  SmallestDistances() { squared_.fill(std::numeric_limits<float>::max()); }
  /// The largest of them; finite before there are enough, so that what fills a block is never kept.
  float largest() const { return squared_.back(); }
  void add(float squared) {
    if (!(squared < squared_.back())) return;
    std::size_t at = kRealismNeighbours - 1;
    for (; at > 0 && squared < squared_[at - 1]; --at) squared_[at] = squared_[at - 1];
    squared_[at] = squared;
  }

 private:
  std::array<float, kRealismNeighbours> squared_;
};

/// Four widths beside each other. A vector of the compiler: loops over arrays become branches.
constexpr std::size_t kTapersAtOnce = 4;
using PerTaper [[gnu::vector_size(sizeof(float) * kTapersAtOnce)]] = float;

PerTaper all_tapers(float x) {
  return PerTaper{x, x, x, x};
}

/// Estimates for four widths, x_t weighted, from examples that differ from the query in other
/// features by the squared distances s_i: the ten nearest by s_i + (x_t - taper_i)^2.
class EstimateByTaper {
 public:
  EstimateByTaper(const RealismQuery::Kept& kept, std::size_t count,
                  const PerTaper& weighted_tapers)
      : kept_(kept), count_(count), x_(weighted_tapers) {
    smallest_.fill(all_tapers(std::numeric_limits<float>::infinity()));
    for (std::size_t i = 0; i < count_; ++i) {
      PerTaper entering = squared(i);
      for (PerTaper& kept_here : smallest_) {  // sorted: the farther one goes on down the list
        const PerTaper here = kept_here;
        kept_here = entering < here ? entering : here;
        entering = entering < here ? here : entering;
      }
    }
  }
  /// See NearestExamples::estimate().
  PerTaper estimate(float max_distance) const {
    const PerTaper last = smallest_.back();
    const PerTaper one = all_tapers(1);
    const PerTaper none = all_tapers(0);
    PerTaper sum = none;
    PerTaper weights = none;
    PerTaper found = none;
    for (std::size_t i = 0; i < count_; ++i) {
      const PerTaper distance = squared(i);
      const PerTaper weight = distance < last ? weight_of(distance) : none;
      sum += weight * kept_.quality[i];
      weights += weight;
      found += distance < last ? one : none;
    }
    // Of those as far as the tenth, the first ones.
    const PerTaper last_weight = weight_of(last);
    const PerTaper wanted = all_tapers(float{kRealismNeighbours});
    for (std::size_t i = 0; i < count_; ++i) {
      const PerTaper is_tenth = squared(i) == last ? one : none;
      const PerTaper taken = found < wanted ? is_tenth : none;
      sum += taken * last_weight * kept_.quality[i];
      weights += taken * last_weight;
      found += taken;
    }
    const PerTaper mean = sum / weights;
    return square_root(smallest_.front()) <= all_tapers(max_distance) ? mean : none;
  }

 private:
  PerTaper squared(std::size_t i) const {
    const PerTaper difference = x_ - kept_.taper[i];
    return kept_.squared[i] + difference * difference;
  }
  static PerTaper square_root(PerTaper x) {
    for (std::size_t t = 0; t < kTapersAtOnce; ++t) x[t] = std::sqrt(x[t]);
    return x;
  }
  static PerTaper weight_of(const PerTaper& squared_distance) {
    const PerTaper least = all_tapers(kLeastDistance);
    const PerTaper distance = square_root(squared_distance);
    return 1 / (distance < least ? least : distance);
  }

  const RealismQuery::Kept& kept_;
  std::size_t count_;
  PerTaper x_;
  std::array<PerTaper, kRealismNeighbours> smallest_;
};

/// The largest squared difference of any of the widths, weighted, to one in `range`.
float largest_difference(std::span<const float> log_tapers, float weight,
                         const std::array<float, 2>& range) {
  float largest = 0;
  for (const float log_taper : log_tapers) {
    for (const float end : range)
      largest = std::max(largest, (weight * log_taper - end) * (weight * log_taper - end));
  }
  return largest;
}

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
      first_block.push_back(example_at.size() / kBlock);
    }
    example_at.push_back(example);
  }
  example_at.resize((example_at.size() + kBlock - 1) / kBlock * kBlock, kNone);
  size = example_at.size();
  groups = distinct.size();
  first_block.push_back(size / kBlock);

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
  const auto [least, most] =
      std::ranges::minmax(std::span(of.points).subspan(kTaper * count, count));
  taper_range = {least, most};
  for (const std::size_t example : example_at)
    padding.push_back(example == kNone ? std::numeric_limits<float>::infinity() : 0);
}

std::size_t RealismQuery::memory_size(const RealismIndex& index) {
  return 4 * index.size + index.size / kBlock + 2 * index.groups;
}

RealismQuery::RealismQuery(const RealismIndex& index, const RealismFeatures& features,
                           std::span<float> memory) noexcept
    : index_(&index),
      shared_(memory.data()),
      block_shared_(shared_ + index.size),
      group_shared_(block_shared_ + index.size / kBlock),
      group_distance_(group_shared_ + index.groups),
      kept_{group_distance_ + index.groups, group_distance_ + index.groups + index.size,
            group_distance_ + index.groups + 2 * index.size} {
  const auto x = as_array(features);
  std::copy(index.padding.begin(), index.padding.end(), shared_);
  for (std::size_t k = 0; k < kShared.size(); ++k) {
    const float weight = index.model->weight[kShared[k]];
    if (weight != 0)
      add_squares(index.shared.data() + k * index.size, weight * x[kShared[k]], index.size,
                  shared_);
  }
  for (std::size_t group = 0; group < index.groups; ++group) {
    group_shared_[group] = std::numeric_limits<float>::infinity();
    for (std::size_t block = index.first_block[group]; block < index.first_block[group + 1];
         ++block) {
      const float* const first = shared_ + block * kBlock;
      block_shared_[block] = *std::min_element(first, first + kBlock);
      group_shared_[group] = std::min(group_shared_[group], block_shared_[block]);
    }
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
  // Widths change a squared distance by at most `slack`, so whatever is nearest for one of them is
  // no farther without its width than the tenth nearest without its width, and `slack`.
  const float slack = largest_difference(log_tapers, weights[kTaper], index.taper_range);
  SmallestDistances smallest;
  std::size_t kept = 0;
  const auto compare = [&](std::size_t block, float response) {
    const std::size_t first = block * kBlock;
    std::array<float, kBlock> sums;
    for (std::size_t i = 0; i < kBlock; ++i) sums[i] = response + shared_[first + i];
    for (std::size_t k = 0; k < kOwn.size(); ++k) {
      const float weight = weights[kOwn[k]];
      if (weight == 0) continue;
      add_squares(index.own.data() + k * index.size + first, weight * x[kOwn[k]], kBlock,
                  sums.data());
    }
    for (std::size_t i = 0; i < kBlock; ++i) {
      if (!(sums[i] <= smallest.largest() + slack)) continue;
      smallest.add(sums[i]);
      kept_.squared[kept] = sums[i];
      kept_.taper[kept] = index.taper[first + i];
      kept_.quality[kept] = index.quality[first + i];
      ++kept;
    }
  };
  const auto compare_group = [&](std::size_t group) {
    const float response = group_distance_[group];
    for (std::size_t block = index.first_block[group]; block < index.first_block[group + 1];
         ++block) {
      if (response + block_shared_[block] <= smallest.largest() + slack) compare(block, response);
    }
  };
  // The most promising group comes first, so that the others have a bound to be below.
  const auto bound_of = [&](std::size_t group) {
    return group_distance_[group] + group_shared_[group];
  };
  std::size_t best = 0;
  for (std::size_t group = 1; group < index.groups; ++group) {
    if (bound_of(group) < bound_of(best)) best = group;
  }
  compare_group(best);
  for (std::size_t group = 0; group < index.groups; ++group) {
    if (group != best && bound_of(group) <= smallest.largest() + slack) compare_group(group);
  }

  // The first ones were kept by a wider bound.
  std::size_t count = 0;
  for (std::size_t i = 0; i < kept; ++i) {
    kept_.squared[count] = kept_.squared[i];
    kept_.taper[count] = kept_.taper[i];
    kept_.quality[count] = kept_.quality[i];
    if (kept_.squared[i] <= smallest.largest() + slack) ++count;
  }
  for (std::size_t first = 0; first < log_tapers.size(); first += kTapersAtOnce) {
    const std::size_t lanes = std::min(kTapersAtOnce, log_tapers.size() - first);
    PerTaper tapers{};
    for (std::size_t t = 0; t < lanes; ++t) tapers[t] = weights[kTaper] * log_tapers[first + t];
    const PerTaper means =
        EstimateByTaper(kept_, count, tapers).estimate(index.model->max_distance);
    for (std::size_t t = 0; t < lanes; ++t) estimates[first + t] = means[t];
  }
}

}  // namespace flinch::models
