// SPDX-License-Identifier: MIT
// Prints the tables of docs/reaction.md:
//
//     reaction_study [LIBRARY]
//
// over the procedural motions and, if a library is given, each of its clips.
#include <algorithm>
#include <cstdio>

#include "database/files/library_writer.h"
#include "motion/rotation.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "tests/reaction/reaction_scenes.h"
#include "tests/sim/tumble.h"

namespace flinch {
namespace {

using bench::quantile;
using motion::Role;
using scenes::kFrame_s;
using scenes::ReactionCase;

constexpr std::size_t kCases = 400;
constexpr double kDuration_s = 0.9;

struct Study {
  motion::Physique character;
  std::vector<scenes::NamedMotion> motions;
  std::shared_ptr<const sim::FigureModel> plan;
};

/// Largest distance of a joint between two poses, mm.
double distance_mm(const Study& study, const motion::Pose& first, const motion::Pose& second) {
  const auto a = forward_kinematics(study.character.skeleton, first);
  const auto b = forward_kinematics(study.character.skeleton, second);
  float most = 0;
  for (Role role : motion::kRoles) {
    most = std::max(most, (a.position[role] - b.position[role]).norm());
  }
  return 1e3 * static_cast<double>(most);
}

struct Played {
  std::vector<motion::Pose> poses;
  std::vector<double> frames_us;  // of the frames that simulate
  bool knocked_over = false;
  double fastest_turn = 0;  // of the pelvis while the figure falls, rad/s
  motion::Body most_hit = motion::Body::pelvis;
};

Played play(const Study& study, const ReactionCase& reaction_case, double frame_s) {
  reaction::Reaction reaction(study.plan);
  scenes::begin(reaction, reaction_case);
  Played played;
  played.poses.push_back(reaction.pose());
  for (int k = 1; k * frame_s < kDuration_s + 1e-9; ++k) {
    const motion::Pose wanted =
        scenes::pose_at(*reaction_case.motion, reaction_case.begin_s + k * frame_s);
    const double begin_s = bench::thread_cpu_s();
    reaction.advance(frame_s, wanted, wanted);
    if (reaction.phase() < reaction::ReactionPhase::returning) {
      played.frames_us.push_back(1e6 * (bench::thread_cpu_s() - begin_s));
    }
    played.poses.push_back(reaction.pose());
    if (reaction.phase() != reaction::ReactionPhase::knocked_over) continue;
    played.knocked_over = true;
    const Eigen::Quaternionf turn = played.poses.rbegin()[1].rotation[Role::pelvis].conjugate() *
                                    reaction.pose().rotation[Role::pelvis];
    const double turned = static_cast<double>(motion::rotation_vector(turn).norm());
    played.fastest_turn = std::max(played.fastest_turn, turned / frame_s);
  }
  const auto impulse = reaction.impulse();
  for (motion::Body body : motion::kBodies) {
    if (impulse[body] > impulse[played.most_hit]) played.most_hit = body;
  }
  return played;
}

void print_effect(const Study& study, const std::vector<ReactionCase>& cases) {
  motion::PerTarget<std::vector<double>> off_mm;
  std::vector<double> frames_us;
  for (const ReactionCase& reaction_case : cases) {
    const Played played = play(study, reaction_case, kFrame_s);
    double most = 0;
    for (std::size_t k = 0; k < played.poses.size(); ++k) {
      const double time_s = reaction_case.begin_s + static_cast<double>(k) * kFrame_s;
      most = std::max(most, distance_mm(study, played.poses[k],
                                        scenes::pose_at(*reaction_case.motion, time_s)));
    }
    off_mm[target_of(played.most_hit)].push_back(most);
    frames_us.insert(frames_us.end(), played.frames_us.begin(), played.frames_us.end());
  }
  std::printf("\n### Effect: how far the joint that is farthest is moved, mm\n\n");
  std::printf("| hit most | blows | median | p90 | worst |\n| --- | --- | --- | --- | --- |\n");
  for (const motion::Target target : motion::kTargets) {
    const auto& off = off_mm[target];
    std::printf("| %s | %zu | %.0f | %.0f | %.0f |\n", std::string(name_of(target)).c_str(),
                off.size(), quantile(off, 0.5), quantile(off, 0.9), quantile(off, 1));
  }
  double sum = 0;
  for (double frame_us : frames_us) sum += frame_us;
  std::printf("\n### Cost of a 60 Hz frame that simulates, us of one core\n\n");
  std::printf("| frames | mean | p99 | p99.9 | worst |\n| --- | --- | --- | --- | --- |\n");
  std::printf("| %zu | %.0f | %.0f | %.0f | %.0f |\n", frames_us.size(),
              sum / static_cast<double>(frames_us.size()), quantile(frames_us, 0.99),
              quantile(frames_us, 0.999), quantile(frames_us, 1));
}

/// Compared with 60 Hz frames, at every tenth of a second.
void print_frame_rates(const Study& study, const std::vector<ReactionCase>& cases) {
  std::printf("\n### Frame rate: largest distance of a joint from where 60 Hz has it, mm\n\n");
  std::printf("| rate | median | p90 | p99 | worst |\n| --- | --- | --- | --- | --- |\n");
  for (int a_tenth : {3, 12, 24}) {
    std::vector<double> off_mm;
    for (const ReactionCase& reaction_case : cases) {
      const Played usual = play(study, reaction_case, kFrame_s);
      const Played other = play(study, reaction_case, 0.1 / a_tenth);
      double most = 0;
      for (std::size_t tenth = 1; tenth <= 9; ++tenth) {
        most = std::max(most, distance_mm(study, usual.poses[6 * tenth],
                                          other.poses[static_cast<std::size_t>(a_tenth) * tenth]));
      }
      off_mm.push_back(most);
    }
    std::printf("| %d Hz | %.2f | %.2f | %.2f | %.2f |\n", 10 * a_tenth, quantile(off_mm, 0.5),
                quantile(off_mm, 0.9), quantile(off_mm, 0.99), quantile(off_mm, 1));
  }
}

void print_knock_overs(const Study& study) {
  std::printf(
      "\n### Knocked over, of balls of 8 to 30 m/s, and how fast the pelvis then turns at most, "
      "rad/s\n\n"
      "| ball, kg | share | median | p90 | worst |\n| --- | --- | --- | --- | --- |\n");
  for (double mass_kg : {0.27, 1.0, 2.0, 5.0, 10.0, 20.0}) {
    const auto cases =
        scenes::random_reaction_cases(study.character, study.motions, kCases / 4, 2, mass_kg);
    std::vector<double> turns;
    for (const ReactionCase& reaction_case : cases) {
      const Played played = play(study, reaction_case, kFrame_s);
      if (played.knocked_over) turns.push_back(played.fastest_turn);
    }
    std::printf("| %g | %.0f %% | %.1f | %.1f | %.1f |\n", mass_kg,
                100 * static_cast<double>(turns.size()) / static_cast<double>(cases.size()),
                quantile(turns, 0.5), quantile(turns, 0.9), quantile(turns, 1));
  }
}

/// Angular momentum that a falling figure's joints lose in a second in the air. Poses: at the
/// middle of each motion; turning about each axis.
void print_fall(const Study& study) {
  std::printf("\n### Falling: change of the angular momentum in a second in the air, %%\n\n");
  std::printf("| step | 2 rad/s: median, worst | 5 rad/s | 10 rad/s | 20 rad/s |\n");
  std::printf("| --- | --- | --- | --- | --- |\n");
  for (const double rate_hz : {60.0, 120.0, 180.0, 240.0, 480.0}) {
    std::printf("| 1/%.0f s |", rate_hz);
    for (const double speed : {2.0, 5.0, 10.0, 20.0}) {
      std::vector<double> changes;
      for (const scenes::NamedMotion& motion : study.motions) {
        const motion::Pose pose = motion::sample(motion.motion, motion.motion.duration_s() / 2);
        for (int axis = 0; axis < 3; ++axis) {
          scenes::Tumble tumble(*study.plan, pose, speed * Eigen::Vector3d::Unit(axis));
          const Eigen::Vector3d before = tumble.angular_momentum();
          tumble.run(1, 1 / rate_hz);
          const Eigen::Vector3d change = tumble.angular_momentum() - before;
          changes.push_back(100 * change.norm() / before.norm());
        }
      }
      std::printf(" %.1f, %.1f |", quantile(changes, 0.5), quantile(changes, 1));
    }
    std::printf("\n");
  }
}

void print(const char* title, const Study& study) {
  std::printf("\n## %s: %zu motions\n", title, study.motions.size());
  const auto cases = scenes::random_reaction_cases(study.character, study.motions, kCases, 1);
  print_effect(study, cases);
  print_frame_rates(study, cases);
  print_knock_overs(study);
  print_fall(study);
}

void run(const bench::StudyArguments& arguments) {
  const motion::Physique man = motion::default_character();
  print("Motions by rule",
        {man, scenes::motions_by_rule(man.skeleton), reaction::make_figure_model(man)});
  if (!arguments.has(0)) return;
  const database::ClipLibrary library = database::load_library(arguments.text(0));
  Study study{library.character, {}, reaction::make_figure_model(library.character)};
  for (const motion::Clip& clip : library.clips) study.motions.push_back({clip.name, clip.motion});
  print("The library's clips", study);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"reaction_study [LIBRARY]", 0, 1},
                                   flinch::run);
}
