// SPDX-License-Identifier: MIT
// The steps of perceiving, one by one, in C.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_threats.h"
#include "runtime/c/c_values.h"
#include "runtime/pose_check.h"
#include "runtime/response/prepared_library.h"

namespace runtime = flinch::runtime;
using runtime::check;
using runtime::status_of;

namespace {

using flinch::features::Scenario;

/// False for what is not a number.
bool is_amount(float value, float max) {
  return value >= 0 && value <= max;
}

/// Whether a game may hand these numbers to a character; its threat is checked beside.
bool is_usable(const flinch_perception& perception, const runtime::PreparedLibrary& library) {
  const auto is_within = [](float value, float max) { return std::abs(value) <= max; };
  return runtime::is_index(perception.target, flinch::motion::kTargetCount) &&
         perception.time_to_impact_s > 0 &&
         perception.time_to_impact_s <= flinch::features::kMaxHorizon_s &&
         is_amount(perception.delay_s, flinch::features::kMaxExtent) &&
         is_within(perception.position[0], 2 * runtime::kMaxPlace_m) &&
         is_within(perception.position[1], 2 * runtime::kMaxPlace_m) &&
         is_within(perception.facing, flinch::features::kMaxExtent) &&
         is_within(perception.stance_time_s, flinch::features::kMaxExtent) &&
         library.has_stance(perception.stance);
}

/// Reads a perception, which may come from notice or from the game. FLINCH_BAD_THREAT where a
/// number of it is out of range.
flinch_status read(const flinch_perception& from, const flinch_character& character,
                   runtime::Perception& to) {
  if (const flinch_status status = check(&from.threat)) return status;
  const runtime::Library& library = *character.content->library;
  const flinch::features::Threat threat = runtime::threat_of(from.threat, library.selector());
  if (!flinch::features::is_usable(threat) || !is_usable(from, library.prepared()))
    return FLINCH_BAD_THREAT;
  to.scenario.threat = threat;
  to.scenario.target = static_cast<flinch::motion::Target>(from.target);
  to.scenario.time_to_impact_s = from.time_to_impact_s;
  to.scenario.state = {.idle_time_s = from.stance_time_s,
                       .position = {from.position[0], from.position[1]},
                       .facing = from.facing,
                       .stance = from.stance};
  to.delay_s = from.delay_s;
  return FLINCH_OK;
}

flinch_perception to_c(const runtime::Perception& perception) {
  const Scenario& scenario = perception.scenario;
  return {.size = 0,
          .target = static_cast<std::int32_t>(scenario.target),
          .time_to_impact_s = scenario.time_to_impact_s,
          .delay_s = perception.delay_s,
          .position = {scenario.state.position.x(), scenario.state.position.y()},
          .facing = scenario.state.facing,
          .stance_time_s = scenario.state.idle_time_s,
          .stance = scenario.state.stance,
          .threat = runtime::to_c(scenario.threat)};
}

/// Whether a response with this clip can be planned.
bool can_answer(const runtime::Library& library, std::int32_t clip) {
  const flinch::database::ClipLibrary& clips = library.clip_library();
  return runtime::is_index(clip, clips.clips.size()) &&
         (clip == clips.idle || clips.clip(clip).annotation.has_value());
}

}  // namespace

flinch_status flinch_character_notice(flinch_character* character, const flinch_threat* threat,
                                      flinch_perception* out) {
  if (const flinch_status status = check(character, threat, out)) return status;
  runtime::Perception noticed;
  const runtime::Status status = character->content->character().notice(
      runtime::threat_of(*threat, character->content->library->selector()), noticed);
  if (status == runtime::Status::ok) runtime::write_struct(*out, to_c(noticed));
  return status_of(status);
}

flinch_status flinch_character_notice_all(flinch_character* character, const flinch_threat* threats,
                                          int32_t count, flinch_perception* out, int32_t capacity,
                                          int32_t* noticed) {
  if (const flinch_status status = check(character)) return status;
  if (noticed == nullptr || (out == nullptr && capacity > 0)) return FLINCH_NULL_POINTER;
  constexpr std::size_t kMost = runtime::Character::kMaxThreats;
  if (capacity < 0) return FLINCH_BAD_INDEX;
  if (capacity > 0) {
    if (const flinch_status status = check(out)) return status;
  }
  return runtime::with_threats(
      threats, count, *character, [&](std::span<const flinch::features::Threat> all) {
        std::array<runtime::Perception, kMost> most_urgent;
        const auto room = std::min(static_cast<std::size_t>(capacity), kMost);
        const runtime::Notice notice =
            character->content->character().notice(all, std::span(most_urgent).first(room));
        const flinch_status status = status_of(notice.status);
        if (status < 0) return status;
        const std::uint32_t size = capacity > 0 ? out->size : 0;
        auto* bytes = reinterpret_cast<std::byte*>(out);
        for (std::size_t i = 0; i < notice.count; ++i) {
          flinch_perception one = to_c(most_urgent[i]);
          one.size = size;
          std::memcpy(bytes + i * size, &one, size);
        }
        *noticed = static_cast<std::int32_t>(notice.count);
        return status;
      });
}

