// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "train/simulate/messenger.h"
#include "train/simulate/worker_messages.h"

namespace flinch::train {

/// The workers of a run as its writer, process 0, sees them. It answers them now and then while it
/// simulates itself; none waits for another, so a slow one holds nobody up.
class WorkerPool {
 public:
  /// Where the work comes from and goes to.
  struct Callbacks {
    std::function<std::optional<ScenarioRange>(int threads)> next;
    std::function<void(const RangeResult&)> take;
    std::function<void(ScenarioRange)> take_back;  ///< of a worker that was interrupted
  };

  /// All must outlive this. Helpers that simulate anything but the run of this hash are refused.
  WorkerPool(Messenger& messenger, Callbacks work, std::uint64_t run_hash);

  /// Answers all that has arrived. Throws Error when a worker failed.
  void poll();
  /// Sleeps a moment: for when there is nothing but answers to wait for.
  void wait() const;
  /// Whether workers are at work or have not yet asked for any.
  bool has_active_workers() const { return active_workers_ > 0; }

 private:
  void answer(int number, const WorkerMessage& message);
  void assign(int number);

  Messenger& messenger_;
  Callbacks callbacks_;
  std::uint64_t run_hash_;
  struct Worker {
    int threads = 1;
    ScenarioRange range;  ///< that it is at
  };
  std::vector<Worker> workers_;  ///< by process
  int active_workers_;
};

/// What a worker, a process other than 0, does: ranges as they are assigned until there are none.
/// `simulate` gives nothing when it was interrupted. What it throws is told to the writer, not
/// thrown.
void run_worker(Messenger& messenger, std::uint64_t run_hash, int threads,
                const std::function<std::optional<RangeResult>(ScenarioRange)>& simulate);

/// A worker could not even begin.
void report_failure(Messenger& messenger, const std::string& why);

}  // namespace flinch::train
