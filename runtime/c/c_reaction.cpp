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

namespace {

/// Makes a character that takes hits with these options.
flinch_status create(const flinch_library* library, const reaction::ReactionOptions& options,
                     flinch_character** out) {
  auto data = reaction::make_reaction_data(*library->content);
  if (!data || !data->figure) return FLINCH_OUT_OF_MEMORY;
  return runtime::make_handle(out, [&] {
    return flinch_character::Content{
        library->content, reaction::ReactingCharacter(*library->content, std::move(data), options)};
  });
}

/// False for what is not a number.
bool is_usable(const flinch_reaction_options& options) {
  return options.simulation_only_s >= 0.05F && options.simulation_only_s <= 0.5F &&
         options.stiffness > 0 && options.stiffness <= 1;
}

}  // namespace

flinch_status flinch_character_create_reacting(const flinch_library* library,
                                               flinch_character** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  return create(library, {}, out);
}

flinch_status flinch_reaction_defaults(flinch_reaction_options* out) {
  if (const flinch_status status = check(out)) return status;
  const reaction::ReactionOptions usual;
  runtime::write_struct(
      *out, flinch_reaction_options{
                .size = 0,
                .simulation_only_s = static_cast<float>(usual.schedule.simulation_only_s),
                .stiffness = static_cast<float>(usual.stiffness)});
  return FLINCH_OK;
}

flinch_status flinch_character_create_reacting_as(const flinch_library* library,
                                                  const flinch_reaction_options* options,
                                                  flinch_character** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library, options)) return status;
  if (!is_usable(*options)) return FLINCH_BAD_LIMITS;
  return create(library, {{double{options->simulation_only_s}}, double{options->stiffness}}, out);
}

flinch_status flinch_character_stop_reaction(flinch_character* character) {
  if (const flinch_status status = check(character)) return status;
  reaction::ReactingCharacter* reacting = character->content->reacting();
  if (reacting == nullptr) return FLINCH_NOT_REACTING;
  reacting->stop();
  return FLINCH_OK;
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