flinch_status flinch_character_rank(const flinch_character* character,
                                    const flinch_perception* perception,
                                    flinch_workspace* workspace, flinch_candidate* out,
                                    int32_t capacity, int32_t* count) {
  if (const flinch_status status = check(character, perception, workspace)) return status;
  if (count == nullptr || (out == nullptr && capacity > 0)) return FLINCH_NULL_POINTER;
  if (capacity < 0) return FLINCH_BAD_INDEX;
  if (character->content->library != workspace->content->library) return FLINCH_OTHER_LIBRARY;
  if (character->content->library->selector().clips.empty()) return FLINCH_WITHOUT_SELECTOR;
  runtime::Perception noticed;
  if (const flinch_status status = read(*perception, *character, noticed)) return status;
  std::array<flinch::models::Candidate, FLINCH_MOST_CANDIDATES> best{};
  std::size_t found = 0;
  const auto room = std::min(static_cast<std::size_t>(capacity), best.size());
  const flinch_status status = status_of(character->content->character().rank(
      noticed, workspace->content->workspace, std::span(best).first(room), found));
  if (status != FLINCH_OK) return status;
  std::transform(
      best.begin(), best.begin() + static_cast<std::ptrdiff_t>(found), out,
      [](const flinch::models::Candidate& candidate) {
        return flinch_candidate{candidate.clip, candidate.vote, candidate.expected_cost_ns};
      });
  *count = static_cast<std::int32_t>(found);
  return FLINCH_OK;
}

flinch_status flinch_character_plan(const flinch_character* character,
                                    const flinch_perception* perception, int32_t clip,
                                    flinch_plan* out) {
  if (const flinch_status status = check(character, perception, out)) return status;
  runtime::Perception noticed;
  if (const flinch_status status = read(*perception, *character, noticed)) return status;
  if (!can_answer(*character->content->library, clip)) return FLINCH_BAD_CLIP;
  const runtime::Response response = character->content->character().plan(noticed, clip);
  if (!runtime::is_valid(response)) return FLINCH_MISSES;
  runtime::write_struct(*out, flinch_plan{.size = 0,
                                          .first_motion_s = response.first_motion_s,
                                          .begin_s = response.begin_s,
                                          .peak_s = response.peak_s,
                                          .end_s = response.end_s,
                                          .duration_s = runtime::duration_s(response),
                                          .playback_rate = response.playback_rate});
  return FLINCH_OK;
}

flinch_status flinch_character_planned_pose(const flinch_character* character,
                                            const flinch_perception* perception, int32_t clip,
                                            float time_s, flinch_pose* out) {
  if (const flinch_status status = check(character, perception, out)) return status;
  if (!is_amount(time_s, flinch::features::kMaxExtent)) return FLINCH_BAD_TIME;
  runtime::Perception noticed;
  if (const flinch_status status = read(*perception, *character, noticed)) return status;
  if (!can_answer(*character->content->library, clip)) return FLINCH_BAD_CLIP;
  const runtime::Response response = character->content->character().plan(noticed, clip);
  if (!runtime::is_valid(response)) return FLINCH_MISSES;
  runtime::write_struct(*out, runtime::to_c(runtime::pose_at(response, time_s)));
  return FLINCH_OK;
}

flinch_status flinch_character_answer(flinch_character* character,
                                      const flinch_perception* perception, int32_t clip,
                                      const flinch_candidate* candidates, int32_t count) {
  if (const flinch_status status = check(character, perception)) return status;
  if (count < 0 || count > FLINCH_MOST_CANDIDATES) return FLINCH_BAD_INDEX;
  if (candidates == nullptr && count > 0) return FLINCH_NULL_POINTER;
  runtime::Perception noticed;
  if (const flinch_status status = read(*perception, *character, noticed)) return status;
  if (!can_answer(*character->content->library, clip)) return FLINCH_BAD_CLIP;
  std::array<flinch::models::Candidate, FLINCH_MOST_CANDIDATES> kept{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (!can_answer(*character->content->library, candidates[i].clip)) return FLINCH_BAD_CLIP;
    kept[i] = {candidates[i].clip, candidates[i].vote, candidates[i].expected_cost_ns};
  }
  return status_of(character->content->character().answer(
      noticed, clip, std::span(kept).first(static_cast<std::size_t>(count))));
}
