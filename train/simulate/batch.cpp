// SPDX-License-Identifier: MIT
#include "train/simulate/batch.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <span>

namespace flinch::train {

namespace {

/// The first exception of several threads.
class FirstException {
 public:
  void keep_current() {
    const std::lock_guard lock(mutex_);
    if (!exception_) exception_ = std::current_exception();
    thrown_ = true;
  }
  bool thrown() const { return thrown_; }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr exception_;
  std::atomic<bool> thrown_ = false;
};

/// Index of a trial in the batch, and the response that it shares.
struct TrialTask {
  ResponseKey key;
  std::size_t observation = 0;
  std::size_t trial = 0;
};

static_assert(sizeof(Trial) + 2 * sizeof(TrialTask) <= kBatchBytesPerTrial);

/// Tasks that one thread does together.
using TaskGroup = std::span<const TrialTask>;

std::vector<TrialTask> tasks_of(const SimulationSetup& setup,
                                const std::vector<Observation>& observations) {
  std::vector<TrialTask> tasks;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const Observation& observation = observations[i];
    const GridCell cell =
        grid_cell_of(setup.plan.distribution, setup.stances, observation.scenario);
    for (std::size_t j = 0; j < observation.trials.size(); ++j)
      tasks.push_back({setup.responses.key_of(observation.trials[j].clip, cell), i, j});
  }
  std::ranges::stable_sort(tasks, {}, &TrialTask::key);
  return tasks;
}

/// Groups the tasks, which are sorted by response, so that simulations can share what they need
/// once: whole responses, as many as make up kMinGroupSize tasks. A response is divided only where
/// it has more than kMaxResponseSize, so that no thread has much left to do at the end.
std::vector<TaskGroup> groups_of(std::span<const TrialTask> tasks) {
  constexpr std::ptrdiff_t kMinGroupSize = 16;
  constexpr std::ptrdiff_t kMaxResponseSize = 64;
  std::vector<TaskGroup> groups;
  for (auto first = tasks.begin(); first != tasks.end();) {
    auto end = first;
    while (end != tasks.end() && end - first < kMinGroupSize) {
      const ResponseKey& key = end->key;
      const auto limit = end + std::min(kMaxResponseSize, tasks.end() - end);
      end = std::find_if(end, limit, [&](const TrialTask& task) { return task.key != key; });
    }
    groups.emplace_back(first, end);
    first = end;
  }
  return groups;
}

/// What one thread works with, and its results.
struct ThreadState {
  std::optional<sim::ThrowSimulator> throws;  ///< once needed
  SimulationCounts counts;
  PhaseTimes cpu;
};

/// State that all threads of a batch share.
class TrialRunner {
 public:
  TrialRunner(const SimulationSetup& setup, RehearsalCache& rehearsals, const BatchContext& context,
              std::vector<Observation>& observations)
      : setup_(setup), rehearsals_(rehearsals), context_(context), observations_(observations) {
    if (!setup.plan.options.keeps_places) return;
    for (const Observation& observation : observations)
      places_.emplace_back(observation.trials.size());
  }

  /// Gives the observations the places of their trials. Call once all groups have run.
  void give_places() {
    for (std::size_t i = 0; i < places_.size(); ++i)
      for (const std::vector<HitPlace>& places : places_[i])
        observations_[i].places.insert(observations_[i].places.end(), places.begin(), places.end());
  }

  bool stopped() const { return context_.stop != nullptr && *context_.stop; }

  void run_group(TaskGroup group, ThreadState& thread) {
    if (setup_.plan.unabridged) {
      run_unabridged(group, thread);
    } else {
      run_rehearsed(group, thread);
    }
  }

 private:
  void run_unabridged(TaskGroup group, ThreadState& thread) {
    const double begin_s = context_.cpu_s();
    for (const TrialTask& task : group) {
      if (stopped()) return;
      const int clip = trial_of(task).clip;
      take(task, try_unabridged(setup_, observations_[task.observation].scenario, clip), thread);
    }
    thread.cpu.contact_s += context_.cpu_s() - begin_s;
  }

