// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "runtime/response/prepared_library.h"
#include "runtime/response/response.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::train {

/// Identifies a response of a library: scenarios with the same key are answered with the same
/// motion, except for the time at which it starts.
struct ResponseKey {
  int clip = 0;
  GridCell cell;
  auto operator<=>(const ResponseKey&) const = default;
};

/// Whether `early` (to an impact in `early_time_s`) is the same response as `late` (to one in
/// `late_time_s`) started earlier: the same motion relative to the impact, except for rounding.
/// Both must be of one clip, with the same phase of the stance at the impact.
bool is_same_from_impact(const runtime::Response& early, float early_time_s,
                         const runtime::Response& late, float late_time_s);

/// Finds the responses that are the same relative to the impact. A clip starts "just in time", so
/// the time to impact matters only if it is too short for that, for the weight shift before it or
/// for a first step. The idle clip is the same for all times.
class SharedResponses {
 public:
  /// Plans a few responses per clip and character state, which takes a fraction of a second for a
  /// hundred clips. Keeps neither argument.
  SharedResponses(const runtime::PreparedLibrary& library,
                  const ScenarioDistribution& distribution);

  /// Returns the response to `cell` with `clip`, an annotated clip or the idle clip. Its time is
  /// the shortest time to impact at which the response is the same, in the same character state.
  ResponseKey key_of(int clip, GridCell cell) const;

  /// Number of different responses.
  std::size_t count() const;
  /// Number of these that respond to an impact in this time.
  std::size_t count_at(int time) const;

 private:
  std::size_t index(int clip, int state) const;

  int state_count_;
  /// The first time from which on all responses are the same, per clip and character state.
  /// Negative for clips that give no response.
  std::vector<int> first_shared_time_;
};

}  // namespace flinch::train
