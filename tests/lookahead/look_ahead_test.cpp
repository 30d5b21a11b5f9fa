// SPDX-License-Identifier: MIT
#include "lookahead/look_ahead.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <thread>

#include "lookahead/response_trial.h"
#include "tests/lookahead/trained_library.h"
#include "tests/scenes/allocation_count.h"

namespace flinch::lookahead {
namespace {

using tests::trained;

using runtime::Character;
using runtime::Status;

constexpr float kFrame_s = 1.0F / 60;
// By how much a first hit differs if it is simulated from further back, because another follows.
constexpr double kHitTolerance = 0.01;

/// Whether two characters show the same for two seconds, to the bit.
bool move_alike(Character first, Character second) {
  for (int frame = 0; frame < 120; ++frame) {
    const motion::Pose a = first.pose();
    const motion::Pose b = second.pose();
    if (a.root_position != b.root_position) return false;
    for (const motion::Role role : motion::kRoles)
      if (a.rotation[role].coeffs() != b.rotation[role].coeffs()) return false;
    first.update(kFrame_s);
    second.update(kFrame_s);
  }
  return true;
}

/// The cost of answering threats with a clip: every ball simulated, nothing skipped.
double whole_cost_ns(const Character& character, std::span<const features::Threat> threats,
                     int clip) {
  Character perceiving = character;
  runtime::Perception urgent;
  std::vector<runtime::Perception> perceived;
  for (const features::Threat& threat : threats) {
    runtime::Perception one;
    if (perceiving.notice(threat, one) != Status::ok) continue;
    if (perceived.empty() || one.scenario.time_to_impact_s < urgent.scenario.time_to_impact_s)
      urgent = one;
    perceived.push_back(one);
  }
  ResponseTrial trial(*trained().data->figure, double{trained().library.prepared().reach_m});
  trial.follow(perceiving.plan(urgent, clip), trained().clips.rate_hz);
  double damage_ns = 0;
  for (const runtime::Perception& one : perceived) {
    damage_ns +=
        trial
            .meet(features::ball_of(one.scenario.threat),
                  double{one.scenario.time_to_impact_s} + 0.3, trained().costs().vulnerability)
            .damage_ns;
  }
  const float period_s = 2 * trained().library.prepared().idle().duration_s();
  const features::Scenario& scenario = urgent.scenario;
  const float phase = (scenario.state.idle_time_s + scenario.time_to_impact_s) / period_s;
  return cost_ns(trained().costs(), trained().library.selector().brawn, 0, damage_ns,
                 double{work_j(trained().costs(), clip, {0, phase, scenario.time_to_impact_s})});
}

bool begins_in_guard(const train::Observation& observation) {
  return observation.scenario.state.stance == 1;
}

/// The mean work of a clip in all observations that begin with the same stance, phase and time as
/// `like` does.
double mean_work_j(const tests::TrainedLibrary& library, const train::Observation& like, int clip) {
  const auto cell_of = [&](const train::Observation& observation) {
    return grid_cell_of(library.setup.plan.distribution, library.setup.stances,
                        observation.scenario);
  };
  double sum_j = 0;
  int count = 0;
  for (const train::Observation& observation : library.observations) {
    if (cell_of(observation) != cell_of(like)) continue;
    for (const train::Trial& trial : observation.trials) {
      if (trial.clip != clip) continue;
      sum_j += double{trial.work_j};
      ++count;
    }
  }
  return sum_j / count;
}

TEST(LookAhead, TakesTheCandidateOfLeastSimulatedCost) {
  LookAheadWorkspace workspace = trained().workspace();
  int better = 0;
  int saved = 0;
  for (const train::Observation& observation : trained().observations) {
    Character character = tests::character_of(trained(), observation.scenario);
    const Character before = character;
    const std::array threats{observation.scenario.threat};
    const LookAheadStatus status = perceive(character, threats, {.candidates = 6}, workspace);
    if (status.status != Status::ok) continue;
    EXPECT_TRUE(status.is_complete);
    EXPECT_EQ(status.tried, status.count);
    EXPECT_EQ(character.clip(), status.candidates[status.chosen].candidate.clip);
    const double chosen_ns = double{status.candidates[status.chosen].cost_ns};
    for (std::size_t i = 0; i < status.count; ++i) {
      const ForeseenCandidate& candidate = status.candidates[i];
      const double cost = whole_cost_ns(before, threats, candidate.candidate.clip);
      EXPECT_LE(chosen_ns, cost * (1 + 1e-6));
      if (candidate.foreseen == Foreseen::costlier || candidate.foreseen == Foreseen::cut) {
        EXPECT_LE(candidate.cost_ns, cost * (1 + kHitTolerance));
        ++saved;
      } else {
        EXPECT_NEAR(double{candidate.cost_ns}, cost, 1e-5 * cost);
      }
    }
    better += status.chosen > 0;
  }
  EXPECT_GT(better, 10);
  EXPECT_GT(saved, 50);
}

TEST(LookAhead, WorkFromAnotherStanceIsTheMeanOfWhatWasMeasuredThere) {
  const tests::TrainedLibrary& library = tests::trained_with_guard();
  LookAheadWorkspace workspace = library.workspace();
  int compared = 0;
  for (const train::Observation& observation : library.observations) {
    if (!begins_in_guard(observation)) continue;
    Character character = tests::character_of(library, observation.scenario);
    const LookAheadStatus status =
        perceive(character, {observation.scenario, 0}, {.candidates = 8}, workspace);
    ASSERT_EQ(status.status, Status::ok);
    for (std::size_t i = 0; i < status.count; ++i) {
      const double expected_j =
          mean_work_j(library, observation, status.candidates[i].candidate.clip);
      EXPECT_NEAR(double{status.candidates[i].work_j}, expected_j, 1e-3 * (1 + expected_j));
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(LookAhead, FromAnotherStanceItChoosesNoWorseThanTheSelectorAlone) {
  const tests::TrainedLibrary& library = tests::trained_with_guard();
  LookAheadWorkspace workspace = library.workspace();
  const train::CostModel model = train::make_cost_model(make_store_header(library.setup),
                                                        train::vulnerability_profiles()[0], 0.5);
  double alone_ns = 0;
  double looking_ns = 0;
  double best_ns = 0;
  int tested = 0;
  for (const train::Observation& observation : library.simulated({400, 300})) {
    if (!begins_in_guard(observation)) continue;
    const std::vector<double> costs_ns = train::costs_of(observation.trials, 0, model);
    const auto cost_of = [&](int clip) { return costs_ns[train::trial_of(observation, clip)]; };
    Character character = tests::character_of(library, observation.scenario);
    const LookAheadStatus status =
        perceive(character, {observation.scenario, 0}, {.candidates = 8}, workspace);
    ASSERT_EQ(status.status, Status::ok);
    alone_ns += cost_of(status.candidates[0].candidate.clip);
    looking_ns += cost_of(status.candidates[status.chosen].candidate.clip);
    best_ns += *std::ranges::min_element(costs_ns);
    ++tested;
  }
  EXPECT_GT(tested, 100);
  EXPECT_LT(looking_ns - best_ns, 0.75 * (alone_ns - best_ns));
}

TEST(LookAhead, FromAStanceWhoseWorkIsNotKnownItAnswersAsPerceiveDoes) {
  const tests::TrainedLibrary idle_only(200, 0.5, tests::with_guard(scenes::synthetic_library()));
  LookAheadWorkspace workspace = idle_only.workspace();
  runtime::Workspace selection;
  selection.reserve_memory(idle_only.library.selection_bytes());
  int changed_from_idle = 0;
  for (const train::Observation& observation : idle_only.observations) {
    features::Scenario scenario = observation.scenario;
    const std::array threats{scenario.threat};
    Character idle = tests::character_of(idle_only, scenario);
    changed_from_idle += perceive(idle, threats, {.candidates = 8}, workspace).chosen != 0 ? 1 : 0;
    scenario.state.stance = 1;
    Character looking = tests::character_of(idle_only, scenario);
    Character plain = looking;
    const Status expected = plain.perceive(scenario.threat, selection);
    const LookAheadStatus status = perceive(looking, threats, {.candidates = 8}, workspace);
    EXPECT_EQ(status.status, expected);
    EXPECT_EQ(status.tried, 0U);
    EXPECT_TRUE(move_alike(looking, plain)) << "scenario " << observation.number;
  }
  EXPECT_GT(changed_from_idle, 20) << "what looking ahead would change is not tested";
}

TEST(LookAhead, OneCandidateAnswersAsPerceiveDoes) {
  LookAheadWorkspace workspace = trained().workspace();
  runtime::Workspace selection;
  selection.reserve_memory(trained().library.selection_bytes());
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const features::Scenario& scenario = trained().observations[seed].scenario;
    Character looking = tests::character_of(trained(), scenario);
    looking.limit_perception(runtime::human_limits(), seed);
    Character plain = looking;
    const Status expected = plain.perceive(scenario.threat, selection);
    const std::array threats{scenario.threat};
    EXPECT_EQ(perceive(looking, threats, {.candidates = 1}, workspace).status, expected);
    EXPECT_TRUE(move_alike(looking, plain)) << "scenario " << seed;
  }
}

TEST(LookAhead, SpreadOverFramesItGivesTheSameAnswer) {
  LookAheadWorkspace workspace = trained().workspace();
  // A clock that goes on by 1 us per look: a frame of 3 us tries one candidate or two.
  double now_us = 0;
  Budget small{.us = 3,
               .now_us = [](void* clock) { return *static_cast<double*>(clock) += 1; },
               .clock = &now_us};
  int spread = 0;
  for (const train::Observation& observation : trained().observations) {
    if (observation.scenario.time_to_impact_s < 0.9F) continue;
    Character at_once = tests::character_of(trained(), observation.scenario);
    Character later = at_once;
    const std::array threats{observation.scenario.threat};
    const LookAheadStatus expected = perceive(at_once, threats, {.candidates = 5}, workspace);
    Search search(trained().library);
    const Status begun = search.begin(later, threats, 5, workspace);
    ASSERT_EQ(begun, expected.status);
    int frames = 0;
    for (; search.is_open(); ++frames) {
      ASSERT_EQ(search.update(later, kFrame_s, small, workspace), Status::ok);
      at_once.update(kFrame_s);
    }
    if (!search.status().is_complete) continue;  // the best had to begin
    EXPECT_EQ(search.status().chosen, expected.chosen);
    EXPECT_EQ(later.clip(), at_once.clip());
    EXPECT_NEAR(later.time_to_impact_s(), at_once.time_to_impact_s(), 1e-5F);
    spread += frames > 1;
    for (int frame = 0; frame < 90; ++frame) {
      EXPECT_LT((later.pose().root_position - at_once.pose().root_position).norm(), 1e-3F);
      later.update(kFrame_s);
      at_once.update(kFrame_s);
    }
  }
  EXPECT_GT(spread, 5);
}

TEST(LookAhead, ASearchThatTakesTooLongAnswersBeforeTheBestHasToMove) {
  LookAheadWorkspace workspace = trained().workspace();
  double now_us = 0;
  const Budget tiny{.us = 3,
                    .now_us = [](void* clock) { return *static_cast<double*>(clock) += 1; },
                    .clock = &now_us};
  for (const train::Observation& observation : trained().observations) {
    Character character = tests::character_of(trained(), observation.scenario);
    const std::array threats{observation.scenario.threat};
    Search search(trained().library);
    if (search.begin(character, threats, 16, workspace) != Status::ok) continue;
    while (search.is_open()) search.update(character, kFrame_s, tiny, workspace);
    EXPECT_GT(character.time_to_impact_s(), 0);
    EXPECT_LE(character.response_time_s(), kFrame_s * 1.5F);
  }
}

TEST(LookAhead, SeveralThreatsAreAnsweredByTheClipOfLeastSummedCost) {
  LookAheadWorkspace workspace = trained().workspace();
  int several = 0;
  for (std::size_t i = 0; i + 1 < trained().observations.size(); i += 2) {
    const features::Scenario& first = trained().observations[i].scenario;
    Character character = tests::character_of(trained(), first);
    const Character before = character;
    const std::array threats{first.threat, trained().observations[i + 1].scenario.threat};
    const LookAheadStatus status = perceive(character, threats, {.candidates = 8}, workspace);
    if (status.threats < 2) continue;
    ++several;
    const double chosen_ns =
        whole_cost_ns(before, threats, status.candidates[status.chosen].candidate.clip);
    for (std::size_t k = 0; k < status.count; ++k)
      EXPECT_LE(chosen_ns,
                whole_cost_ns(before, threats, status.candidates[k].candidate.clip) * (1 + 1e-5));
  }
  EXPECT_GT(several, 10);
}

TEST(LookAhead, AllocatesNothingAndItsWorkspaceIsSmall) {
  ASSERT_TRUE(trained().library.is_loaded());  // made before memory is measured
  const struct mallinfo2 before = mallinfo2();
  LookAheadWorkspace workspace = trained().workspace();
  const struct mallinfo2 after = mallinfo2();
  EXPECT_LE(after.uordblks + after.hblkhd, before.uordblks + before.hblkhd + 256 * 1024);
  for (const train::Observation& observation : trained().observations) {
    Character character = tests::character_of(trained(), observation.scenario);
    const std::array threats{observation.scenario.threat, observation.scenario.threat};
    const std::size_t allocations = tests::allocation_count();
    perceive(character, threats, {.candidates = 16}, workspace);
    EXPECT_EQ(tests::allocation_count(), allocations);
  }
}

TEST(LookAhead, ThreadsWithWorkspacesOfTheirOwnGiveTheSameAnswers) {
  const auto answers = [] {
    LookAheadWorkspace workspace = trained().workspace();
    std::vector<std::pair<int, float>> found;
    for (const train::Observation& observation : trained().observations) {
      Character character = tests::character_of(trained(), observation.scenario);
      const std::array threats{observation.scenario.threat};
      const LookAheadStatus status = perceive(character, threats, {}, workspace);
      if (status.status == Status::ok)
        found.emplace_back(character.clip(), status.candidates[status.chosen].cost_ns);
    }
    return found;
  };
  const auto alone = answers();
  std::vector<std::pair<int, float>> first;
  std::vector<std::pair<int, float>> second;
  std::thread one([&] { first = answers(); });
  std::thread other([&] { second = answers(); });
  one.join();
  other.join();
  EXPECT_GT(alone.size(), 50U);
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

}  // namespace
}  // namespace flinch::lookahead
