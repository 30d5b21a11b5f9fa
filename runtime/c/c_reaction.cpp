// SPDX-License-Identifier: MIT
// Characters that balls can hit, in C.
#include <utility>

#include "features/ball.h"
#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"

namespace reaction = flinch::reaction;
namespace runtime = flinch::runtime;
using runtime::check;

flinch_status flinch_character_create_reacting(const flinch_library* library,
                                               flinch_character** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  auto data = reaction::make_reaction_data(*library->content);
  if (!data || !data->figure) return FLINCH_OUT_OF_MEMORY;
  return runtime::make_handle(out, [&] {
    return flinch_character::Content{
        library->content, reaction::ReactingCharacter(*library->content, std::move(data))};
  });
}

flinch_status flinch_character_react_to(flinch_character* character, const flinch_threat* ball) {
  if (const flinch_status status = check(character, ball)) return status;
  reaction::ReactingCharacter* reacting = character->content->reacting();
  if (reacting == nullptr) return FLINCH_NOT_REACTING;
  const flinch::features::Threat threat =
      runtime::threat_of(*ball, character->content->library->selector());
  if (!flinch::features::is_usable(threat)) return FLINCH_BAD_THREAT;
  return runtime::status_of(reacting->react_to(flinch::features::ball_of(threat)));
}

flinch_status flinch_character_reaction(const flinch_character* character, flinch_reaction* out) {
  if (const flinch_status status = check(character, out)) return status;
  const reaction::ReactingCharacter* reacting = character->content->reacting();
  if (reacting == nullptr) return FLINCH_NOT_REACTING;
  runtime::write_struct(*out, runtime::to_c(*reacting));
  return FLINCH_OK;
}
