// SPDX-License-Identifier: MIT
#include "train/simulate/batch.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>

namespace flinch::train {

namespace {

/// The first thing thrown by any of several threads.
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

/// Where a trial is in the batch, and the response that it shares.
struct Task {
  ResponseKey key;
  std::size_t observation = 0;
  std::size_t trial = 0;
};

/// Tasks that are done by one thread, one after the other.
using Group = std::span<const Task>;

std::vector<Task> tasks_of(const SimulationSubject& subject,
                           const std::vector<Observation>& observations) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const Observation& observation = observations[i];
    const GridPlace place =
        place_of(subject.plan.distribution, subject.idle(), observation.scenario);
    for (std::size_t j = 0; j < observation.trials.size(); ++j)
      tasks.push_back({subject.responses.key_of(observation.trials[j].clip, place), i, j});
  }
  std::ranges::stable_sort(tasks, {}, &Task::key);
  return tasks;
}

/// Those of one response; at most so many that no thread is left with a long one at the end.
std::vector<Group> groups_of(const std::vector<Task>& tasks) {
  constexpr std::size_t kMost = 64;
  std::vector<Group> groups;
  for (auto first = tasks.begin(); first != tasks.end();) {
    const auto limit = first + std::min<std::ptrdiff_t>(kMost, tasks.end() - first);
    const auto end =
        std::find_if(first, limit, [&](const Task& task) { return task.key != first->key; });
    groups.emplace_back(first, end);
    first = end;
  }
  return groups;
}

/// What one thread did.
struct Share {
  SimulationCounts counts;
  PhaseTimes cpu;
};

/// What all threads of a batch work with.
class Workshop {
 public:
  Workshop(const SimulationSubject& subject, Rehearsals& rehearsals, const BatchContext& context,
           std::vector<Observation>& observations)
      : subject_(subject),
        rehearsals_(rehearsals),
        context_(context),
        observations_(observations) {}

  bool stopped() const { return context_.stop != nullptr && *context_.stop; }

  void work_on(Group group, Share& share) const {
    const double begin_s = context_.cpu_s();
    const auto response = subject_.plan.unabridged ? nullptr : response_of(group.front().key);
    const double rehearsed_s = context_.cpu_s();
    for (const Task& task : group) {
      if (stopped()) return;
      Observation& observation = observations_[task.observation];
      Trial& trial = observation.trials[task.trial];
      const TrialResult result = response
                                     ? try_rehearsed(subject_, observation.scenario, *response)
                                     : try_unabridged(subject_, observation.scenario, trial.clip);
      trial = result.trial;
      share.counts.add(result.simulated);
    }
    share.cpu.rehearsing_s += rehearsed_s - begin_s;
    share.cpu.striking_s += context_.cpu_s() - rehearsed_s;
  }

 private:
  std::shared_ptr<const RehearsedResponse> response_of(const ResponseKey& key) const {
    if (auto kept = rehearsals_.find(key)) return kept;
    auto response = std::make_shared<const RehearsedResponse>(rehearse(subject_, key));
    rehearsals_.offer(response);
    return response;
  }

  const SimulationSubject& subject_;
  Rehearsals& rehearsals_;
  const BatchContext& context_;
  std::vector<Observation>& observations_;
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
  striking_s += other.striking_s;
  writing_s += other.writing_s;
}

double PhaseTimes::total_s() const {
  return posing_s + rehearsing_s + striking_s + writing_s;
}

bool simulate_batch(const SimulationSubject& subject, Rehearsals& rehearsals, ScenarioRange range,
                    const BatchContext& context, Batch& batch) {
  batch = {};
  const double begin_s = context.cpu_s();
  for (std::uint64_t number = range.first; number < range.end(); ++number)
    batch.observations.push_back(pose_scenario(subject, number));
  const std::vector<Task> tasks = tasks_of(subject, batch.observations);
  const std::vector<Group> groups = groups_of(tasks);
  batch.cpu.posing_s = context.cpu_s() - begin_s;

  const Workshop workshop(subject, rehearsals, context, batch.observations);
  FirstException failure;
#pragma omp parallel num_threads(context.threads)
  {
    Share share;
#pragma omp for schedule(dynamic) nowait
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (workshop.stopped() || failure.thrown()) continue;
      try {
        workshop.work_on(groups[k], share);
        if (omp_get_thread_num() == 0) context.attend();
      } catch (...) {
        failure.keep_current();
      }
    }
#pragma omp critical
    {
      batch.counts.add(share.counts);
      batch.cpu.add(share.cpu);
    }
  }
  failure.rethrow();
  return !workshop.stopped();
}

}  // namespace flinch::train