  void run_rehearsed(TaskGroup group, ThreadState& thread) {
    const double begin_s = context_.cpu_s();
    std::vector<std::shared_ptr<const RehearsedResponse>> responses;
    std::vector<RehearsedTrial> trials;
    for (const TrialTask& task : group) {
      if (stopped()) return;
      if (responses.empty() || responses.back()->key != task.key)
        responses.push_back(response_of(task.key));
      trials.push_back({observations_[task.observation].scenario, *responses.back()});
    }
    const double rehearsed_s = context_.cpu_s();
    if (!thread.throws) thread.throws.emplace(setup_.simulator, context_.lanes);
    const std::vector<TrialResult> results = try_rehearsed(setup_, trials, *thread.throws);
    for (std::size_t i = 0; i < group.size(); ++i) take(group[i], results[i], thread);
    thread.cpu.rehearsing_s += rehearsed_s - begin_s;
    thread.cpu.contact_s += context_.cpu_s() - rehearsed_s;
  }

  Trial& trial_of(const TrialTask& task) const {
    return observations_[task.observation].trials[task.trial];
  }

  void take(const TrialTask& task, const TrialResult& result, ThreadState& thread) {
    trial_of(task) = result.trial;
    if (!result.places.empty()) places_[task.observation][task.trial] = result.places;
    thread.counts.add(result.simulated);
  }

  std::shared_ptr<const RehearsedResponse> response_of(const ResponseKey& key) const {
    if (auto kept = rehearsals_.find(key)) return kept;
    auto response = std::make_shared<const RehearsedResponse>(rehearse(setup_, key));
    rehearsals_.insert(response);
    return response;
  }

  const SimulationSetup& setup_;
  RehearsalCache& rehearsals_;
  const BatchContext& context_;
  std::vector<Observation>& observations_;
  std::vector<std::vector<std::vector<HitPlace>>> places_;  ///< of each trial of each observation
};

}  // namespace

void SimulationCounts::add(const sim::SimulationResult& result) {
  ++simulations;
  skipped += result.skipped ? 1 : 0;
  hits += std::isfinite(result.first_contact_s) ? 1 : 0;
  steps += static_cast<std::uint64_t>(result.steps);
  solver_messages += static_cast<std::uint64_t>(result.solver_messages);
}

void SimulationCounts::add(const SimulationCounts& other) {
  simulations += other.simulations;
  skipped += other.skipped;
  hits += other.hits;
  steps += other.steps;
  solver_messages += other.solver_messages;
}

void PhaseTimes::add(const PhaseTimes& other) {
  posing_s += other.posing_s;
  rehearsing_s += other.rehearsing_s;
  contact_s += other.contact_s;
  writing_s += other.writing_s;
}

double PhaseTimes::total_s() const {
  return posing_s + rehearsing_s + contact_s + writing_s;
}

bool simulate_batch(const SimulationSetup& setup, RehearsalCache& rehearsals, ScenarioRange range,
                    const BatchContext& context, Batch& batch) {
  batch = {};
  const double begin_s = context.cpu_s();
  for (std::uint64_t number = range.first; number < range.end(); ++number)
    batch.observations.push_back(make_observation(setup, number));
  const std::vector<TrialTask> tasks = tasks_of(setup, batch.observations);
  const std::vector<TaskGroup> groups = groups_of(tasks);
  batch.cpu.posing_s = context.cpu_s() - begin_s;

  TrialRunner runner(setup, rehearsals, context, batch.observations);
  FirstException failure;
#pragma omp parallel num_threads(context.threads)
  {
    ThreadState thread;
#pragma omp for schedule(dynamic) nowait
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (runner.stopped() || failure.thrown()) continue;
      try {
        runner.run_group(groups[k], thread);
        if (omp_get_thread_num() == 0) context.poll();
      } catch (...) {
        failure.keep_current();
      }
    }
#pragma omp critical
    {
      batch.counts.add(thread.counts);
      batch.cpu.add(thread.cpu);
    }
  }
  failure.rethrow();
  runner.give_places();
  return !runner.stopped();
}

}  // namespace flinch::train
