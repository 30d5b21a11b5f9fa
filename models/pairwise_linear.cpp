// SPDX-License-Identifier: MIT
#include "models/pairwise_linear.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "features/feature_vector.h"
#include "models/pair_index.h"
#include "models/tournament.h"

namespace flinch::models {
namespace {

constexpr int kOne = 1 << PairwiseModel::kTermBits;

std::int32_t in_units(double scaled) {
  // Not std::clamp, which lets NaN through.
  const double bounded = scaled > -2 ? (scaled < 2 ? scaled : 2) : -2;
  return static_cast<std::int32_t>(std::lround(bounded * kOne));
}

/// Product of two fixed-point numbers, rounded to fixed point.
std::int16_t product(std::int32_t a, std::int32_t b) {
  return static_cast<std::int16_t>((a * b + kOne / 2) >> PairwiseModel::kTermBits);
}

}  // namespace

void expand(std::span<const double> scaled, std::span<std::int16_t> terms) {
  std::array<std::int32_t, features::kMaxFeatures + 1> room{kOne};
  std::transform(scaled.begin(), scaled.end(), room.begin() + 1, in_units);
  const auto z = std::span(room).first(scaled.size() + 1);
  auto end = terms.begin();
  for (std::size_t i = 0; i < z.size(); ++i) {
    end = std::transform(z.begin() + static_cast<std::ptrdiff_t>(i), z.end(), end,
                         [&](std::int32_t other) { return product(z[i], other); });
  }
  std::fill(end, terms.end(), std::int16_t{0});
}

bool beats(const PairwiseModel& model, std::span<const std::int16_t> terms, std::size_t a,
           std::size_t b) {
  const int machine = model.machine[pair_index(a, b, model.clip.size())];
  if (machine == PairwiseModel::kNone) {
    return true;
  }
  const std::int16_t* weights =
      model.weights.data() + static_cast<std::size_t>(machine) * terms.size();
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    sum += std::int32_t{weights[i]} * std::int32_t{terms[i]};
  }
  return sum >= 0;
}

std::pmr::vector<Candidate> rank(const PairwiseModel& model, std::span<const double> scaled,
                                 const ClipMask& allowed_clips, std::size_t max_count,
                                 MemoryResource memory) {
  std::pmr::vector<std::size_t> classes(memory);
  classes.reserve(model.clip.size());
  for (std::size_t c = 0; c < model.clip.size(); ++c) {
    if (allowed_clips[static_cast<std::size_t>(model.clip[c])]) {
      classes.push_back(c);
    }
  }
  std::pmr::vector<std::int16_t> terms(model.row_size(), memory);
  expand(scaled, terms);
  Tournament tournament(
      classes.size(),
      [&](std::size_t a, std::size_t b) { return beats(model, terms, classes[a], classes[b]); },
      memory);
  const std::size_t pairs = classes.size() * (classes.size() - 1) / 2;
  std::pmr::vector<Candidate> ranked(memory);
  ranked.reserve(classes.size());
  while (ranked.size() < std::min(max_count, classes.size())) {
    const auto [player, wins] = tournament.next();
    const float vote = pairs == 0 ? 1.0F : static_cast<float>(wins) / static_cast<float>(pairs);
    ranked.push_back({.clip = model.clip[classes[player]], .vote = vote});
  }
  return ranked;
}

}  // namespace flinch::models
