// SPDX-License-Identifier: MIT
#include "models/realism.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/realism_query.h"

namespace flinch::models {

std::array<float, kRealismFeatureCount> as_array(const RealismFeatures& features) {
  std::array<float, kRealismFeatureCount> all{};
  auto at = std::copy(features.character.begin(), features.character.end(), all.begin());
  at = std::copy(features.response.begin(), features.response.end(), at);
  *at++ = features.log_taper;
  at = std::copy(features.deformation.begin(), features.deformation.end(), at);
  at = std::copy(features.asked.begin(), features.asked.end(), at);
  *at = features.turn;
  return all;
}

std::array<float, kImpulseFeatureCount> as_array(const ImpulseFeatures& features) {
  std::array<float, kImpulseFeatureCount> all{};
  auto at = std::copy(features.response.begin(), features.response.end(), all.begin());
  at = std::copy(features.place.begin(), features.place.end(), at);
  std::copy(features.velocity.begin(), features.velocity.end(), at);
  return all;
}

bool is_sound(const RealismModel& model) {
  const auto are_finite = [](const auto& numbers) {
    return std::ranges::all_of(numbers, [](float x) { return std::isfinite(x); });
  };
  const auto is_sound_f = [&](const ThetaExamples& f) {
    return f.points.size() == kImpulseFeatureCount * model.size() &&
           f.theta.size() == kThetaSize * model.size() && are_finite(f.weight) &&
           are_finite(f.points) && are_finite(f.theta);
  };
  const std::size_t count = model.size();
  return count >= kRealismNeighbours && count <= kMaxRealismExamples && !model.mean.empty() &&
         model.basis.size() == kConfigurationComponents * model.mean.size() &&
         model.points.size() == kRealismFeatureCount * count && are_finite(model.mean) &&
         are_finite(model.basis) && are_finite(model.weight) && are_finite(model.points) &&
         model.max_distance >= 0 && std::isfinite(model.max_distance) &&
         std::ranges::all_of(model.quality, [](float q) { return q >= 0 && q <= 1; }) &&
         (!model.theta || is_sound_f(*model.theta));
}

std::array<float, kConfigurationComponents> components_of(const RealismModel& model,
                                                          std::span<const float> configuration) {
  std::array<float, kConfigurationComponents> components{};
  const std::size_t size = model.mean.size();
  for (std::size_t k = 0; k < components.size(); ++k) {
    const float* row = model.basis.data() + k * size;
    float sum = 0;
    for (std::size_t i = 0; i < size; ++i) sum += row[i] * (configuration[i] - model.mean[i]);
    components[k] = sum;
  }
  return components;
}

float estimate_realism(const RealismModel& model, const RealismFeatures& features) {
  const auto x = as_array(features);
  NearestExamples nearest;
  for (std::size_t example = 0; example < model.size(); ++example) {
    float squared = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const float difference = model.weight[k] * x[k] - model.points[k * model.size() + example];
      squared += difference * difference;
    }
    nearest.add(squared, model.quality[example]);
  }
  return nearest.estimate(model.max_distance);
}

Theta estimate_theta(const ThetaExamples& examples, const ImpulseFeatures& features) {
  struct Near {
    float squared = std::numeric_limits<float>::infinity();
    std::size_t example = 0;
  };
  std::array<Near, kRealismNeighbours> nearest{};  // the nearest first
  const auto x = as_array(features);
  const std::size_t count = examples.theta.size() / kThetaSize;
  for (std::size_t example = 0; example < count; ++example) {
    Near one{0, example};
    for (std::size_t k = 0; k < x.size(); ++k) {
      const float difference =
          examples.weight[k] * x[k] - examples.points[kImpulseFeatureCount * example + k];
      one.squared += difference * difference;
    }
    if (!(one.squared < nearest.back().squared)) continue;
    const auto at = std::ranges::upper_bound(nearest, one.squared, {}, &Near::squared);
    std::move_backward(at, nearest.end() - 1, nearest.end());
    *at = one;
  }
  Theta mean{};
  float weights = 0;
  for (const Near& one : nearest) {
    const float weight = 1 / std::max(std::sqrt(one.squared), kLeastDistance);
    weights += weight;
    for (std::size_t k = 0; k < kThetaSize; ++k)
      mean[k] += weight * examples.theta[kThetaSize * one.example + k];
  }
  for (float& number : mean) number /= weights;
  return mean;
}

}  // namespace flinch::models
