// SPDX-License-Identifier: MIT
#include "bindings/python/long_work.h"

#include <chrono>
#include <exception>
#include <stdexcept>
#include <thread>
#include <utility>

namespace flinch::python {

namespace py = pybind11;

void WorkMonitor::tell(Progress progress) {
  if (stop_) throw std::runtime_error("stopped");
  const std::lock_guard lock(mutex_);
  news_ = std::move(progress);
  changed_.notify_one();
}

void WorkMonitor::finish() {
  const std::lock_guard lock(mutex_);
  finished_ = true;
  changed_.notify_one();
}

bool WorkMonitor::wait_a_moment() {
  constexpr std::chrono::milliseconds kMoment{50};  // a person does not feel this
  const py::gil_scoped_release release;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kMoment, [this] { return finished_ || news_.has_value(); });
  return finished_;
}

std::optional<Progress> WorkMonitor::take_news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, std::nullopt);
}

void run_interruptibly(const py::object& progress, const std::function<void(WorkMonitor&)>& work) {
  WorkMonitor monitor;
  std::exception_ptr failure;
  std::thread thread([&] {
    try {
      work(monitor);
    } catch (...) {
      failure = std::current_exception();
    }
    monitor.finish();
  });
  std::exception_ptr interruption;
  for (bool finished = false; !finished;) {
    finished = monitor.wait_a_moment();
    const std::optional<Progress> news = monitor.take_news();
    if (interruption) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (news && !progress.is_none()) progress(news->what, news->done, news->wanted);
    } catch (...) {
      interruption = std::current_exception();
      monitor.stop_ = true;
    }
  }
  {
    const py::gil_scoped_release release;
    thread.join();
  }
  if (interruption) std::rethrow_exception(interruption);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace flinch::python
