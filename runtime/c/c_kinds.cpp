// SPDX-License-Identifier: MIT
// The kinds of threats that a library was trained for, in C.
#include <algorithm>
#include <span>

#include "models/training_range.h"
#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"

namespace models = flinch::models;
namespace runtime = flinch::runtime;
using runtime::check;

static_assert(FLINCH_MOST_OUTSIDE ==
              sizeof(models::OutsideTrainings::numbers) / sizeof(models::OutsideTraining));

flinch_status flinch_library_kind(const flinch_library* library, int32_t index, flinch_kind* out) {
  if (const flinch_status status = check(library, out)) return status;
  const std::vector<flinch::features::KnownKind>& kinds = library->content->selector().kinds;
  if (!runtime::is_index(index, kinds.size())) return FLINCH_BAD_INDEX;
  runtime::write_struct(*out, runtime::to_c(kinds[static_cast<std::size_t>(index)]));
  return FLINCH_OK;
}

flinch_status flinch_character_outside_training(const flinch_character* character,
                                                const flinch_threat* threat, flinch_outside* out,
                                                int32_t capacity, int32_t* count) {
  if (const flinch_status status = check(character, threat)) return status;
  if (count == nullptr || (out == nullptr && capacity > 0)) return FLINCH_NULL_POINTER;
  if (capacity < 0) return FLINCH_BAD_INDEX;
  const models::Selector& selector = character->content->library->selector();
  const runtime::Character& body = character->content->character();
  flinch::features::Scenario scenario;
  scenario.threat = runtime::threat_of(*threat, selector);
  if (!flinch::features::is_usable(scenario.threat)) return FLINCH_BAD_THREAT;
  scenario.target = body.target();
  scenario.time_to_impact_s = body.time_to_impact_s();
  const models::OutsideTrainings outside = outside_training(selector, scenario);
  const auto shown = std::min(outside.count, static_cast<std::size_t>(capacity));
  std::ranges::transform(
      std::span(outside.numbers).first(shown), out, [](const models::OutsideTraining& number) {
        return flinch_outside{
            number.name.data(),
            static_cast<float>(number.value),
            {static_cast<float>(number.trained.min), static_cast<float>(number.trained.max)},
            0};
      });
  *count = static_cast<std::int32_t>(shown);
  return outside.count > 0 ? FLINCH_OUTSIDE_TRAINING : FLINCH_OK;
}
