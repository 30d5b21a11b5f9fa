// SPDX-License-Identifier: MIT
// The scenarios of training in C.
#include "bindings/js/scenario.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "lookahead/look_ahead.h"
#include "models/baseline.h"
#include "models/selector.h"
#include "motion/rotation.h"
#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"
#include "train/scenario/scenario_sampling.h"

namespace runtime = flinch::runtime;
namespace features = flinch::features;

namespace flinch::js {

flinch_status check(const flinch_scenario& scenario) {
  constexpr float kMaxTime_s = 100;
  if (scenario.target < 0 || scenario.target >= motion::kTargetCount) return FLINCH_BAD_INDEX;
  const auto are_finite = [](const auto& numbers) {
    return std::ranges::all_of(numbers, [](float number) { return std::isfinite(number); });
  };
  const bool is_usable = are_finite(scenario.position) && are_finite(scenario.velocity) &&
                         std::isfinite(scenario.idle_time_s) && scenario.time_to_impact_s > 0 &&
                         scenario.time_to_impact_s <= kMaxTime_s && scenario.radius > 0 &&
                         std::isfinite(scenario.radius) && scenario.mass_kg > 0 &&
                         std::isfinite(scenario.mass_kg);
  return is_usable ? FLINCH_OK : FLINCH_BAD_THREAT;
}

PlacedScenario placed(const runtime::Library& library, const flinch_scenario& from) {
  features::Scenario scenario;
  scenario.target = static_cast<motion::Target>(from.target);
  scenario.time_to_impact_s = from.time_to_impact_s;
  scenario.state.idle_time_s = from.idle_time_s;
  scenario.threat.position = Eigen::Vector3f(from.position);
  scenario.threat.velocity = Eigen::Vector3f(from.velocity);
  scenario.threat.radius = from.radius;
  scenario.threat.mass_kg = from.mass_kg;
  runtime::Character character(library);
  character.place(scenario.state.position, scenario.state.facing, scenario.state.idle_time_s);
  return {character, {scenario, 0}};
}

}  // namespace flinch::js

flinch_status flinch_scenario_draw(const flinch_library* library, uint32_t seed, uint32_t number,
                                   flinch_scenario* out) try {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = runtime::check(library)) return status;
  const flinch::database::ClipLibrary& clips = library->content->clip_library();
  const features::Scenario drawn = flinch::train::sample_scenario(
      clips, flinch::motion::make_body_model(clips.character), {}, seed, number);
  flinch_scenario result{};
  result.target = static_cast<std::int32_t>(drawn.target);
  result.time_to_impact_s = drawn.time_to_impact_s;
  result.idle_time_s = drawn.state.idle_time_s;
  std::ranges::copy(drawn.threat.position, result.position);
  std::ranges::copy(drawn.threat.velocity, result.velocity);
  result.radius = drawn.threat.radius;
  result.mass_kg = drawn.threat.mass_kg;
  *out = result;
  return FLINCH_OK;
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_scenario_choose(const flinch_library* library, const flinch_scenario* scenario,
                                     flinch_workspace* workspace, int32_t* clip) {
  if (const flinch_status status = runtime::check(library, workspace)) return status;
  if (scenario == nullptr || clip == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = flinch::js::check(*scenario)) return status;
  auto [character, perception] = flinch::js::placed(*library->content, *scenario);
  const features::Scenario& what = perception.scenario;
  const runtime::Status status = character.perceive(what.threat, what.target, what.time_to_impact_s,
                                                    workspace->content->workspace);
  if (status != runtime::Status::ok) return runtime::status_of(status);
  *clip = character.candidates().front().clip;
  return FLINCH_OK;
}

flinch_status flinch_scenario_look_ahead(const flinch_library* library,
                                         const flinch_scenario* scenario, int32_t candidates,
                                         flinch_look_ahead* look_ahead, int32_t* clip) {
  if (const flinch_status status = runtime::check(library, look_ahead)) return status;
  if (scenario == nullptr || clip == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = flinch::js::check(*scenario)) return status;
  auto [character, perception] = flinch::js::placed(*library->content, *scenario);
  const flinch::lookahead::LookAheadStatus result = flinch::lookahead::perceive(
      character, perception, {.candidates = candidates}, look_ahead->content->workspace);
  if (result.status != runtime::Status::ok) return runtime::status_of(result.status);
  *clip = result.candidates[result.chosen].candidate.clip;
  return FLINCH_OK;
}

flinch_status flinch_scenario_nearest_annotation(const flinch_library* library,
                                                 const flinch_scenario* scenario, int32_t* clip) {
  if (scenario == nullptr || clip == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = runtime::check(library)) return status;
  if (const flinch_status status = flinch::js::check(*scenario)) return status;
  const flinch::models::Selector& selector = library->content->selector();
  const float azimuth =
      flinch::motion::wrapped_to_pi(flinch::motion::yaw_of(-Eigen::Vector3f(scenario->velocity)));
  *clip = flinch::models::nearest_annotation(selector.clips, selector.idle,
                                             static_cast<flinch::motion::Target>(scenario->target),
                                             azimuth);
  return FLINCH_OK;
}

flinch_status flinch_clip_pose(const flinch_library* library, int32_t clip, float time_s,
                               flinch_pose* out) {
  if (const flinch_status status = runtime::check(library, out)) return status;
  const flinch::database::ClipLibrary& clips = library->content->clip_library();
  if (!runtime::is_index(clip, clips.clips.size())) return FLINCH_BAD_INDEX;
  if (!std::isfinite(time_s)) return FLINCH_BAD_TIME;
  runtime::write_struct(*out,
                        runtime::to_c(flinch::motion::sample(clips.clip(clip).motion, time_s)));
  return FLINCH_OK;
}
