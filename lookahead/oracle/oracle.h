// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "features/threat.h"
#include "motion/body.h"
#include "runtime/character.h"
#include "sim/rehearsal/simulator.h"

namespace flinch::lookahead {

/// The clips to try on a threat at this target: the allowed ones for anticipation and the idle
/// clip, in ascending order.
std::vector<int> clips_to_try(const database::ClipLibrary& library, motion::Target threatened);

/// What a threat does to a character that answers it with a clip.
struct ClipTrial {
  int clip = 0;
  double work_j = 0;     ///< of the whole response
  double damage_ns = 0;  ///< as the library's selector weighs impulses
  double cost_ns = 0;
  /// Time of the first contact, s after perception; infinite if nothing touches.
  double first_contact_s = std::numeric_limits<double>::infinity();
  motion::PerBody<double> impulse;  ///< as in sim::SimulationResult, N·s
};

/// Index of the best of some trials, at least one, by the trainer's rule: the lowest cost; among
/// those within 1 % of it less work, then the lower clip.
std::size_t best_of(std::span<const ClipTrial> trials);

/// Simulates clips against a threat with the figure, the laws and the costs of training, as
/// train::try_rehearsed does. Unlike look-ahead it approximates nothing: each trial starts with an
/// undisturbed run of the whole response. Allocates, and takes about 2 ms per clip. Immutable: any
/// threads may use it.
class Oracle {
 public:
  /// `library` must be loaded, its selector know costs, and outlive this.
  explicit Oracle(const runtime::Library& library);

  /// What `threat` will do to a character that has noticed it as `perception` tells and answers
  /// with this clip. `threat` is what approaches in truth at the moment of perception. None if the
  /// character cannot answer with this clip (runtime::Character::plan).
  std::optional<ClipTrial> try_clip(const runtime::Character& character,
                                    const runtime::Perception& perception,
                                    const features::Threat& threat, int clip) const;
  /// The same for a response of another kind, such as Character::plan_brace(); its clip is
  /// `response.clip`.
  ClipTrial try_response(const runtime::Response& response, const runtime::Perception& perception,
                         const features::Threat& threat) const;
  /// Tries all clips_to_try() that the character can answer with, in ascending order.
  std::vector<ClipTrial> try_all(const runtime::Character& character,
                                 const runtime::Perception& perception,
                                 const features::Threat& threat) const;

 private:
  const runtime::Library& library_;
  sim::SimulationOptions options_;
  sim::Simulator simulator_;
};

}  // namespace flinch::lookahead
