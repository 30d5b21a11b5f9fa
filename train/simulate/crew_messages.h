// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "train/simulate/batch.h"

namespace flinch::train {

/// What the processes of a run tell each other.

/// A helper is there, and wants a range.
struct Ready {
  std::uint64_t run_hash = 0;  ///< of what it simulates: must be the writer's
  std::uint32_t threads = 1;
};

/// A helper has done a range, and wants another. Of each scenario only the trials travel: the rest
/// follows from its number.
struct Done {
  ScenarioRange range;
  SimulationCounts counts;
  PhaseTimes cpu;
  std::vector<std::vector<std::byte>> trials;  ///< encoded, one a scenario
};

/// A helper cannot go on.
struct Failed {
  std::string why;
};

/// A helper was interrupted.
struct Stopped {};

/// What the writer wants of a helper; an empty range: nothing any more.
struct Assignment {
  ScenarioRange range;
};

using CrewMessage = std::variant<Ready, Done, Failed, Stopped, Assignment>;

std::vector<std::byte> encode(const CrewMessage& message);
/// Throws Error for bytes that are no message of this version.
CrewMessage decode(std::span<const std::byte> bytes);

}  // namespace flinch::train
