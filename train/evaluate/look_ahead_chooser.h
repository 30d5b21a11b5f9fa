// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lookahead/look_ahead.h"
#include "train/evaluate/evaluation.h"

namespace flinch::train {

/// A selector that can be played: its file loaded as a game loads it, with what looking ahead
/// needs.
struct PlayableSelector {
  runtime::Library library;
  lookahead::LookAheadWorkspace workspace;
};
/// Returns nothing if the store does not hold its library.
std::unique_ptr<PlayableSelector> playable(const StoreHeader& header,
                                           const models::Selector& selector);

/// The clips that a row proposes for a scenario, best first.
using Proposer = std::function<std::vector<models::Candidate>(const Observation&)>;

/// Chooses by looking ahead among the first `candidates` of what a row proposes, as a game does
/// that knows the scenario, and keeps the time. Refers to its arguments.
class LookAheadChooser {
 public:
  LookAheadChooser(PlayableSelector& selector, int candidates, Proposer propose, const Clock& clock)
      : selector_(selector), candidates_(candidates), propose_(std::move(propose)), clock_(clock) {}

  Ranking operator()(const Observation& observation);

  const std::vector<double>& took_s() const { return took_s_; }
  double encounters_per_choice() const { return encounters_ / static_cast<double>(took_s_.size()); }

 private:
  PlayableSelector& selector_;
  int candidates_;
  Proposer propose_;
  const Clock& clock_;
  std::vector<double> took_s_;
  double encounters_ = 0;
};

}  // namespace flinch::train
