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

/// A worker is there, and wants a range.
struct WorkRequest {
  std::uint64_t run_hash = 0;  ///< of what it simulates: must be the writer's
  std::uint32_t threads = 1;
};

/// A worker has done a range, and wants another. Of each scenario only the trials travel: the rest
/// follows from its number.
struct RangeResult {
  ScenarioRange range;
  SimulationCounts counts;
  PhaseTimes cpu;
  std::vector<std::vector<std::byte>> trials;  ///< encoded, one a scenario
};

/// A worker cannot go on.
struct WorkerFailure {
  std::string why;
};

/// A worker was interrupted.
struct WorkerStopped {};

/// What the writer wants of a worker; an empty range: nothing any more.
struct Assignment {
  ScenarioRange range;
};

using WorkerMessage =
    std::variant<WorkRequest, RangeResult, WorkerFailure, WorkerStopped, Assignment>;

std::vector<std::byte> encode(const WorkerMessage& message);
/// Throws Error for bytes that are no message of this version.
WorkerMessage decode(std::span<const std::byte> bytes);

}  // namespace flinch::train
