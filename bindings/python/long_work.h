// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace flinch::python {

/// How far long work is.
struct Progress {
  std::string what;
  std::uint64_t done = 0;
  std::uint64_t wanted = 0;  ///< 0 where nobody knows
};

/// What long work tells, and what tells it to stop.
class WorkMonitor {
 public:
  /// Becomes true when the user wants the work to end.
  const std::atomic<bool>& stop() const { return stop_; }
  /// Called by the work. Throws once the work has to end.
  void tell(Progress progress);

 private:
  friend void run_interruptibly(const pybind11::object& progress,
                                const std::function<void(WorkMonitor&)>& work);

  void finish();
  bool wait_a_moment();  ///< Returns whether the work has finished.
  std::optional<Progress> take_news();

  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Progress> news_;
  bool finished_ = false;
};

/// Runs `work` on a thread of its own, without Python's lock. Meanwhile this thread calls
/// `progress(what, done, wanted)`, unless it is None, and looks for Ctrl-C: that, or an exception
/// of `progress`, stops the work and is rethrown when the work has ended. Rethrows what the work
/// throws.
void run_interruptibly(const pybind11::object& progress,
                       const std::function<void(WorkMonitor&)>& work);

}  // namespace flinch::python
