// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "train/simulate/batch.h"

namespace flinch::train {

/// Messages between the processes of a run.

/// A worker has started and asks for a range.
struct WorkRequest {
  std::uint64_t run_hash = 0;  ///< of what it simulates; must equal the writer's
  std::uint32_t threads = 1;
};

/// A worker has finished a range and asks for another. Only the trials of each scenario and
/// their places are sent: the rest follows from its number.
struct RangeResult {
  ScenarioRange range;
  SimulationCounts counts;
  PhaseTimes cpu;
  std::vector<std::vector<std::byte>> trials;  ///< encoded, one per scenario
  std::vector<std::vector<std::byte>> places;  ///< likewise
};

/// A worker cannot continue.
struct WorkerFailure {
  std::string why;
};

/// A worker was interrupted.
struct WorkerStopped {};

/// A range that the writer assigns to a worker; empty if there is no more work.
struct Assignment {
  ScenarioRange range;
};

using WorkerMessage =
    std::variant<WorkRequest, RangeResult, WorkerFailure, WorkerStopped, Assignment>;

std::vector<std::byte> encode(const WorkerMessage& message);
/// Throws Error for bytes that are not a message of this version.
WorkerMessage decode(std::span<const std::byte> bytes);

}  // namespace flinch::train
