// SPDX-License-Identifier: MIT
// Compares what a character foresees with what training measured, for all clips of a store's first
// scenarios, and prints the table of docs/look_ahead.md:
//
//     look_ahead_study FITTED_STORE TEST_STORE [SCENARIOS]
//
// The work of the clips' responses is taken from the first store, as `flinch train` does.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "database/library/library_file.h"
#include "lookahead/response_trial.h"
#include "runtime/response/prepared_library.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "train/fit/labels.h"
#include "train/fit/response_costs.h"

namespace flinch {
namespace {

constexpr double kTail_s = 0.3;  // SimulationPlan::tail_s
constexpr std::array kBrawns{0.1, 0.5};
constexpr std::size_t kWorst = 10;

struct Pair {
  std::uint64_t scenario = 0;
  int clip = 0;
  double damage_ns = 0;  ///< as training measured it
  double foreseen_damage_ns = 0;
  double work_j = 0;
  double foreseen_work_j = 0;
  int bodies_hit = 0;        ///< as training measured it
  bool is_given_up = false;  ///< although its damage is 1 % below the limit
  bool is_foretold = false;  ///< given up without simulation at a limit of half its damage
  std::array<double, kBrawns.size()> cost_ns{};
  std::array<double, kBrawns.size()> foreseen_cost_ns{};

