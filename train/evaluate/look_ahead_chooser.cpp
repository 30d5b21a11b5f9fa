// SPDX-License-Identifier: MIT
#include "train/evaluate/look_ahead_chooser.h"

#include <algorithm>

#include "motion/error.h"
#include "train/fit/selector_writer.h"

namespace flinch::train {

std::unique_ptr<PlayableSelector> playable(const StoreHeader& header,
                                           const models::Selector& selector) {
  if (header.library_file.empty()) return nullptr;
  auto made = std::make_unique<PlayableSelector>();
  const std::string file = selector_bytes(selector, std::as_bytes(std::span(header.library_file)));
  if (made->library.load(std::as_bytes(std::span(file))) != database::LoadStatus::ok ||
      !made->workspace.reserve_memory(made->library,
                                      lookahead::make_look_ahead_data(made->library)))
    throw Error("", "a selector of this store cannot be loaded; simulate it again");
  return made;
}

Ranking LookAheadChooser::operator()(const Observation& observation) {
  const features::CharacterState& state = observation.scenario.state;
  runtime::Character character(selector_.library);
  character.place(state.position, state.facing, state.idle_time_s, state.stance);
  lookahead::Search search(selector_.library);
  const double before_s = clock_();
  const std::vector<models::Candidate> proposed = propose_(observation);
  const runtime::Perception perception{observation.scenario, 0};
  const auto first =
      std::span(proposed).first(std::min(proposed.size(), static_cast<std::size_t>(candidates_)));
  const runtime::Status begun =
      search.begin(character, std::span(&perception, 1), first, selector_.workspace);
  if (begun != runtime::Status::ok)
    throw Error("", "scenario " + std::to_string(observation.number) +
                        " cannot be looked ahead: " + runtime::message_of(begun));
  search.advance({}, selector_.workspace);
  const lookahead::LookAheadStatus& status = search.finish(character);
  took_s_.push_back(clock_() - before_s);
  encounters_ += static_cast<double>(status.encounters);
  // The chosen one, then the others in their order.
  Ranking ranking;
  ranking.best[ranking.count++] = status.candidates[status.chosen].candidate;
  for (std::size_t i = 0; i < status.count && ranking.count < ranking.best.size(); ++i)
    if (i != status.chosen) ranking.best[ranking.count++] = status.candidates[i].candidate;
  return ranking;
}

}  // namespace flinch::train
