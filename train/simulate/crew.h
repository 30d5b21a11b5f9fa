// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "train/simulate/crew_messages.h"
#include "train/simulate/messenger.h"

namespace flinch::train {

/// The helpers of a run as its writer, process 0, sees them. It answers them now and then while it
/// simulates itself; none waits for another, so a slow one holds nobody up.
class Crew {
 public:
  /// Where the work comes from and goes to.
  struct Work {
    std::function<std::optional<ScenarioRange>(int threads)> next;
    std::function<void(const Done&)> take;
    std::function<void(ScenarioRange)> take_back;  ///< of a helper that was interrupted
  };

  /// All must outlive this. Helpers that simulate anything but the run of this hash are refused.
  Crew(Messenger& messenger, Work work, std::uint64_t run_hash);

  /// Answers all that has arrived. Throws Error when a helper failed.
  void attend();
  /// Sleeps a moment: for when there is nothing but answers to wait for.
  void wait() const;
  /// Whether helpers are at work or have not yet asked for any.
  bool is_at_work() const { return at_work_ > 0; }

 private:
  void answer(int number, const CrewMessage& message);
  void assign(int number);

  Messenger& messenger_;
  Work work_;
  std::uint64_t run_hash_;
  struct Helper {
    int threads = 1;
    ScenarioRange range;  ///< that it is at
  };
  std::vector<Helper> helpers_;  ///< by process
  int at_work_;
};

/// What a helper, a process other than 0, does: ranges as they are assigned until there are none.
/// `simulate` gives nothing when it was interrupted. What it throws is told to the writer, not
/// thrown.
void help(Messenger& messenger, std::uint64_t run_hash, int threads,
          const std::function<std::optional<Done>(ScenarioRange)>& simulate);

/// A helper could not even begin.
void tell_failure(Messenger& messenger, const std::string& why);

}  // namespace flinch::train
