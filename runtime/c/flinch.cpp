// SPDX-License-Identifier: MIT
#include "runtime/c/flinch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "database/library/library_file.h"
#include "models/selector.h"
#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_struct.h"
#include "runtime/c/c_threats.h"
#include "runtime/c/c_values.h"
#include "runtime/character.h"
#include "runtime/library.h"
#include "runtime/pose_blend.h"
#include "runtime/pose_check.h"
#include "runtime/response/prepared_library.h"
#include "runtime/workspace.h"

namespace lookahead = flinch::lookahead;
namespace motion = flinch::motion;
namespace runtime = flinch::runtime;
using runtime::check;
using runtime::free_handle;
using runtime::is_index;
using runtime::make_handle;
using runtime::read_struct;
using runtime::status_of;
using runtime::to_c;
using runtime::with_threats;
using runtime::write_struct;

namespace {

template <class Source>
flinch_status load(const Source& source, flinch_library** out) try {
  const auto library = std::make_shared<runtime::Library>();
  const flinch_status status = status_of(library->load(source()));
  return status == FLINCH_OK ? make_handle(out, [&] { return library; }) : status;
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

const motion::Clip& clip_at(const flinch_library& library, std::int32_t index) {
  return library.content->clip_library().clip(index);
}

}  // namespace

const char* flinch_version(void) {
  return FLINCH_VERSION;
}

flinch_status flinch_library_load(const char* path, flinch_library** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (path == nullptr) return FLINCH_NULL_POINTER;
  return load([path] { return std::string(path); }, out);
}

flinch_status flinch_library_load_memory(const void* bytes, size_t byte_count,
                                         flinch_library** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (bytes == nullptr) return FLINCH_NULL_POINTER;
  return load([&] { return std::span(static_cast<const std::byte*>(bytes), byte_count); }, out);
}

flinch_status flinch_library_take(const void* bytes, size_t byte_count, flinch_library** out) try {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (bytes == nullptr) return FLINCH_NULL_POINTER;
  flinch::database::ClipLibrary clips;
  const std::span file(static_cast<const std::byte*>(bytes), byte_count);
  const auto read = flinch::database::read_library(file, clips);
  if (read == flinch::database::LoadStatus::not_a_library) return FLINCH_NOT_A_LIBRARY;
  if (const flinch_status status = status_of(read)) return status;
  const auto library = std::make_shared<runtime::Library>();
  if (const flinch_status status = status_of(library->take(std::move(clips)))) return status;
  return make_handle(out, [&] { return library; });
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_library_load_beside(const void* bytes, size_t byte_count,
                                         const flinch_library* owner, flinch_library** out) try {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (bytes == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = check(owner)) return status;
  const std::span file(static_cast<const std::byte*>(bytes), byte_count);
  const auto library = std::make_shared<runtime::Library>();
  if (const flinch_status status = status_of(library->load(file, *owner->content))) return status;
  return make_handle(out, [&] { return library; });
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_library_free(flinch_library* library) {
  return free_handle(library);
}

flinch_status flinch_library_describe(const flinch_library* library, flinch_library_info* out) {
  if (const flinch_status status = check(library, out)) return status;
  const flinch::database::ClipLibrary& clips = library->content->clip_library();
  write_struct(*out, flinch_library_info{
                         .size = 0,
                         .clip_count = static_cast<std::int32_t>(clips.clips.size()),
                         .idle_clip = clips.idle,
                         .rate_hz = clips.rate_hz,
                         .mass_kg = clips.character.mass_kg,
                         .kind_count =
                             static_cast<std::int32_t>(library->content->selector().kinds.size())});
  return FLINCH_OK;
}

flinch_status flinch_library_skeleton(const flinch_library* library, flinch_skeleton* out) {
  if (const flinch_status status = check(library, out)) return status;
  write_struct(*out, to_c(library->content->clip_library().character.skeleton));
  return FLINCH_OK;
}

flinch_status flinch_library_outline(const flinch_library* library, int32_t body,
                                     flinch_outline* out) {
  if (const flinch_status status = check(library, out)) return status;
  if (!is_index(body, motion::kBodyCount)) return FLINCH_BAD_INDEX;
  const auto part = static_cast<motion::Body>(body);
  write_struct(*out, to_c(part, library->content->prepared().body_model[part]));
  return FLINCH_OK;
}

flinch_status flinch_library_clip(const flinch_library* library, int32_t index, flinch_clip* out) {
  if (const flinch_status status = check(library, out)) return status;
  if (!is_index(index, library->content->clip_library().clips.size())) return FLINCH_BAD_INDEX;
  write_struct(*out, to_c(clip_at(*library, index)));
  return FLINCH_OK;
}

flinch_status flinch_library_joint_frames(const flinch_library* library, const flinch_pose* pose,
                                          flinch_joint_frames* out) {
  if (const flinch_status status = check(library, pose, out)) return status;
  const motion::Pose given = runtime::pose_of(*pose);
  if (!runtime::is_usable(given)) return FLINCH_BAD_POSE;
  const motion::Skeleton& skeleton = library->content->clip_library().character.skeleton;
  write_struct(*out, to_c(motion::forward_kinematics(skeleton, given)));
  return FLINCH_OK;
}

flinch_status flinch_library_clip_pose(const flinch_library* library, int32_t clip, float time_s,
                                       flinch_pose* out) {
  if (const flinch_status status = check(library, out)) return status;
  if (!is_index(clip, library->content->clip_library().clips.size())) return FLINCH_BAD_INDEX;
  if (!(std::abs(time_s) <= runtime::kMaxTimeStep_s)) return FLINCH_BAD_TIME;
  write_struct(*out, to_c(motion::sample(clip_at(*library, clip).motion, time_s)));
  return FLINCH_OK;
}

flinch_status flinch_workspace_create(const flinch_library* library, flinch_workspace** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  flinch_workspace::Content content{library->content, {}};
  const std::size_t bytes = library->content->selection_bytes();
  const flinch_status status = status_of(content.workspace.reserve_memory(bytes));
  if (status != FLINCH_OK) return status;
  return make_handle(out, [&] { return std::move(content); });
}

flinch_status flinch_workspace_free(flinch_workspace* workspace) {
  return free_handle(workspace);
}

flinch_status flinch_character_create(const flinch_library* library, flinch_character** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  return make_handle(out, [&] {
    return flinch_character::Content{library->content, runtime::Character(*library->content)};
  });
}

flinch_status flinch_character_free(flinch_character* character) {
  return free_handle(character);
}

flinch_status flinch_character_place(flinch_character* character, float x, float y, float facing,
                                     float idle_time_s) {
  if (const flinch_status status = check(character)) return status;
  return status_of(character->content->moved([&](runtime::Character& body) {
    return body.place({x, y}, facing, idle_time_s);
  }));
}

flinch_status flinch_character_place_in_stance(flinch_character* character, float x, float y,
                                               float facing, float stance_time_s, int32_t stance) {
  if (const flinch_status status = check(character)) return status;
  return status_of(character->content->moved([&](runtime::Character& body) {
    return body.place({x, y}, facing, stance_time_s, stance);
  }));
}

flinch_status flinch_character_change_stance(flinch_character* character, int32_t stance) {
  if (const flinch_status status = check(character)) return status;
  return status_of(character->content->character().change_stance(stance));
}

int32_t flinch_library_stance(const flinch_library* library, int32_t stance) {
  if (check(library) != FLINCH_OK) return -1;
  const runtime::PreparedLibrary& prepared = library->content->prepared();
  return prepared.has_stance(stance) ? prepared.stances[static_cast<std::size_t>(stance)].clip : -1;
}

flinch_status flinch_character_set_pose(flinch_character* character, const flinch_pose* before,
                                        const flinch_pose* now, float dt_s) {
  if (const flinch_status status = check(character, before, now)) return status;
  return status_of(character->content->moved([&](runtime::Character& body) {
    return body.set_pose(runtime::pose_of(*before), runtime::pose_of(*now), dt_s);
  }));
}

flinch_status flinch_character_copy(flinch_character* character, const flinch_character* saved) {
  if (const flinch_status status = check(character, saved)) return status;
  auto* to = std::get_if<runtime::Character>(&character->content->body);
  const auto* from = std::get_if<runtime::Character>(&saved->content->body);
  if (to == nullptr || from == nullptr) return FLINCH_BAD_HANDLE;
  if (character->content->library != saved->content->library) return FLINCH_OTHER_LIBRARY;
  *to = *from;
  character->content->graph = saved->content->graph;
  return FLINCH_OK;
}

flinch_status flinch_character_settle(flinch_character* character) {
  if (const flinch_status status = check(character)) return status;
  return status_of(character->content->character().settle());
}

flinch_status flinch_character_limit_perception(flinch_character* character,
                                                const flinch_perception_limits* limits,
                                                uint64_t seed) {
  if (const flinch_status status = check(character, limits)) return status;
  const runtime::PerceptionLimits wanted = runtime::limits_of(*limits);
  if (!runtime::is_valid(wanted)) return FLINCH_BAD_LIMITS;
  character->content->character().limit_perception(wanted, seed);
  return FLINCH_OK;
}

flinch_status flinch_human_limits(int32_t choices, flinch_perception_limits* out) {
  if (const flinch_status status = check(out)) return status;
  write_struct(*out, to_c(runtime::human_limits(choices)));
  return FLINCH_OK;
}

flinch_status flinch_character_perceive(flinch_character* character, const flinch_threat* threat,
                                        flinch_workspace* workspace) {
  if (const flinch_status status = check(character, threat, workspace)) return status;
  if (character->content->library != workspace->content->library) return FLINCH_OTHER_LIBRARY;
  return status_of(character->content->character().perceive(
      runtime::threat_of(*threat, character->content->library->selector()),
      workspace->content->workspace));
}

flinch_status flinch_character_perceive_all(flinch_character* character,
                                            const flinch_threat* threats, int32_t count,
                                            flinch_workspace* workspace) {
  if (const flinch_status status = check(character, workspace)) return status;
  if (character->content->library != workspace->content->library) return FLINCH_OTHER_LIBRARY;
  return with_threats(
      threats, count, *character, [&](std::span<const flinch::features::Threat> all) {
        return status_of(
            character->content->character().perceive(all, workspace->content->workspace));
      });
}

flinch_status flinch_character_perceive_known(flinch_character* character,
                                              const flinch_threat* threat, int32_t target,
                                              float time_to_impact_s, flinch_workspace* workspace) {
  if (const flinch_status status = check(character, threat, workspace)) return status;
  if (character->content->library != workspace->content->library) return FLINCH_OTHER_LIBRARY;
  if (!is_index(target, motion::kTargetCount)) return FLINCH_BAD_INDEX;
  return status_of(character->content->character().perceive(
      runtime::threat_of(*threat, character->content->library->selector()),
      static_cast<motion::Target>(target), time_to_impact_s, workspace->content->workspace));
}

flinch_status flinch_character_brace(flinch_character* character, const flinch_threat* threat,
                                     int32_t startles) {
  if (const flinch_status status = check(character, threat)) return status;
  return status_of(character->content->character().brace(
      runtime::threat_of(*threat, character->content->library->selector()), startles != 0));
}

flinch_status flinch_character_respond(flinch_character* character, int32_t clip,
                                       float time_to_impact_s) {
  if (const flinch_status status = check(character)) return status;
  return status_of(character->content->character().respond(clip, time_to_impact_s));
}

flinch_status flinch_character_update(flinch_character* character, float dt_s) {
  if (const flinch_status status = check(character)) return status;
  return character->content->update(dt_s);
}

flinch_status flinch_character_pose(const flinch_character* character, flinch_pose* out) {
  if (const flinch_status status = check(character, out)) return status;
  write_struct(*out, to_c(character->content->pose()));
  return FLINCH_OK;
}

flinch_status flinch_character_pose_over(const flinch_character* character, const flinch_pose* game,
                                         const flinch_mask* mask, flinch_pose* out) {
  if (const flinch_status status = check(character, game, mask, out)) return status;
  const motion::Pose under = runtime::pose_of(*game);
  const runtime::Mask weights = runtime::mask_of(*mask);
  if (!runtime::is_usable(under)) return FLINCH_BAD_POSE;
  if (!runtime::is_valid(weights)) return FLINCH_BAD_MASK;
  write_struct(*out, to_c(runtime::blended(under, character->content->pose(), weights)));
  return FLINCH_OK;
}

flinch_status flinch_character_describe(const flinch_character* character,
                                        flinch_character_state* out) {
  if (const flinch_status status = check(character, out)) return status;
  const runtime::Character& what = character->content->character();
  const flinch::features::CharacterState& state = what.state();
  write_struct(*out, flinch_character_state{.size = 0,
                                            .phase = static_cast<std::int32_t>(what.phase()),
                                            .clip = what.clip(),
                                            .target = static_cast<std::int32_t>(what.target()),
                                            .time_to_impact_s = what.time_to_impact_s(),
                                            .position = {state.position.x(), state.position.y()},
                                            .facing = state.facing});
  return FLINCH_OK;
}

flinch_status flinch_character_candidates(const flinch_character* character, flinch_candidate* out,
                                          int32_t capacity, int32_t* count) {
  if (const flinch_status status = check(character)) return status;
  if (count == nullptr || (out == nullptr && capacity > 0)) return FLINCH_NULL_POINTER;
  if (capacity < 0) return FLINCH_BAD_INDEX;
  const auto all = character->content->character().candidates();
  const auto first = all.first(std::min(all.size(), static_cast<std::size_t>(capacity)));
  std::ranges::transform(first, out, [](const flinch::models::Candidate& candidate) {
    return flinch_candidate{candidate.clip, candidate.vote, candidate.expected_cost_ns};
  });
  *count = static_cast<std::int32_t>(first.size());
  return FLINCH_OK;
}

flinch_status flinch_look_ahead_create(const flinch_library* library, flinch_look_ahead** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  if (!library->content->selector().costs) return FLINCH_WITHOUT_COSTS;
  flinch_look_ahead::Content content{library->content, {}};
  if (!content.workspace.reserve_memory(*library->content,
                                        lookahead::make_look_ahead_data(*library->content)))
    return FLINCH_OUT_OF_MEMORY;
  return make_handle(out, [&] { return std::move(content); });
}

flinch_status flinch_look_ahead_free(flinch_look_ahead* look_ahead) {
  return free_handle(look_ahead);
}

flinch_status flinch_character_look_ahead(flinch_character* character, const flinch_threat* threats,
                                          int32_t count, const flinch_look_ahead_options* options,
                                          flinch_look_ahead* look_ahead,
                                          flinch_look_ahead_status* out) {
  if (const flinch_status status = check(character, options, look_ahead)) return status;
  if (out != nullptr) {
    if (const flinch_status status = check(out)) return status;
  }
  // A size that ends within a pointer would leave half of it.
  if (options->size > offsetof(flinch_look_ahead_options, now_us) &&
      options->size < sizeof *options)
    return FLINCH_BAD_SIZE;
  if (character->content->library != look_ahead->content->library) return FLINCH_OTHER_LIBRARY;
  return with_threats(
      threats, count, *character, [&](std::span<const flinch::features::Threat> all) {
        const lookahead::LookAheadStatus status =
            lookahead::perceive(character->content->character(), all,
                                runtime::look_ahead_of(*options), look_ahead->content->workspace);
        if (out != nullptr && status.status == runtime::Status::ok)
          write_struct(*out, to_c(status));
        return status_of(status.status);
      });
}
