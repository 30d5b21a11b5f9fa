// SPDX-License-Identifier: MIT
#include "runtime/push/push_search.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "motion/rotation.h"

namespace flinch::runtime {
namespace {

constexpr std::size_t kAlignment = alignof(float);

using LogTapers = std::array<float, kTapers.size()>;

LogTapers log_tapers() {
  LogTapers logs{};
  std::ranges::transform(kTapers, logs.begin(), [](float taper) { return std::log(taper); });
  return logs;
}

float turn_towards(const Eigen::Vector3f& recorded, const Eigen::Vector3f& asked) {
  const float angle = motion::wrapped_to_pi(motion::yaw_of(asked) - motion::yaw_of(recorded));
  return std::clamp(angle, -kMaxResponseTurn, kMaxResponseTurn);
}

// Insertion into the best so far; of equally good ones the first stays first.
std::size_t insert(const PushCandidate& candidate, std::size_t count,
                   std::span<PushCandidate> best) {
  const auto end = best.begin() + static_cast<std::ptrdiff_t>(count);
  const auto at = std::upper_bound(best.begin(), end, candidate,
                                   [](const PushCandidate& better, const PushCandidate& worse) {
                                     return better.realism > worse.realism;
                                   });
  const bool is_full = count == best.size();
  if (is_full && at == end) return count;
  std::move_backward(at, is_full ? end - 1 : end, is_full ? end : end + 1);
  *at = candidate;
  return is_full ? count : count + 1;
}

}  // namespace

PushCandidate deformed_candidate(const PushResponses& responses, std::size_t response,
                                 motion::Role place, const Eigen::Vector3f& asked,
                                 const SearchOptions& options) noexcept {
  const PushResponse& recorded = responses.responses[response];
  const Eigen::Vector3f& own = recorded.velocity[push_place_index(place)];
  PushCandidate candidate;
  candidate.response = static_cast<int>(response);
  candidate.clip = recorded.clip;
  if (options.turns) candidate.turn = turn_towards(own, asked);
  if (options.deforms) {
    candidate.deformation =
        asked - motion::rotation_about(Eigen::Vector3f::UnitZ(), candidate.turn) * own;
    candidate.deformation.z() = 0;
  }
  return candidate;
}

models::ImpulseFeatures impulse_features(
    const std::array<float, models::kConfigurationComponents>& components,
    const BodyConfiguration& response, motion::Role place,
    const Eigen::Vector3f& velocity) noexcept {
  const Eigen::Vector3f joint = response.segment<3>(3 * static_cast<Eigen::Index>(place));
  return {.response = components,
          .place = {joint.x(), joint.y(), joint.z()},
          .velocity = {velocity.x(), velocity.y(), velocity.z()}};
}

PushCandidate averaged_candidate(const PushResponses& responses, const PushModel& model,
                                 std::size_t response, motion::Role place,
                                 const Eigen::Vector3f& asked) noexcept {
  const PushResponse& recorded = responses.responses[response];
  const models::Theta theta = models::estimate_theta(
      *model.realism->theta,
      impulse_features(model.components[response], recorded.configuration, place, asked));
  PushCandidate candidate;
  candidate.response = static_cast<int>(response);
  candidate.clip = recorded.clip;
  candidate.taper = std::exp(theta[0]);
  candidate.deformation = {theta[1], theta[2], theta[3]};
  return candidate;
}

models::RealismFeatures realism_features(
    const std::array<float, models::kConfigurationComponents>& character,
    const std::array<float, models::kConfigurationComponents>& response,
    const PushCandidate& candidate, const Eigen::Vector3f& asked) noexcept {
  const auto components = [](const Eigen::Vector3f& v) { return std::array{v.x(), v.y(), v.z()}; };
  return {.character = character,
          .response = response,
          .log_taper = std::log(candidate.taper),
          .deformation = components(candidate.deformation),
          .asked = components(asked),
          .turn = candidate.turn};
}

PushModel prepare_push_model(const PushResponses& responses, const models::RealismModel* realism) {
  PushModel model;
  constexpr auto kSize = static_cast<std::size_t>(BodyConfiguration::RowsAtCompileTime);
  if (realism == nullptr || realism->mean.size() != kSize) return model;
  model.realism = realism;
  for (const PushResponse& response : responses.responses) {
    model.components.push_back(
        models::components_of(*realism, std::span(response.configuration.data(), kSize)));
  }
  model.index.emplace(*realism);
  model.memory_bytes =
      sizeof(float) * models::RealismQuery::memory_size(*model.index) + kAlignment - 1;
  return model;
}

std::size_t search_push(const PushResponses& responses, const PushModel& model,
                        const BodyConfiguration& configuration, motion::Role place,
                        const Eigen::Vector3f& asked, const SearchOptions& options,
                        std::span<std::byte> memory, std::span<PushCandidate> best) noexcept {
  const auto character = models::components_of(
      *model.realism, std::span(configuration.data(), model.realism->mean.size()));
  void* begin = memory.data();
  std::size_t room = memory.size();
  const std::size_t floats = models::RealismQuery::memory_size(*model.index);
  if (std::align(kAlignment, sizeof(float) * floats, begin, room) == nullptr) return 0;
  models::RealismQuery query(*model.index, realism_features(character, {}, {}, asked),
                             std::span(static_cast<float*>(begin), floats));
  const LogTapers logs = log_tapers();
  std::size_t count = 0;
  const bool is_averaged = model.realism->theta.has_value();
  for (std::size_t i = 0; i < responses.responses.size(); ++i) {
    if (is_averaged) {
      PushCandidate candidate = averaged_candidate(responses, model, i, place, asked);
      const auto features = realism_features(character, model.components[i], candidate, asked);
      query.estimate(features, std::span(&features.log_taper, 1), std::span(&candidate.realism, 1));
      count = insert(candidate, count, best);
      continue;
    }
    PushCandidate candidate = deformed_candidate(responses, i, place, asked, options);
    candidate.taper = 1;
    LogTapers realism{};
    query.estimate(realism_features(character, model.components[i], candidate, asked), logs,
                   realism);
    const auto best_taper = std::ranges::max_element(realism);
    candidate.realism = *best_taper;
    candidate.taper = kTapers[static_cast<std::size_t>(best_taper - realism.begin())];
    count = insert(candidate, count, best);
  }
  return count;
}

}  // namespace flinch::runtime
