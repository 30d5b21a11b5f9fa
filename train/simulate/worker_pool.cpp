// SPDX-License-Identifier: MIT
#include "train/simulate/worker_pool.h"

#include <chrono>
#include <exception>
#include <thread>

#include "motion/error.h"

namespace flinch::train {

namespace {

constexpr int kWriter = 0;
/// Sleep of an idle process between polls. Negligible beside the second that a range takes, and it
/// leaves the processor to others.
constexpr std::chrono::milliseconds kPollInterval(1);

ScenarioRange wait_for_assignment(Messenger& messenger) {
  for (;;) {
    if (const auto message = messenger.receive())
      return std::get<Assignment>(decode(message->bytes)).range;
    std::this_thread::sleep_for(kPollInterval);
  }
}

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace

WorkerPool::WorkerPool(Messenger& messenger, Callbacks work, std::uint64_t run_hash)
    : messenger_(messenger),
      callbacks_(std::move(work)),
      run_hash_(run_hash),
      workers_(static_cast<std::size_t>(messenger.size())),
      active_workers_(messenger.size() - 1) {}

void WorkerPool::poll() {
  while (const auto message = messenger_.receive()) answer(message->from, decode(message->bytes));
}

void WorkerPool::wait() const {
  std::this_thread::sleep_for(kPollInterval);
}

void WorkerPool::assign(int number) {
  Worker& worker = workers_[static_cast<std::size_t>(number)];
  const auto range = callbacks_.next(worker.threads);
  if (!range) --active_workers_;
  worker.range = range.value_or(ScenarioRange{});
  messenger_.send(number, encode(Assignment{worker.range}));
}

void WorkerPool::answer(int number, const WorkerMessage& message) {
  Worker& worker = workers_[static_cast<std::size_t>(number)];
  const std::string name = "process " + std::to_string(number);
  const auto ready = [&](const WorkRequest& it) {
    if (it.run_hash != run_hash_)
      throw Error("", name +
                          " simulates another library or distribution; give all the same files and "
                          "the same build");
    worker.threads = static_cast<int>(it.threads);
    assign(number);
  };
  const auto done = [&](const RangeResult& it) {
    callbacks_.take(it);
    assign(number);
  };
  const auto failed = [&](const WorkerFailure& it) { throw Error("", name + ": " + it.why); };
  const auto stopped = [&](const WorkerStopped&) {
    callbacks_.take_back(worker.range);
    --active_workers_;
  };
  const auto assigned = [&](const Assignment&) { throw Error("", name + " gives orders"); };
  std::visit(Overloaded{ready, done, failed, stopped, assigned}, message);
}

void run_worker(Messenger& messenger, std::uint64_t run_hash, int threads,
                const std::function<std::optional<RangeResult>(ScenarioRange)>& simulate) {
  messenger.send(kWriter, encode(WorkRequest{run_hash, static_cast<std::uint32_t>(threads)}));
  for (ScenarioRange range = wait_for_assignment(messenger); range.count > 0;
       range = wait_for_assignment(messenger)) {
    std::optional<RangeResult> done;
    try {
      done = simulate(range);
    } catch (const std::exception& error) {
      messenger.send(kWriter, encode(WorkerFailure{error.what()}));
      return;
    }
    if (!done) {
      messenger.send(kWriter, encode(WorkerStopped{}));
      return;
    }
    messenger.send(kWriter, encode(*done));
  }
}

void report_failure(Messenger& messenger, const std::string& why) {
  messenger.send(kWriter, encode(WorkerFailure{why}));
}

}  // namespace flinch::train
