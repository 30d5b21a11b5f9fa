// SPDX-License-Identifier: MIT
#include "train/simulate/worker_pool.h"

#include <gtest/gtest.h>

#include <thread>

#include "motion/error.h"
#include "tests/scenes/error_of.h"
#include "tests/train/simulate/local_messenger.h"
#include "train/simulate/scenario_scheduler.h"

namespace flinch::train {
namespace {

constexpr std::uint64_t kRun = 42;

RangeResult done_of(ScenarioRange range) {
  RangeResult done{range, {}, {}, {}, {}};
  done.counts.simulations = range.count;
  for (std::uint64_t i = 0; i < range.count; ++i)
    done.trials.push_back(std::vector<std::byte>(static_cast<std::size_t>((range.first + i) % 5)));
  done.places.resize(done.trials.size());
  return done;
}

/// Result of a run with workers that do nothing and a writer that only hands out ranges.
struct Outcome {
  std::vector<int> times_done;  ///< by scenario
  std::uint64_t simulations = 0;
};

Outcome run(std::uint64_t scenarios, int workers,
            const std::function<std::optional<RangeResult>(int worker, ScenarioRange)>& simulate) {
  LocalExchange exchange(workers + 1);
  std::vector<std::jthread> threads;
  for (int worker = 1; worker <= workers; ++worker) {
    threads.emplace_back([&exchange, &simulate, worker] {
      LocalMessenger messenger(exchange, worker);
      run_worker(messenger, kRun, 1, [&](ScenarioRange range) { return simulate(worker, range); });
    });
  }
  LocalMessenger messenger(exchange, 0);
  ScenarioScheduler ranges({{0, scenarios}}, workers, {64});
  Outcome outcome{std::vector<int>(scenarios), 0};
  const auto take = [&](const RangeResult& done) {
    EXPECT_EQ(done.trials.size(), done.range.count);
    for (std::uint64_t i = 0; i < done.range.count; ++i) {
      ++outcome.times_done[done.range.first + i];
      EXPECT_EQ(done.trials[i].size(), (done.range.first + i) % 5);
    }
    outcome.simulations += done.counts.simulations;
  };
  WorkerPool pool(messenger,
                  {[&](int) { return ranges.next(1); }, take,
                   [&](ScenarioRange range) { ranges.put_back(range); }},
                  kRun);
  try {
    while (pool.has_active_workers()) {
      pool.poll();
      pool.wait();
    }
  } catch (...) {  // processes would end with the job, but threads must be told to end
    for (int worker = 1; worker <= workers; ++worker) messenger.send(worker, encode(Assignment{}));
    throw;
  }
  return outcome;
}

TEST(WorkerPool, SimulatesEveryScenarioOnce) {
  for (const int workers : {1, 2, 5}) {
    const Outcome outcome =
        run(3000, workers, [](int, ScenarioRange range) { return done_of(range); });
    EXPECT_EQ(outcome.times_done, std::vector<int>(3000, 1));
    EXPECT_EQ(outcome.simulations, 3000U);
  }
}

TEST(WorkerPool, ASlowWorkerDoesNotDelayTheOthers) {
  std::atomic<std::uint64_t> by_slow = 0;
  const Outcome outcome = run(2000, 3, [&](int worker, ScenarioRange range) {
    if (worker == 1) {
      by_slow += range.count;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return done_of(range);
  });
  EXPECT_EQ(outcome.times_done, std::vector<int>(2000, 1));
  EXPECT_LT(by_slow, 500U);
}

TEST(WorkerPool, ReassignsTheRangeOfAnInterruptedWorker) {
  const Outcome outcome =
      run(1000, 3, [](int worker, ScenarioRange range) -> std::optional<RangeResult> {
        if (worker == 2 && range.first > 100) return std::nullopt;
        return done_of(range);
      });
  EXPECT_EQ(outcome.times_done, std::vector<int>(1000, 1));
}

TEST(WorkerPool, ReportsAFailureWithItsReason) {
  const auto fails = [](int worker, ScenarioRange range) -> std::optional<RangeResult> {
    if (worker == 2) throw Error("real.flinchlib", "is gone");
    return done_of(range);
  };
  EXPECT_EQ(tests::error_of([&] { run(50'000, 2, fails); }), "process 2: real.flinchlib: is gone");
}

TEST(WorkerPool, RejectsAWorkerOfAnotherRun) {
  LocalExchange exchange(2);
  LocalMessenger worker(exchange, 1);
  worker.send(0, encode(WorkRequest{kRun + 1, 1}));
  LocalMessenger messenger(exchange, 0);
  WorkerPool pool(messenger, {}, kRun);
  EXPECT_THROW(pool.poll(), Error);
}

TEST(WorkerMessages, RoundTrip) {
  RangeResult done = done_of({7, 3});
  done.trials[1] = {std::byte{1}, std::byte{255}};
  done.places[2] = {std::byte{7}};
  done.counts = {1, 2, 3, 4, 5};
  done.cpu.contact_s = 0.25;
  const auto arrived = std::get<RangeResult>(decode(encode(done)));
  EXPECT_EQ(arrived.range.first, 7U);
  EXPECT_EQ(arrived.trials, done.trials);
  EXPECT_EQ(arrived.places, done.places);
  EXPECT_EQ(arrived.counts.solver_messages, 5U);
  EXPECT_EQ(arrived.cpu.contact_s, 0.25);
  EXPECT_EQ(std::get<WorkerFailure>(decode(encode(WorkerFailure{"why"}))).why, "why");
  EXPECT_EQ(std::get<WorkRequest>(decode(encode(WorkRequest{9, 8}))).threads, 8U);
  EXPECT_EQ(std::get<Assignment>(decode(encode(Assignment{{4, 5}}))).range.count, 5U);
}

TEST(WorkerMessages, RejectsTruncatedOrOverlongBytes) {
  std::vector<std::byte> bytes = encode(done_of({7, 3}));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(decode(std::span(bytes).first(size)), Error) << size;
  bytes.push_back({});
  EXPECT_THROW(decode(bytes), Error);
  EXPECT_THROW(decode(std::vector<std::byte>{std::byte{200}}), Error);
}

}  // namespace
}  // namespace flinch::train