  /// The difference as a share of the larger.
  static double change(double expected, double found) {
    const double larger = std::max(expected, found);
    return larger > 0 ? std::abs(found - expected) / larger : 0;
  }
  double cost_change(std::size_t brawn) const {
    return change(cost_ns[brawn], foreseen_cost_ns[brawn]);
  }
};

struct Study {
  std::vector<Pair> pairs;
  std::vector<double> plan_us;
  std::vector<double> pass_us;
  std::vector<double> hit_us;
  double steps = 0;
};

double share_of(const std::vector<Pair>& pairs, auto&& is) {
  const auto count = std::count_if(pairs.begin(), pairs.end(), is);
  return 100 * static_cast<double>(count) / static_cast<double>(pairs.size());
}

void print_changes(const char* what, const Study& study, auto&& change) {
  std::vector<double> changes;
  for (const Pair& pair : study.pairs) changes.push_back(change(pair));
  const auto within = [&](double limit) {
    return share_of(study.pairs, [&](const Pair& pair) { return change(pair) <= limit; });
  };
  std::printf("| %s | %.2f %% | %.2f %% | %.2f %% | %.3f %% | %.2f %% |\n", what, within(0.01),
              within(0.02), within(0.05), 100 * bench::quantile(changes, 0.5),
              100 * bench::quantile(changes, 0.95));
}

/// How many pairs' costs differ by more than 1 %, by the number of bodies that are hit: second hits
/// turn on a fraction of a millimetre of the first.
void print_by_bodies(const Study& study) {
  std::printf(
      "\n| bodies hit | pairs | brawn %.1f: cost differs by more than 1 %% | brawn %.1f |\n"
      "| --- | --- | --- | --- |\n",
      kBrawns[0], kBrawns[1]);
  constexpr int kMost = 3;  // and more
  for (int bodies = 0; bodies <= kMost; ++bodies) {
    int pairs = 0;
    std::array<int, kBrawns.size()> differ{};
    for (const Pair& pair : study.pairs) {
      if (std::min(pair.bodies_hit, kMost) != bodies) continue;
      ++pairs;
      for (std::size_t brawn = 0; brawn < kBrawns.size(); ++brawn)
        differ[brawn] += pair.cost_change(brawn) > 0.01;
    }
    std::printf("| %d%s | %d | %d | %d |\n", bodies, bodies == kMost ? " or more" : "", pairs,
                differ[0], differ[1]);
  }
}

void print(Study study) {
  const auto hits = [](const Pair& pair) { return pair.damage_ns > 0; };
  const auto same = [](const Pair& pair) {
    return (pair.damage_ns > 0) == (pair.foreseen_damage_ns > 0);
  };
  std::printf("%zu pairs of scenario and clip, of which %.1f %% are hits\n", study.pairs.size(),
              share_of(study.pairs, hits));
  std::printf("the same hit or miss: %.2f %%\n\n", share_of(study.pairs, same));
  std::printf(
      "| change | within 1 %% | 2 %% | 5 %% | median | p95 |\n| --- | --- | --- | --- | --- "
      "| --- |\n");
  print_changes("damage", study, [](const Pair& pair) {
    return Pair::change(pair.damage_ns, pair.foreseen_damage_ns);
  });
  print_changes("work", study,
                [](const Pair& pair) { return Pair::change(pair.work_j, pair.foreseen_work_j); });
  for (std::size_t brawn = 0; brawn < kBrawns.size(); ++brawn) {
    const std::string what = "cost at brawn " + std::to_string(kBrawns[brawn]).substr(0, 3);
    print_changes(what.c_str(), study, [&](const Pair& pair) { return pair.cost_change(brawn); });
  }
  print_by_bodies(study);
  std::printf(
      "\ngiven up without simulation at a limit of half their damage: %.1f %% of the hits\n",
      share_of(study.pairs, [](const Pair& pair) { return pair.is_foretold; }) * 100 /
          share_of(study.pairs, hits));
  std::printf("given up at a limit that is 1 %% above their damage: %.2f %%\n",
              share_of(study.pairs, [](const Pair& pair) { return pair.is_given_up; }) * 100 /
                  share_of(study.pairs, hits));
  std::printf("\n| us | median | p99 |\n| --- | --- | --- |\n");
  std::printf("| plan | %.1f | %.1f |\n", bench::quantile(study.plan_us, 0.5),
              bench::quantile(study.plan_us, 0.99));
  std::printf("| ball that passes | %.1f | %.1f |\n", bench::quantile(study.pass_us, 0.5),
              bench::quantile(study.pass_us, 0.99));
  std::printf("| ball that is simulated | %.1f | %.1f |\n", bench::quantile(study.hit_us, 0.5),
              bench::quantile(study.hit_us, 0.99));
  std::printf("steps of a simulation: %.2f\n\nThe worst:\n\n",
              study.steps / static_cast<double>(study.hit_us.size()));
  std::ranges::sort(study.pairs, std::greater{}, [](const Pair& pair) {
    return std::abs(pair.damage_ns - pair.foreseen_damage_ns);
  });
  for (std::size_t i = 0; i < std::min(kWorst, study.pairs.size()); ++i) {
    const Pair& pair = study.pairs[i];
    std::printf("- scenario %llu, clip %d: damage %.3f N s, foreseen %.3f\n",
                static_cast<unsigned long long>(pair.scenario), pair.clip, pair.damage_ns,
                pair.foreseen_damage_ns);
  }
}

void run(const bench::StudyArguments& arguments) {
  const train::Store fitted = train::read_store(arguments.text(0));
  const train::Store tested = train::read_store(arguments.text(1));
  const auto scenarios = arguments.number_or<std::size_t>(2, 200);
  database::ClipLibrary library;
  if (database::read_embedded_library(tested.header.library_file, library) !=
      database::LoadStatus::ok)
    throw Error(arguments.text(1), "its library cannot be read");
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  const sim::FigureModel figure_model(library.character);
  const train::CostModel model =
      make_cost_model(tested.header, train::vulnerability_profiles()[0], 0.1);
  const models::ResponseCosts costs = response_costs(fitted.header, fitted.observations, model);
  lookahead::ResponseTrial trial(figure_model, double{prepared.reach_m});
  Study study;
  for (std::size_t i = 0; i < std::min(scenarios, tested.observations.size()); ++i) {
    const train::Observation& observation = tested.observations[i];
    const features::Scenario& scenario = observation.scenario;
    const float time_s = scenario.time_to_impact_s;
    const features::Ball ball = features::ball_of(scenario.threat);
    const int kind = scenario.threat.kind;
    const int stance = scenario.state.stance;
    if (!knows_work_from(costs, stance)) continue;
    const float period_s = prepared.stances[static_cast<std::size_t>(stance)].loop.period_s();
    const float phase = (scenario.state.idle_time_s + time_s) / period_s;
    for (const train::Trial& measured : observation.trials) {
      const double begin_s = bench::process_cpu_s();
      const runtime::Response response =
          runtime::make_response(prepared, scenario.state, measured.clip, time_s);
      const double planned_s = bench::process_cpu_s();
      trial.follow(response, library.rate_hz);
      const lookahead::TrialResult found =
          trial.meet(ball, double{time_s} + kTail_s, vulnerability_to(costs, kind));
      const double met_s = bench::process_cpu_s();
      study.plan_us.push_back(1e6 * (planned_s - begin_s));
      (found.steps > 0 ? study.hit_us : study.pass_us).push_back(1e6 * (met_s - planned_s));
      study.steps += found.steps;
      Pair pair{observation.number,
                measured.clip,
                train::damage_ns(measured.impulse, vulnerability_to(model, kind)),
                found.damage_ns,
                double{measured.work_j},
                0,
                static_cast<int>(
                    std::ranges::count_if(measured.impulse, [](float ns) { return ns > 0; })),
                false,
                false,
                {},
                {}};
      if (found.damage_ns > 0) {
        const auto met = [&](double limit_ns) {
          return trial.meet(ball, double{time_s} + kTail_s, vulnerability_to(costs, kind),
                            limit_ns);
        };
        pair.is_given_up = met(1.01 * found.damage_ns).is_cut;
        pair.is_foretold = met(0.5 * found.damage_ns).steps == 0;
      }
      pair.foreseen_work_j = double{work_j(costs, measured.clip, {stance, phase, time_s})};
      for (std::size_t b = 0; b < kBrawns.size(); ++b) {
        pair.cost_ns[b] = cost_ns(costs, kBrawns[b], kind, pair.damage_ns, pair.work_j);
        pair.foreseen_cost_ns[b] =
            cost_ns(costs, kBrawns[b], kind, pair.foreseen_damage_ns, pair.foreseen_work_j);
      }
      study.pairs.push_back(pair);
    }
  }
  print(std::move(study));
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments,
                                   {"look_ahead_study FITTED_STORE TEST_STORE [SCENARIOS]", 2, 3},
                                   flinch::run);
}
