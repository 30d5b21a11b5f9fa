// SPDX-License-Identifier: MIT
// Throws balls that lead a character in each stance of a selector's library, and prints how often
// it perceives the right target, what its selector's choices protect and what the pose rules do,
// beside the same balls at the idle character; then what a response costs, and how far feet slide
// in 400 responses from each stance that has cycles:
//
//     stance_study SELECTOR [CASES]
//
// CASES are those of each stance.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "features/random.h"
#include "lookahead/oracle/oracle.h"
#include "runtime/response/prepared_library.h"
#include "runtime/workspace.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "tests/runtime/response/foot_slide.h"
#include "train/evaluate/evaluation.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch {
namespace {

constexpr std::uint64_t kSeed = 1;

/// What is drawn of a case, whatever the stance.
struct Case {
  features::ThreatDescription description;
  Eigen::Vector3f offset;  ///< of the aim from the target's centre, m
  double phase = 0;        ///< of the stance, 0 to 1
  double elevation = 0;    ///< of what is possible, 0 to 1
};

// As the default distribution draws them (docs/program.md).
Case draw(std::uint64_t number) {
  features::Random random(kSeed, features::RandomStream::scenario, number);
  Case drawn;
  drawn.description.target = static_cast<motion::Target>(random.index(4));
  drawn.description.azimuth = static_cast<float>(random.uniform(-M_PI, M_PI));
  drawn.description.speed_mps = static_cast<float>(random.uniform(12, 30));
  drawn.description.time_to_impact_s = static_cast<float>(random.uniform(0.25, 1.2));
  for (float& coordinate : drawn.offset)
    coordinate = static_cast<float>(random.uniform(-0.05, 0.05));
  drawn.phase = random.uniform();
  drawn.elevation = random.uniform();
  return drawn;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// What came out for one stance.
struct Result {
  int cases = 0;
  int right = 0;
  int missed = 0;
  int right_animated = 0;           ///< of a character that the game animates (set_pose)
  int right_held = 0;               ///< if it were taken to hold its pose
  std::vector<double> going_on_ns;  ///< costs, of every case
  std::vector<double> chosen_ns;
  std::vector<double> ruled_ns;
  std::vector<double> best_ns;
};

features::Threat thrown(const runtime::PreparedLibrary& library,
                        const features::CharacterState& state, const Case& drawn) {
  features::ThreatDescription description = drawn.description;
  const auto centres =
      features::predict_character(library.figure_in(state), state, description.time_to_impact_s)
          .target_centres;
  const Eigen::Vector3f aim = centres[description.target] + drawn.offset;
  constexpr double kHighest = M_PI / 4;
  const double lowest =
      std::max(-M_PI / 18, train::min_feasible_elevation(
                               double{description.speed_mps}, double{description.time_to_impact_s},
                               double{description.radius}, double{aim.z()}));
  description.elevation =
      static_cast<float>(lowest + drawn.elevation * std::max(kHighest - lowest, 0.0));
  return features::threat_from_description(description, aim, 0);
}

class Study {
 public:
  explicit Study(const std::string& selector) {
    if (library_.load(selector) != database::LoadStatus::ok)
      throw Error(selector, "is not a selector that can be loaded");
    workspace_.reserve_memory(library_.selection_bytes());
    oracle_.emplace(library_);
  }

  const runtime::Library& library() const { return library_; }

  Result run(int stance, int cases) {
    Result result;
    for (int i = 0; i < cases; ++i) add(draw(static_cast<std::uint64_t>(i)), stance, result);
    return result;
  }

 private:
  void add(const Case& drawn, int stance, Result& result) {
    const runtime::PreparedLibrary& prepared = library_.prepared();
    features::CharacterState state;
    state.stance = stance;
    const motion::Loop& loop = prepared.stance_of(state).loop;
    state.idle_time_s = static_cast<float>(drawn.phase) * loop.period_s();
    const features::Threat threat = thrown(prepared, state, drawn);
    runtime::Character character(library_);
    character.place(state.position, state.facing, state.idle_time_s, stance);
    runtime::Perception seen;
    const runtime::Status status = character.notice(threat, seen);
    const runtime::Perception truth{
        {threat, drawn.description.target, drawn.description.time_to_impact_s, state}, 0};
    add_animated(loop, truth, result);
    ++result.cases;
    result.missed += status != runtime::Status::ok ? 1 : 0;
    result.right +=
        status == runtime::Status::ok && seen.scenario.target == truth.scenario.target ? 1 : 0;
    add_costs(character, truth, status == runtime::Status::ok ? &seen : nullptr, result);
  }

  /// The same motion as a game that animates the character tells it, frame by frame.
  void add_animated(const motion::Loop& loop, const runtime::Perception& truth, Result& result) {
    constexpr float kFrame_s = 1.0F / 60;
    const features::Scenario& scenario = truth.scenario;
    const auto pose_at = [&](float time_s) { return idle_pose(loop, scenario.state, time_s); };
    runtime::Character character(library_);
    for (int frame = -60; frame <= 0; ++frame) {
      const float time_s = static_cast<float>(frame) * kFrame_s;
      character.set_pose(pose_at(time_s - kFrame_s), pose_at(time_s), kFrame_s);
    }
    runtime::Perception seen;
    if (character.notice(scenario.threat, seen) == runtime::Status::ok &&
        seen.scenario.target == scenario.target)
      ++result.right_animated;
    const features::PredictedImpact held =
        features::predict_impact(scenario.threat, library_.prepared().figure(), pose_at(0));
    if (held.outcome == features::Outcome::impact && held.aimed_at == scenario.target)
      ++result.right_held;
  }

  void add_costs(const runtime::Character& character, const runtime::Perception& truth,
                 const runtime::Perception* seen, Result& result) {
    const int idle = library_.clip_library().idle;
    const std::vector<lookahead::ClipTrial> trials =
        oracle_->try_all(character, truth, truth.scenario.threat);
    int chosen = idle;
    if (seen != nullptr) {
      std::array<models::Candidate, 1> best{};
      std::size_t count = 0;
      character.rank(*seen, workspace_, best, count);
      chosen = best[0].clip;
    }
    const auto cost_of = [&](int clip) {
      const auto trial = std::ranges::find(trials, clip, &lookahead::ClipTrial::clip);
      if (trial != trials.end()) return trial->cost_ns;
      return oracle_->try_clip(character, truth, truth.scenario.threat, clip)->cost_ns;
    };
    result.going_on_ns.push_back(cost_of(idle));
    result.chosen_ns.push_back(cost_of(chosen));
    const runtime::Response ruled = character.plan_brace(seen != nullptr ? *seen : truth);
    result.ruled_ns.push_back(
        seen != nullptr ? oracle_->try_response(ruled, truth, truth.scenario.threat).cost_ns
                        : cost_of(idle));
    result.best_ns.push_back(trials[lookahead::best_of(trials)].cost_ns);
  }

  runtime::Library library_;
  runtime::Workspace workspace_;
  std::optional<lookahead::Oracle> oracle_;
};

/// The protection of these choices, as text.
std::string protection(const Result& result, const std::vector<double>& cost_ns) {
  const auto resamples = train::draw_resamples(cost_ns.size(), train::kResampleCount, kSeed);
  const auto found = train::estimate(
      train::protection_of, train::resampled_mean(result.going_on_ns, resamples),
      train::resampled_mean(cost_ns, resamples), train::resampled_mean(result.best_ns, resamples));
  char text[64];
  std::snprintf(text, sizeof text, "%.3f (%.3f to %.3f)", found.value, found.interval.low,
                found.interval.high);
  return text;
}

void print(const std::string& name, const Result& result) {
  const auto share = [&](int count) { return 100.0 * count / result.cases; };
  std::printf(
      "| %s | %d | %.1f %% | %d | %.1f %% | %.1f %% | %.2f | %.2f | %.2f | %.2f | %s | %s |\n",
      name.c_str(), result.cases, share(result.right), result.missed, share(result.right_animated),
      share(result.right_held), mean(result.going_on_ns), mean(result.chosen_ns),
      mean(result.ruled_ns), mean(result.best_ns), protection(result, result.chosen_ns).c_str(),
      protection(result, result.ruled_ns).c_str());
}

/// CPU time of planning a response and of a frame of it, us.
struct Times {
  double plan_us = 0;
  double frame_us = 0;
};

Times times_of(const runtime::PreparedLibrary& library, int stance) {
  constexpr int kRounds = 20;
  constexpr float kFrame_s = 1.0F / 60;
  double plan_s = 0;
  double frames_s = 0;
  int plans = 0;
  int frames = 0;
  float sum = 0;
  for (int round = 0; round < kRounds; ++round) {
    features::Random random(kSeed, features::RandomStream::scenario, static_cast<unsigned>(round));
    features::CharacterState state;
    state.stance = stance;
    state.idle_time_s = static_cast<float>(random.uniform(0, 2));
    const auto impact_s = static_cast<float>(random.uniform(0.4, 1.2));
    for (std::size_t clip = 0; clip < library.library->clips.size(); ++clip) {
      if (!library.library->clips[clip].annotation) continue;
      const double begin_s = bench::thread_cpu_s();
      const runtime::Response response =
          runtime::make_response(library, state, static_cast<int>(clip), impact_s);
      const double planned_s = bench::thread_cpu_s();
      const float end_s = runtime::duration_s(response);
      for (float t = 0; t < end_s; t += kFrame_s, ++frames)
        sum += runtime::pose_at(response, t).root_position.x();
      frames_s += bench::thread_cpu_s() - planned_s;
      plan_s += planned_s - begin_s;
      ++plans;
    }
  }
  if (!std::isfinite(sum)) throw Error("", "a pose is not finite");
  return {1e6 * plan_s / plans, 1e6 * frames_s / frames};
}

void print_times(const runtime::Library& library) {
  std::printf(
      "\n| stance | plan, us | of idle's | frame, us | of idle's |\n"
      "| --- | ---: | ---: | ---: | ---: |\n");
  Times idle;
  int stance = 0;
  for (const int clip : database::stance_clips(library.clip_library())) {
    const Times times = times_of(library.prepared(), stance);
    if (stance++ == 0) idle = times;
    std::printf("| %s | %.1f | %.2f | %.2f | %.2f |\n",
                library.clip_library().clip(clip).name.c_str(), times.plan_us,
                times.plan_us / idle.plan_us, times.frame_us, times.frame_us / idle.frame_us);
  }
}

void print_slides(const runtime::PreparedLibrary& library) {
  constexpr int kResponses = 400;
  std::printf(
      "\n| stance | slide of its own, mm | of responses: median | 95 %% | worst |\n"
      "| --- | ---: | ---: | ---: | ---: |\n");
  for (std::size_t stance = 0; stance < library.stances.size(); ++stance) {
    const motion::Loop& loop = library.stances[stance].loop;
    if (!loop.has_cycles()) continue;
    features::CharacterState state;
    state.stance = static_cast<int>(stance);
    const float own_m = tests::longest_slide(library, state, 3 * loop.period_s()).way_m;
    std::vector<float> slides_m;
    for (int i = 0; i < kResponses; ++i) {
      features::Random random(kSeed, features::RandomStream::scenario, static_cast<unsigned>(i));
      std::size_t clip = 0;
      do clip = random.index(library.library->clips.size());
      while (!library.library->clips[clip].annotation);
      state.idle_time_s = static_cast<float>(random.uniform(0, double{loop.period_s()}));
      const auto impact_s = static_cast<float>(random.uniform(0.25, 1.2));
      const runtime::Response response =
          runtime::make_response(library, state, static_cast<int>(clip), impact_s);
      slides_m.push_back(
          tests::longest_slide(response, 0, runtime::duration_s(response) + 1).way_m);
    }
    std::ranges::sort(slides_m);
    const auto at = [&](double share) {
      return 1e3 * double{slides_m[static_cast<std::size_t>(share * (kResponses - 1))]};
    };
    std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n",
                library.clip(library.stances[stance].clip).name.c_str(), 1e3 * double{own_m},
                at(0.5), at(0.95), at(1));
  }
}

void run(const bench::StudyArguments& arguments) {
  Study study(arguments.text(0));
  const auto cases = arguments.number_or<int>(1, 50);
  std::printf(
      "| stance | cases | right target | unseen | told by poses | pose held | going on, N s "
      "| selector | rules | oracle | protection | of the rules |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  const database::ClipLibrary& clips = study.library().clip_library();
  Result moving;
  int stance = 0;
  for (const int clip : database::stance_clips(clips)) {
    const Result result = study.run(stance, cases);
    print(clips.clip(clip).name, result);
    if (stance++ == 0) continue;
    moving.cases += result.cases;
    moving.right += result.right;
    moving.missed += result.missed;
    moving.right_animated += result.right_animated;
    moving.right_held += result.right_held;
    for (const auto costs :
         {&Result::going_on_ns, &Result::chosen_ns, &Result::ruled_ns, &Result::best_ns})
      (moving.*costs).insert((moving.*costs).end(), (result.*costs).begin(), (result.*costs).end());
  }
  if (moving.cases > 0) print("all but the first", moving);
  print_times(study.library());
  print_slides(study.library().prepared());
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"stance_study SELECTOR [CASES]", 1, 2},
                                   flinch::run);
}
