// SPDX-License-Identifier: MIT
// The oracle in C.
#include <algorithm>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "bindings/js/scenario.h"
#include "lookahead/oracle/oracle.h"
#include "models/baseline.h"
#include "models/selector.h"
#include "motion/rotation.h"
#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"

namespace lookahead = flinch::lookahead;
namespace runtime = flinch::runtime;
using runtime::check;

struct flinch_oracle : runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0009;
  struct Content {
    runtime::SharedLibrary library;
    lookahead::Oracle oracle;
  };
  explicit flinch_oracle(Content made)
      : HandleHeader(kMark), content(std::make_unique<Content>(std::move(made))) {}

  std::unique_ptr<Content> content;
};

namespace {

/// A threat as the character, copied, notices it.
struct Noticed {
  runtime::Character character;
  runtime::Perception perception;
  flinch::features::Threat threat;
};

flinch_status notice(const flinch_oracle* oracle, const flinch_character* character,
                     const flinch_threat* threat, std::optional<Noticed>& noticed) {
  if (const flinch_status status = check(oracle, character, threat)) return status;
  if (character->content->library != oracle->content->library) return FLINCH_OTHER_LIBRARY;
  noticed = Noticed{character->content->character(),
                    {},
                    runtime::threat_of(*threat, oracle->content->library->selector())};
  return runtime::status_of(noticed->character.notice(noticed->threat, noticed->perception));
}

flinch_trial to_c(const lookahead::ClipTrial& trial) {
  flinch_trial result{};
  result.clip = trial.clip;
  result.work_j = static_cast<float>(trial.work_j);
  result.damage_ns = static_cast<float>(trial.damage_ns);
  result.cost_ns = static_cast<float>(trial.cost_ns);
  result.contact_s = static_cast<float>(trial.first_contact_s);
  std::ranges::transform(trial.impulse, result.impulse_ns,
                         [](double part_ns) { return static_cast<float>(part_ns); });
  return result;
}

/// Writes trials, at most `capacity`, and which of them is best.
flinch_status write(const std::vector<lookahead::ClipTrial>& trials, flinch_trial* out,
                    int32_t capacity, int32_t* count, int32_t* best) {
  if (trials.empty()) return FLINCH_BAD_CLIP;
  if (capacity < 0 || trials.size() > static_cast<std::size_t>(capacity)) return FLINCH_BAD_INDEX;
  std::ranges::transform(trials, out, to_c);
  *count = static_cast<std::int32_t>(trials.size());
  *best = static_cast<std::int32_t>(lookahead::best_of(trials));
  return FLINCH_OK;
}

}  // namespace

flinch_status flinch_oracle_create(const flinch_library* library, flinch_oracle** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  if (!library->content->selector().costs) return FLINCH_WITHOUT_COSTS;
  return runtime::make_handle(out, [&] {
    return flinch_oracle::Content{library->content, lookahead::Oracle(*library->content)};
  });
}

flinch_status flinch_oracle_free(flinch_oracle* oracle) {
  return runtime::free_handle(oracle);
}

flinch_status flinch_oracle_try(const flinch_oracle* oracle, const flinch_character* character,
                                const flinch_threat* threat, int32_t clip, flinch_trial* out) try {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  std::optional<Noticed> noticed;
  if (const flinch_status status = notice(oracle, character, threat, noticed)) return status;
  const auto trial = oracle->content->oracle.try_clip(noticed->character, noticed->perception,
                                                      noticed->threat, clip);
  if (!trial) return FLINCH_BAD_CLIP;
  *out = to_c(*trial);
  return FLINCH_OK;
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_oracle_try_all(const flinch_oracle* oracle, const flinch_character* character,
                                    const flinch_threat* threat, flinch_trial* out,
                                    int32_t capacity, int32_t* count, int32_t* best) try {
  if (out == nullptr || count == nullptr || best == nullptr) return FLINCH_NULL_POINTER;
  std::optional<Noticed> noticed;
  if (const flinch_status status = notice(oracle, character, threat, noticed)) return status;
  return write(
      oracle->content->oracle.try_all(noticed->character, noticed->perception, noticed->threat),
      out, capacity, count, best);
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_oracle_try_scenario(const flinch_oracle* oracle,
                                         const flinch_scenario* scenario, flinch_trial* out,
                                         int32_t capacity, int32_t* count, int32_t* best) try {
  if (scenario == nullptr || out == nullptr || count == nullptr || best == nullptr)
    return FLINCH_NULL_POINTER;
  if (const flinch_status status = check(oracle)) return status;
  if (const flinch_status status = flinch::js::check(*scenario)) return status;
  const auto [character, perception] = flinch::js::placed(*oracle->content->library, *scenario);
  return write(oracle->content->oracle.try_all(character, perception, perception.scenario.threat),
               out, capacity, count, best);
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_oracle_costs(const flinch_oracle* oracle, flinch_costs* out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = check(oracle)) return status;
  const flinch::models::Selector& selector = oracle->content->library->selector();
  const double weight = damage_per_work(*selector.costs, 0);
  *out = {static_cast<float>(selector.brawn), static_cast<float>(weight)};
  return FLINCH_OK;
}

flinch_status flinch_oracle_nearest_annotation(const flinch_oracle* oracle,
                                               const flinch_character* character,
                                               const flinch_threat* threat, int32_t* clip) {
  if (clip == nullptr) return FLINCH_NULL_POINTER;
  std::optional<Noticed> noticed;
  if (const flinch_status status = notice(oracle, character, threat, noticed)) return status;
  const flinch::models::Selector& selector = oracle->content->library->selector();
  const flinch::features::Scenario& scenario = noticed->perception.scenario;
  const float azimuth = flinch::motion::wrapped_to_pi(
      flinch::motion::yaw_of(-scenario.threat.velocity) - scenario.state.facing);
  *clip =
      flinch::models::nearest_annotation(selector.clips, selector.idle, scenario.target, azimuth);
  return FLINCH_OK;
}
