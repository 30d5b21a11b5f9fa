// SPDX-License-Identifier: MIT
// Prints the tables of docs/evolving.md, and its picture.
// Usage: evolve_study [POPULATION] [GENERATIONS] [angles|failures|grid|styles|picture]
#include <thread>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "database/author/authored_library.h"
#include "database/export/filmstrip.h"
#include "evolve/run/pose_evolution.h"
#include "motion/default_character.h"
#include "motion/error.h"
#include "motion/rotation.h"

namespace flinch::evolve {
namespace {

double cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Study {
  database::ClipLibrary library = database::authored_library(motion::default_character());
  GeneticOptions genetic;

  TrialOptions options(double degrees, Style style = Style::free) const {
    TrialOptions made;
    made.style = style;
    made.thrown = throw_at(library.character, library.idle_clip().motion, motion::Target::head,
                           motion::radians(degrees), 0, 25, 0.5);
    return made;
  }
};

/// What an evolved pose does to balls that no generation met.
struct Outcome {
  double pain_ns = 0;  ///< of its clip
  double idle_ns = 0;
  bool left_protects = false;  ///< with the right shoulder failed
  bool right_protects = false;
  double on_hands = 0;    ///< share of first contacts
  double distance_m = 0;  ///< mean, of first contacts from the aim
  double grid_ns = 0;     ///< pain of the pose on balls of the trained grid
  std::size_t generations = 0;
  bool converged = false;
  double cpu = 0;  ///< s
  std::size_t encounters = 0;
};

double pain_of_failure(const PoseTrial& trial, const Chromosome& pose, JointFailure failure) {
  double sum = 0;
  constexpr int kDraws = 6;
  for (std::uint64_t draw = 0; draw < kDraws; ++draw) {
    const auto balls = trial.balls(kUnseenDraw + draw);
    sum += trial.mean_pain(trial.simulate(pose, failure, balls)) / kDraws;
  }
  return sum;
}

void look_at_first_contacts(const PoseTrial& trial, const Chromosome& pose, Outcome& outcome) {
  double contacts = 0;
  double hands = 0;
  double distance = 0;
  for (std::uint64_t draw = 0; draw < 12; ++draw) {
    for (const sim::SimulationResult& result :
         trial.simulate(pose, JointFailure::none, trial.balls(kUnseenDraw + draw))) {
      if (result.places.empty()) continue;
      const sim::PlacedImpulse& first = result.places.front();
      contacts += 1;
      hands += name_of(first.body).ends_with("hand") ? 1 : 0;
      distance += (first.point_world - trial.options().thrown.aim).norm();
    }
  }
  outcome.on_hands = contacts > 0 ? hands / contacts : 0;
  outcome.distance_m = contacts > 0 ? distance / contacts : 0;
}

/// Evolves with `trained`, and looks at the pose with all failures and the whole grid.
Outcome evolve_once(const Study& study, const TrialOptions& trained, const TrialOptions& looked) {
  Outcome outcome;
  const double begin_s = cpu_s();
  const PoseTrial trial(study.library.character, study.library.idle_clip().motion, trained);
  PoseEvolution run;
  run.genetic = study.genetic;
  run.threads = static_cast<int>(std::thread::hardware_concurrency());
  Evolution evolution;
  evolve_poses(trial, run, evolution);
  outcome.cpu = cpu_s() - begin_s;
  outcome.generations = evolution.history.size();
  outcome.converged = has_converged(run.genetic, evolution.history);
  outcome.encounters = evolution.history.size() * run.genetic.population *
                       (trained.fails_joints ? kJointFailures.size() : 1) * kGridCells;
  const motion::Clip& idle = study.library.idle_clip();
  const EvolvedPose pose =
      chosen_pose(trial, run, evolution, idle, {"evolved", motion::Target::head, 0, "study"});
  const PoseTrial look(study.library.character, idle.motion, looked);
  outcome.idle_ns = look.idle_pain();
  outcome.pain_ns = clip_pain(look, idle, pose.clip.clip, kUnseenDraw, 112);  // 1008 balls
  outcome.grid_ns = clip_pain(trial, idle, pose.clip.clip, kUnseenDraw, 12);
  const double none_left = pain_of_failure(look, pose.chromosome, JointFailure::both_shoulders);
  outcome.left_protects =
      pain_of_failure(look, pose.chromosome, JointFailure::right_shoulder) < 0.5 * none_left;
  outcome.right_protects =
      pain_of_failure(look, pose.chromosome, JointFailure::left_shoulder) < 0.5 * none_left;
  look_at_first_contacts(trial, pose.chromosome, outcome);
  return outcome;
}

void print_row(const char* name, double degrees, const Outcome& o) {
  std::printf("| %s | %.0f | %zu%s | %.1f | %.1f | %.2f | %s%s | %.0f | %.2f | %.0f | %.0f |\n",
              name, degrees, o.generations, o.converged ? "" : "+", o.idle_ns, o.pain_ns,
              o.pain_ns / o.idle_ns, o.left_protects ? "left " : "",
              o.right_protects ? "right" : "", 100 * o.on_hands, o.distance_m, o.cpu,
              static_cast<double>(o.encounters) / o.cpu);
  std::fflush(stdout);
}

constexpr std::array kAngles{-60.0, -45.0, -30.0, -15.0, 0.0, 15.0, 30.0, 45.0, 60.0};

void print_head() {
  std::printf(
      "| run | azimuth | generations | idle, N s | pain, N s | share | protects alone | first "
      "contact on hands, %% | its distance, m | CPU s | encounters per CPU s |\n");
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void angles(const Study& study, bool fails_joints) {
  std::vector<double> shares;
  int both = 0;
  for (const double degrees : kAngles) {
    TrialOptions options = study.options(degrees);
    TrialOptions trained = options;
    trained.fails_joints = fails_joints;
    const Outcome o = evolve_once(study, trained, options);
    print_row(fails_joints ? "free" : "without failures", degrees, o);
    shares.push_back(o.pain_ns / o.idle_ns);
    both += o.left_protects && o.right_protects ? 1 : 0;
  }
  std::printf("median share %.3f, both arms at %d of 9 angles\n", median(shares), both);
}

void grid(const Study& study) {
  for (const double degrees : {-30.0, 0.0, 30.0}) {
    TrialOptions options = study.options(degrees);
    TrialOptions trained = options;
    trained.grid = {0, 0};
    const Outcome with = evolve_once(study, options, options);
    const Outcome without = evolve_once(study, trained, options);
    print_row("with grid", degrees, with);
    print_row("without grid", degrees, without);
  }
}

void styles(const Study& study) {
  for (const Style style : kStyles)
    for (const double degrees : {0.0, 30.0}) {
      const TrialOptions options = study.options(degrees, style);
      print_row(std::string(name_of(style)).c_str(), degrees, evolve_once(study, options, options));
    }
}

/// Prints a filmstrip of an evolved clip as SVG.
void picture(const Study& study) {
  const TrialOptions options = study.options(30, Style::hands);
  const motion::Clip& idle = study.library.idle_clip();
  const PoseTrial trial(study.library.character, idle.motion, options);
  PoseEvolution run;
  run.genetic = study.genetic;
  run.threads = static_cast<int>(std::thread::hardware_concurrency());
  Evolution evolution;
  evolve_poses(trial, run, evolution);
  const EvolvedPose pose =
      chosen_pose(trial, run, evolution, idle,
                  {"evolved_head_30_hands", motion::Target::head, motion::radians(30.0), ""});
  std::printf("%s", database::filmstrip_svg(trial.figure(), pose.clip.clip).c_str());
}

}  // namespace
}  // namespace flinch::evolve

int main(int count, char** arguments) {
  using namespace flinch::evolve;
  Study study;
  if (count > 1) study.genetic.population = std::stoul(arguments[1]);
  if (count > 2) study.genetic.max_generations = std::stoul(arguments[2]);
  const std::string what = count > 3 ? arguments[3] : "angles";
  if (what == "picture") {
    picture(study);
    return 0;
  }
  print_head();
  if (what == "angles") angles(study, true);
  if (what == "failures") angles(study, false);
  if (what == "grid") grid(study);
  if (what == "styles") styles(study);
}
