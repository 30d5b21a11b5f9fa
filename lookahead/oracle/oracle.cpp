// SPDX-License-Identifier: MIT
#include "lookahead/oracle/oracle.h"

#include <algorithm>

#include "features/ball.h"
#include "lookahead/oracle/response_motion.h"
#include "models/selector.h"

namespace flinch::lookahead {

namespace {

// How long training simulates after the predicted impact (train::SimulationPlan::tail_s).
constexpr double kTail_s = 0.3;

}  // namespace

std::vector<int> clips_to_try(const database::ClipLibrary& library, motion::Target threatened) {
  std::vector<int> clips;
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    const motion::Clip& candidate = library.clip(clip);
    const bool allowed = candidate.purpose == motion::Purpose::anticipation &&
                         features::is_allowed(threatened, candidate.annotation);
    if (clip == library.idle || allowed) clips.push_back(clip);
  }
  return clips;
}

std::size_t best_of(std::span<const ClipTrial> trials) {
  const auto cheapest = std::ranges::min_element(trials, {}, &ClipTrial::cost_ns);
  const double near_ns = cheapest->cost_ns * 1.01;
  auto best = cheapest;
  for (auto trial = trials.begin(); trial != trials.end(); ++trial) {
    if (trial->cost_ns > near_ns) continue;
    if (trial->work_j < best->work_j ||
        (trial->work_j == best->work_j && trial->clip < best->clip)) {
      best = trial;
    }
  }
  return static_cast<std::size_t>(best - trials.begin());
}

Oracle::Oracle(const runtime::Library& library)
    : library_(library), simulator_(library.clip_library().character, options_) {}

std::optional<ClipTrial> Oracle::try_clip(const runtime::Character& character,
                                          const runtime::Perception& perception,
                                          const features::Threat& threat, int clip) const {
  const runtime::Response response = character.plan(perception, clip);
  if (!is_valid(response)) return std::nullopt;
  return try_response(response, perception, threat);
}

ClipTrial Oracle::try_response(const runtime::Response& response,
                               const runtime::Perception& perception,
                               const features::Threat& threat) const {
  const models::Selector& selector = library_.selector();
  const float delay_s = perception.delay_s;
  const double simulated_s =
      double{perception.scenario.time_to_impact_s} - double{delay_s} + kTail_s;
  const ResponseMotion tracked = make_response_motion(library_.prepared(), response, simulated_s);
  const features::Ball ball =
      features::ball_of(features::advanced(threat, delay_s), options_.gravity_mps2);
  const sim::SimulationResult result =
      simulator_.simulate(simulator_.rehearse(tracked.motion, 0, tracked.simulated_s), ball);
  ClipTrial trial;
  trial.clip = response.clip;
  trial.work_j = tracked.work_j;
  trial.damage_ns = damage_ns(*selector.costs, threat.kind, result.impulse);
  trial.cost_ns =
      cost_ns(*selector.costs, selector.brawn, threat.kind, trial.damage_ns, trial.work_j);
  trial.first_contact_s = result.first_contact_s + double{delay_s};
  trial.impulse = result.impulse;
  return trial;
}

std::vector<ClipTrial> Oracle::try_all(const runtime::Character& character,
                                       const runtime::Perception& perception,
                                       const features::Threat& threat) const {
  std::vector<ClipTrial> trials;
  for (const int clip : clips_to_try(library_.clip_library(), perception.scenario.target)) {
    if (auto trial = try_clip(character, perception, threat, clip)) trials.push_back(*trial);
  }
  return trials;
}

}  // namespace flinch::lookahead
