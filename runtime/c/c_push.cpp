// SPDX-License-Identifier: MIT
// Pushes, in C.
#include <algorithm>

#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"

namespace runtime = flinch::runtime;
using runtime::check;

flinch_status flinch_character_push(flinch_character* character, int32_t joint,
                                    const float velocity[3], flinch_workspace* workspace) {
  if (const flinch_status status = check(character, workspace)) return status;
  if (velocity == nullptr) return FLINCH_NULL_POINTER;
  if (character->content->library != workspace->content->library) return FLINCH_OTHER_LIBRARY;
  if (!runtime::is_index(joint, flinch::motion::kRoleCount)) return FLINCH_BAD_PUSH;
  const auto place = static_cast<flinch::motion::Role>(joint);
  const Eigen::Vector3f asked(velocity[0], velocity[1], velocity[2]);
  if (auto* reacting = character->content->reacting())
    return status_of(reacting->push(place, asked));
  return status_of(
      character->content->character().push(place, asked, workspace->content->workspace));
}

flinch_status flinch_character_push_candidates(const flinch_character* character,
                                               flinch_push_candidate* out, int32_t capacity,
                                               int32_t* count) {
  if (const flinch_status status = check(character)) return status;
  if (count == nullptr || (out == nullptr && capacity > 0)) return FLINCH_NULL_POINTER;
  if (capacity < 0) return FLINCH_BAD_INDEX;
  const auto all = character->content->character().push_candidates();
  const auto first = all.first(std::min(all.size(), static_cast<std::size_t>(capacity)));
  std::ranges::transform(first, out, [](const runtime::PushCandidate& candidate) {
    const Eigen::Vector3f& m = candidate.deformation;
    return flinch_push_candidate{
        candidate.clip, candidate.realism, candidate.turn, candidate.taper, {m.x(), m.y(), m.z()}};
  });
  *count = static_cast<std::int32_t>(first.size());
  return FLINCH_OK;
}
