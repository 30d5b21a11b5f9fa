// SPDX-License-Identifier: MIT
// Prints the tables of docs/evolving.md, and its picture.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "database/author/authored_library.h"
#include "database/export/filmstrip.h"
#include "database/files/library_writer.h"
#include "evolve/run/pose_evolution.h"
#include "motion/default_character.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "tests/bench/evolve_search.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"

namespace flinch::evolve {
namespace {

int thread_count() {
  return static_cast<int>(std::thread::hardware_concurrency());
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
  const double begin_s = bench::process_cpu_s();
  const PoseTrial trial(study.library.character, study.library.idle_clip().motion, trained);
  PoseEvolution run;
  run.genetic = study.genetic;
  run.threads = thread_count();
  Evolution evolution;
  evolve_poses(trial, run, evolution);
  outcome.cpu = bench::process_cpu_s() - begin_s;
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

/// Looks at balls that are uniform in the grid's square: those of its cells with a jitter of half
/// their distance.
void grid(const Study& study) {
  for (const double degrees : {-30.0, 0.0, 30.0}) {
    const TrialOptions options = study.options(degrees);
    TrialOptions line = options;
    line.grid = {0, 0};
    TrialOptions square = options;
    square.grid.jitter_m = options.grid.spacing_m / 2;
    const Outcome with = evolve_once(study, options, square);
    const Outcome without = evolve_once(study, line, square);
    print_row("with grid", degrees, with);
    print_row("without grid", degrees, without);
    std::printf("unseen over trained: %.2f with grid, %.2f without; without over with: %.2f\n",
                with.pain_ns / with.grid_ns, without.pain_ns / without.grid_ns,
                without.pain_ns / with.pain_ns);
  }
}

void styles(const Study& study) {
  for (const Style style : kStyles)
    for (const double degrees : {0.0, 30.0}) {
      const TrialOptions options = study.options(degrees, style);
      print_row(std::string(name_of(style)).c_str(), degrees, evolve_once(study, options, options));
    }
}

/// A whole run, and how fast it tests poses beside the reference simulation.
void speed(const Study& study) {
  const TrialOptions options = study.options(30);
  const double begin_s = bench::clock_s(CLOCK_MONOTONIC);
  const Outcome o = evolve_once(study, options, options);
  const double wall_s = bench::clock_s(CLOCK_MONOTONIC) - begin_s;
  const PoseTrial trial(study.library.character, study.library.idle_clip().motion, options);
  const Chromosome pose(pose_genes().size(), kMaxGene / 3);
  const double before_s = bench::process_cpu_s();
  double encounters = 0;
  for (std::uint64_t draw = 0; draw < 3; ++draw)
    for (const JointFailure failure : kJointFailures) {
      const auto balls = trial.balls(draw);
      encounters += static_cast<double>(trial.simulate_by_reference(pose, failure, balls).size());
    }
  const double reference = encounters / (bench::process_cpu_s() - before_s);
  const double fast = static_cast<double>(o.encounters) / o.cpu;
  std::printf(
      "population %zu: %zu generations, %s, %.1f CPU s, %.1f s on %d threads\n"
      "encounters per CPU s: %.0f, by the reference %.0f, ratio %.1f; peak memory %.0f MiB\n",
      study.genetic.population, o.generations, o.converged ? "converged" : "not converged", o.cpu,
      wall_s, thread_count(), fast, reference, fast / reference, bench::peak_memory_mib());
}

/// A smaller test, so that many seeds can be had: no joint failures, and a shorter tail.
void search(const Study& study, std::size_t budget, std::size_t seeds) {
  TrialOptions options = study.options(30);
  options.fails_joints = false;
  options.tail_s = 0.1;
  TrialOptions turned = options;
  turned.gene_map = GeneMap::full_turn;
  const motion::Motion& idle = study.library.idle_clip().motion;
  print_search({study.library.character, idle, options}, {study.library.character, idle, turned},
               budget, seeds, thread_count());
}

/// Writes a filmstrip of each evolved clip of a library, and a page that shows them.
void gallery(const std::string& library_file, const std::string& folder) {
  const database::ClipLibrary library = database::load_library(library_file);
  const motion::Figure figure = motion::make_figure(library.character);
  std::ofstream page(folder + "/README.md");
  page << "# Evolved clips\n\nFilmstrips of the clips that `flinch evolve` added to the authored "
          "library; mirror images are left out. Rows and arrows are as in [the gallery of authored "
          "clips](../README.md).\n";
  for (const motion::Clip& clip : library.clips) {
    if (clip.kind != "evolved" || !clip.mirrored_from.empty()) continue;
    std::ofstream(folder + "/" + clip.name + ".svg") << database::filmstrip_svg(figure, clip);
    page << "\n## " << clip.name << "\n\n![" << clip.name << "](" << clip.name << ".svg)\n";
  }
}

/// Prints a filmstrip of an evolved clip as SVG.
void picture(const Study& study) {
  const TrialOptions options = study.options(30, Style::hands);
  const motion::Clip& idle = study.library.idle_clip();
  const PoseTrial trial(study.library.character, idle.motion, options);
  PoseEvolution run;
  run.genetic = study.genetic;
  run.threads = thread_count();
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
  return flinch::bench::study_main(
      count, arguments,
      {"evolve_study angles|failures|grid|styles|speed|picture [POPULATION] [GENERATIONS], or "
       "evolve_study search BUDGET SEEDS, or evolve_study gallery LIBRARY FOLDER",
       1, 3},
      [](const flinch::bench::StudyArguments& given) {
        const std::string& what = given.text(0);
        if (what == "gallery") {
          gallery(given.text(1), given.text(2));
          return;
        }
        Study study;
        if (what == "search") {
          search(study, given.number<std::size_t>(1), given.number<std::size_t>(2));
          return;
        }
        study.genetic.population = given.number_or(1, study.genetic.population);
        study.genetic.max_generations = given.number_or(2, study.genetic.max_generations);
        if (what == "picture") picture(study);
        if (what == "speed") speed(study);
        if (what != "angles" && what != "failures" && what != "grid" && what != "styles") return;
        print_head();
        if (what == "angles") angles(study, true);
        if (what == "failures") angles(study, false);
        if (what == "grid") grid(study);
        if (what == "styles") styles(study);
        std::printf("peak memory %.0f MiB\n", flinch::bench::peak_memory_mib());
      });
}
