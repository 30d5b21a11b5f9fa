// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "train/simulate/messenger.h"
#include "train/simulate/worker_messages.h"

namespace flinch::train {

/// The workers of a run as its writer, process 0, sees them. The writer answers them between its
/// own trials. No worker waits for another, so a slow one delays nobody.
class WorkerPool {
 public:
  /// Callbacks that supply and receive work.
  struct Callbacks {
    std::function<std::optional<ScenarioRange>(int threads)> next;
    std::function<void(const RangeResult&)> take;
    /// Takes back the range of a worker that was interrupted.
    std::function<void(ScenarioRange)> take_back;
  };

  /// All arguments must outlive this. Refuses workers whose run has another hash.
  WorkerPool(Messenger& messenger, Callbacks work, std::uint64_t run_hash);

  /// Answers all messages that have arrived. Throws Error if a worker failed.
  void poll();
  /// Sleeps briefly. For when nothing is left to do but wait for messages.
  void wait() const;
  /// Whether a worker is busy or has not yet asked for work.
  bool has_active_workers() const { return active_workers_ > 0; }

 private:
  void answer(int number, const WorkerMessage& message);
  void assign(int number);

  Messenger& messenger_;
  Callbacks callbacks_;
  std::uint64_t run_hash_;
  struct Worker {
    int threads = 1;
    ScenarioRange range;  ///< that the worker simulates
  };
  std::vector<Worker> workers_;  ///< by process number
  int active_workers_;
};

/// Runs a worker, a process other than 0: simulates ranges as they are assigned until there are
/// none. `simulate` returns nothing if it was interrupted. Reports its exceptions to the writer
/// instead of throwing them.
void run_worker(Messenger& messenger, std::uint64_t run_hash, int threads,
                const std::function<std::optional<RangeResult>(ScenarioRange)>& simulate);

/// Reports that a worker could not start.
void report_failure(Messenger& messenger, const std::string& why);

}  // namespace flinch::train
