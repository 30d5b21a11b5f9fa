// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "runtime/response/prepared_library.h"
#include "runtime/response/response.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::train {

/// What tells one response of a library from another: scenarios with the same key and clip are
/// answered with the same motion, up to when it begins.
struct ResponseKey {
  int clip = 0;
  GridCell cell;
  auto operator<=>(const ResponseKey&) const = default;
};

/// Whether `early` (to an impact in `early_time_s`) is `late` (to one in `late_time_s`) begun
/// earlier: the same motion seen from the impact, but for rounding. Both of one clip, with the idle
/// clip at one place at the impact.
bool is_same_from_impact(const runtime::Response& early, float early_time_s,
                         const runtime::Response& late, float late_time_s);

/// Which responses are the same seen from the impact. A clip begins "just in time"; only where
/// there is too little time for that, for the weight shift before it or for a first step does the
/// time to impact show. The idle clip is the same for all times.
class SharedResponses {
 public:
  /// Plans a few responses for each clip and character state: a fraction of a second for a hundred
  /// clips. Keeps neither argument.
  SharedResponses(const runtime::PreparedLibrary& library,
                  const ScenarioDistribution& distribution);

  /// The response that answers at `cell` with `clip`, an annotated or the idle one: at the same
  /// character state, to the soonest impact for which it is the same.
  ResponseKey key_of(int clip, GridCell cell) const;

  /// How many different responses there are.
  std::size_t count() const;
  /// How many of them answer an impact in this time.
  std::size_t count_at(int time) const;

 private:
  std::size_t index(int clip, int idle_phase) const;

  int idle_phase_count_;
  /// The first time from which on all are the same; of each clip in each character state. Negative
  /// for clips that answer nothing.
  std::vector<int> first_shared_time_;
};

}  // namespace flinch::train
