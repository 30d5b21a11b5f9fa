// SPDX-License-Identifier: MIT
#include "models/realism_query.h"

#include <algorithm>
#include <cstdint>

namespace flinch::models {
namespace {

constexpr std::size_t kBlock = 32;
constexpr std::size_t kBuckets = 64;

// Features by their place in as_array().
constexpr std::size_t kFirstOwn = kConfigurationComponents;  // of a candidate: response, theta
constexpr std::size_t kTaper = 2 * kConfigurationComponents;
constexpr std::size_t kFirstAsked = kTaper + 4;
constexpr std::size_t kTurn = kFirstAsked + 3;
constexpr std::array<std::size_t, 9> kOwn{kFirstOwn,     kFirstOwn + 1, kFirstOwn + 2,
                                          kFirstOwn + 3, kFirstOwn + 4, kTaper + 1,
                                          kTaper + 2,    kTaper + 3,    kTurn};

std::size_t blocks_of(std::size_t count) {
  return (count + kBlock - 1) / kBlock;
}

void add_squares(const float* points, float x, std::size_t count, float* sums) {
  for (std::size_t i = 0; i < count; ++i) sums[i] += (x - points[i]) * (x - points[i]);
}

}  // namespace

std::size_t RealismQuery::memory_size(const RealismModel& model) {
  const std::size_t blocks = blocks_of(model.size());
  // Unordered distances; ordered ones, own features, taper and quality; the blocks' bounds.
  return model.size() + blocks * kBlock * (kOwn.size() + 3) + blocks;
}

RealismQuery::RealismQuery(const RealismModel& model, const RealismFeatures& features,
                           std::span<float> memory) noexcept
    : model_(&model), padded_(blocks_of(model.size()) * kBlock) {
  const std::size_t count = model.size();
  const auto x = as_array(features);
  float* const unordered = memory.data();
  std::fill_n(unordered, count, 0.0F);
  const auto add = [&](std::size_t feature) {
    add_squares(model.points.data() + feature * count, model.weight[feature] * x[feature], count,
                unordered);
  };
  for (std::size_t k = 0; k < kConfigurationComponents; ++k) add(k);
  for (std::size_t k = kFirstAsked; k < kTurn; ++k) add(k);

  // Counting sort by distance into buckets of equal width.
  const auto [least, most] = std::minmax_element(unordered, unordered + count);
  const float from = *least;
  const float scale = *most > from ? (static_cast<float>(kBuckets) - 0.5F) / (*most - from) : 0;
  const auto bucket_of = [&](float squared) {
    return static_cast<std::size_t>((squared - from) * scale);
  };
  std::array<std::uint32_t, kBuckets + 1> next{};
  for (std::size_t i = 0; i < count; ++i) ++next[bucket_of(unordered[i]) + 1];
  for (std::size_t b = 0; b < kBuckets; ++b) next[b + 1] += next[b];

  float* const shared = unordered + count;
  float* const points = shared + padded_;
  float* const taper = points + kOwn.size() * padded_;
  float* const quality = taper + padded_;
  float* const bounds = quality + padded_;
  std::fill(shared + count, shared + padded_, std::numeric_limits<float>::infinity());
  for (std::size_t k = 0; k < kOwn.size() + 2; ++k)
    std::fill(points + k * padded_ + count, points + (k + 1) * padded_, 0.0F);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t to = next[bucket_of(unordered[i])]++;
    shared[to] = unordered[i];
    for (std::size_t k = 0; k < kOwn.size(); ++k)
      points[k * padded_ + to] = model.points[kOwn[k] * count + i];
    taper[to] = model.points[kTaper * count + i];
    quality[to] = model.quality[i];
  }
  for (std::size_t block = 0; block < padded_ / kBlock; ++block)
    bounds[block] = *std::min_element(shared + block * kBlock, shared + (block + 1) * kBlock);
  // A later bucket has no nearer example, so a bound holds for all blocks after it once it is the
  // least of them.
  for (std::size_t block = padded_ / kBlock - 1; block > 0; --block)
    bounds[block - 1] = std::min(bounds[block - 1], bounds[block]);
  shared_ = shared;
  points_ = points;
  quality_ = quality;
  block_bound_ = bounds;
}

void RealismQuery::estimate(const RealismFeatures& features, std::span<const float> log_tapers,
                            std::span<float> estimates) const noexcept {
  const auto x = as_array(features);
  const float* const taper = points_ + kOwn.size() * padded_;
  std::array<NearestExamples, kMaxTapers> nearest{};
  std::array<float, kBlock> sums;
  for (std::size_t block = 0; block < padded_ / kBlock; ++block) {
    const std::size_t first = block * kBlock;
    float bound = 0;
    for (std::size_t t = 0; t < log_tapers.size(); ++t) bound = std::max(bound, nearest[t].bound());
    if (!(block_bound_[block] < bound)) break;
    std::copy_n(shared_ + first, kBlock, sums.begin());
    for (std::size_t k = 0; k < kOwn.size(); ++k) {
      const float weight = model_->weight[kOwn[k]];
      if (weight != 0)
        add_squares(points_ + k * padded_ + first, weight * x[kOwn[k]], kBlock, sums.data());
    }
    for (std::size_t i = 0; i < kBlock; ++i) {
      if (!(sums[i] < bound)) continue;
      for (std::size_t t = 0; t < log_tapers.size(); ++t) {
        const float difference = model_->weight[kTaper] * log_tapers[t] - taper[first + i];
        nearest[t].add(sums[i] + difference * difference, quality_[first + i]);
      }
    }
  }
  for (std::size_t t = 0; t < log_tapers.size(); ++t)
    estimates[t] = nearest[t].estimate(model_->max_distance);
}

}  // namespace flinch::models
