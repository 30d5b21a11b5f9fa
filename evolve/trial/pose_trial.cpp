// SPDX-License-Identifier: MIT
#include "evolve/trial/pose_trial.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

#include "database/author/evasion.h"
#include "evolve/trial/joint_effort.h"
#include "motion/body_distance.h"
#include "motion/error.h"
#include "motion/interpolation.h"
#include "motion/rotation.h"
#include "sim/ode/ode_simulator.h"
#include "sim/rehearsal/throw_simulator.h"

namespace flinch::evolve {
namespace {

using motion::Body;
using motion::Pose;
using motion::Role;

constexpr double kMinSpeed_mps = 5;
// Equation 4.3's factor is set so that the energy of a guard of both arms is this share of the pain
// of standing still; equation 4.4's so that this share of it is a metre.
constexpr double kEnergyShare = 0.05;
constexpr double kDistanceShare_per_m = 0.3;
constexpr std::uint64_t kIdleDraws = 4;
// A pose that overlaps loses this share of it at once, and more for each metre.
constexpr double kOverlapShare = 0.05;
constexpr double kOverlapShare_per_m = 20;

bool fails(JointFailure failure, Body shoulder) {
  if (failure == JointFailure::both_shoulders) return true;
  return failure == (shoulder == Body::left_upper_arm ? JointFailure::left_shoulder
                                                      : JointFailure::right_shoulder);
}

constexpr std::array kShoulders{Body::left_upper_arm, Body::right_upper_arm};

sim::SimulationOptions simulation_of(const TrialOptions& options, JointFailure failure) {
  sim::SimulationOptions simulation = options.simulation;
  simulation.keeps_places = true;
  simulation.measures_limits = options.limit_weight_per_rads > 0;
  for (const Body shoulder : kShoulders)
    if (options.are_limp && fails(failure, shoulder))
      simulation.limp_joints |= sim::set_of(shoulder);
  if (options.style == Style::hands) {
    for (const Body arm :
         {Body::left_upper_arm, Body::left_forearm, Body::right_upper_arm, Body::right_forearm})
      simulation.ball_meets &= ~sim::set_of(arm);
  }
  return simulation;
}

double distance_sign(Style style) {
  switch (style) {
    case Style::near:
      return 1;
    case Style::far:
      return -1;
    case Style::free:
    case Style::hands:
      break;
  }
  return 0;
}

}  // namespace

std::string_view name_of(Style style) {
  constexpr std::array<std::string_view, 4> kNames{"free", "hands", "near", "far"};
  return kNames[static_cast<std::size_t>(style)];
}

double overlap_depth_m(const motion::Figure& figure, const motion::Pose& pose) {
  constexpr float kClearance_m = 0.005F;
  const motion::JointFrames frames = forward_kinematics(figure.skeleton(), pose);
  float depth = 0;
  const auto add = [&](Body body, const motion::Capsule& capsule) {
    depth += std::max(kClearance_m - distance_between(figure, frames, body, capsule), 0.0F);
  };
  for (const Body part :
       {Body::left_hand, Body::left_forearm, Body::right_hand, Body::right_forearm}) {
    const motion::Capsule capsule = capsule_of(figure, frames, part);
    for (const Body core : motion::kCoreBodies) add(core, capsule);
  }
  for (const Body left : {Body::left_hand, Body::left_forearm}) {
    const motion::Capsule capsule = capsule_of(figure, frames, left);
    for (const Body right : {Body::right_hand, Body::right_forearm}) add(right, capsule);
  }
  return static_cast<double>(depth);
}

AimedThrow throw_at(const motion::Physique& character, const motion::Motion& idle,
                    motion::Target target, double azimuth, double elevation, double speed_mps,
                    double time_to_impact_s) {
  const motion::Pose pose = sample_ping_pong(idle, static_cast<float>(time_to_impact_s));
  const motion::JointFrames frames = forward_kinematics(character.skeleton, pose);
  AimedThrow thrown;
  thrown.aim = target_centre(make_body_model(character), frames, target).cast<double>();
  thrown.azimuth = azimuth;
  thrown.elevation = elevation;
  thrown.speed_mps = speed_mps;
  thrown.time_to_impact_s = time_to_impact_s;
  return thrown;
}

PoseTrial::PoseTrial(const motion::Physique& character, const motion::Motion& idle,
                     const TrialOptions& options)
    : figure_(motion::make_figure(character)),
      idle_(idle),
      options_(options),
      start_(sample_ping_pong(idle, static_cast<float>(options.delay_s))) {
  for (const JointFailure failure : kJointFailures)
    if (failure == JointFailure::none || options.are_limp)
      simulators_.emplace_back(character, simulation_of(options, failure));
  if (options.thrown.speed_mps < kMinSpeed_mps)
    throw Error("", "poses evolve for balls of at least 5 m/s");
  if (options.thrown.time_to_impact_s <= options.delay_s)
    throw Error("", "the ball arrives before the character begins to move");
  for (std::uint64_t draw = 0; draw < kIdleDraws; ++draw)
    idle_pain_ += test_idle(draw).pain / static_cast<double>(kIdleDraws);
  motion::Pose guard = start_;
  for (const motion::Side side : motion::kSides)
    set_arm(guard, side,
            {motion::radians(38), motion::radians(16), motion::radians(-6), motion::radians(112)});
  const sim::Rehearsal raised =
      simulator().rehearse(motion_to(guard, JointFailure::none), options.delay_s, duration_s());
  energy_weight_ =
      kEnergyShare * idle_pain_ /
      joint_effort(simulator().figure_model(), raised, options.simulation.gravity_mps2);
  distance_weight_ = distance_sign(options.style) * kDistanceShare_per_m * idle_pain_;
}

std::array<features::Ball, kGridCells> PoseTrial::balls(std::uint64_t draw) const {
  features::Random random(options_.seed, features::RandomStream::threat_grid, draw);
  return thrown_balls(options_.thrown, options_.grid, random);
}

std::span<const PoseGene> PoseTrial::genes() const {
  return options_.simulation.figure == sim::FigureKind::waist_up ? waist_up_genes() : pose_genes();
}

motion::Pose PoseTrial::pose(const Chromosome& chromosome) const {
  if (options_.simulation.figure == sim::FigureKind::waist_up)
    return waist_up_pose_of(figure_, start_, chromosome, options_.gene_map);
  return pose_of(figure_, start_, pose_genes(), chromosome, options_.gene_map);
}

motion::Motion PoseTrial::motion_to(const motion::Pose& pose, JointFailure failure) const {
  const double move_s = move_time_s(figure_, start_, pose);
  motion::Motion motion;
  motion.rate_hz = idle_.rate_hz;
  // Velocities up to the end need two more poses.
  const auto count = static_cast<std::size_t>(std::ceil(duration_s() * motion.rate_hz)) + 3;
  motion.poses.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double time_s = static_cast<double>(k) / motion.rate_hz;
    const motion::Pose idle = sample_ping_pong(idle_, static_cast<float>(time_s));
    const auto part = static_cast<float>((time_s - options_.delay_s) / move_s);
    motion::Pose now = part > 0 ? blend(idle, pose, motion::ease_in_ease_out(part)) : idle;
    for (const Body shoulder : kShoulders)
      if (fails(failure, shoulder))
        now.rotation[role_of(shoulder)] = idle.rotation[role_of(shoulder)];
    motion.poses.push_back(now);
  }
  return motion;
}

std::span<const JointFailure> PoseTrial::failures() const {
  return {kJointFailures.data(), options_.fails_joints ? kJointFailures.size() : 1};
}

std::vector<std::span<const JointFailure>> PoseTrial::failure_groups() const {
  const std::span<const JointFailure> all = failures();
  if (!options_.are_limp) return {all};
  std::vector<std::span<const JointFailure>> groups;
  for (std::size_t k = 0; k < all.size(); ++k) groups.push_back(all.subspan(k, 1));
  return groups;
}

const sim::Simulator& PoseTrial::simulator_of(JointFailure failure) const {
  return simulators_[options_.are_limp ? static_cast<std::size_t>(failure) : 0];
}

double PoseTrial::effort_of(const sim::Rehearsal& rehearsal) const {
  return joint_effort(simulator().figure_model(), rehearsal, options_.simulation.gravity_mps2,
                      options_.extension_weight);
}

double PoseTrial::overlap_penalty(const motion::Pose& pose) const {
  const double depth_m = overlap_depth_m(figure_, pose);
  return depth_m > 0 ? idle_pain_ * (kOverlapShare + kOverlapShare_per_m * depth_m) : 0;
}

PoseTrial::SharedPoses PoseTrial::rehearse(std::span<const Chromosome> chromosomes) const {
  std::vector<RehearsedPose> rehearsed(chromosomes.size());
  std::vector<motion::Pose> poses;
  for (std::size_t i = 0; i < chromosomes.size(); ++i) {
    poses.push_back(pose(chromosomes[i]));
    rehearsed[i].overlap_penalty = overlap_penalty(poses[i]);
  }
  for (const std::span<const JointFailure> group : failure_groups()) {
    std::vector<motion::Motion> motions;
    for (const motion::Pose& pose : poses)
      for (const JointFailure failure : group) motions.push_back(motion_to(pose, failure));
    std::vector<sim::Rehearsal> made =
        simulator_of(group.front()).rehearse(motions, options_.delay_s, duration_s());
    for (std::size_t i = 0; i < made.size(); ++i) {
      RehearsedPose& to = rehearsed[i / group.size()];
      to.efforts.push_back(effort_of(made[i]));
      to.rehearsals.push_back(std::move(made[i]));
    }
  }
  SharedPoses shared;
  for (RehearsedPose& one : rehearsed)
    shared.push_back(std::make_shared<const RehearsedPose>(std::move(one)));
  return shared;
}

PoseTrial::SharedPoses PoseTrial::rehearsed(std::span<const Chromosome> chromosomes,
                                            const RehearsedPoses* remembered) const {
  SharedPoses poses(chromosomes.size());
  std::vector<Chromosome> fresh;
  for (std::size_t i = 0; i < chromosomes.size(); ++i) {
    if (remembered) poses[i] = remembered->find(chromosomes[i]);
    if (!poses[i]) fresh.push_back(chromosomes[i]);
  }
  const SharedPoses made = rehearse(fresh);
  auto next = made.begin();
  for (auto& pose : poses)
    if (!pose) pose = *next++;
  return poses;
}

std::vector<PoseScore> PoseTrial::test_batch(const SharedPoses& poses,
                                             std::span<const features::Ball> balls) const {
  std::vector<PoseScore> scores(poses.size());
  std::size_t first = 0;  // failure of the group
  for (const std::span<const JointFailure> group : failure_groups()) {
    std::vector<sim::Throw> throws;
    for (const auto& pose : poses)
      for (std::size_t k = first; k < first + group.size(); ++k)
        for (const features::Ball& ball : balls) throws.push_back({pose->rehearsals[k], ball});
    const std::vector<sim::SimulationResult> results =
        sim::ThrowSimulator(simulator_of(group.front())).simulate(throws);
    const std::size_t per_pose = group.size() * balls.size();
    for (std::size_t i = 0; i < results.size(); ++i) add_result(results[i], scores[i / per_pose]);
    first += group.size();
  }
  const auto ball_count = static_cast<double>(balls.size());
  const double count = static_cast<double>(failures().size()) * ball_count;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    PoseScore& score = scores[i];
    score.overlap = poses[i]->overlap_penalty;
    for (const double effort : poses[i]->efforts)
      score.energy += energy_weight_ * ball_count * effort;
    for (double* term : {&score.pain, &score.energy, &score.distance, &score.limits})
      *term /= count;
  }
  return scores;
}

void PoseTrial::add_result(const sim::SimulationResult& result, PoseScore& score) const {
  score.pain += pain_of(options_.pain, figure_.bodies, result.places);
  score.limits += options_.limit_weight_per_rads * idle_pain_ * result.limit_excess_rads;
  if (result.places.empty()) return;
  score.distance +=
      distance_weight_ * (result.places.front().point_world - options_.thrown.aim).norm();
}

std::optional<std::vector<PoseScore>> PoseTrial::test(std::span<const Chromosome> chromosomes,
                                                      std::uint64_t draw, int threads,
                                                      const std::atomic<bool>* stop,
                                                      RehearsedPoses* remembered) const {
  constexpr std::size_t kBatch = 4;  // fills the lanes, and needs 16 rehearsals at most
  const auto thrown = balls(draw);
  const auto batches = static_cast<int>((chromosomes.size() + kBatch - 1) / kBatch);
  std::vector<PoseScore> scores(chromosomes.size());
  SharedPoses tested(remembered ? chromosomes.size() : 0);
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (int batch = 0; batch < batches; ++batch) {
    if (stop && *stop) continue;
    try {
      const std::size_t first = static_cast<std::size_t>(batch) * kBatch;
      const std::size_t count = std::min(kBatch, chromosomes.size() - first);
      SharedPoses poses = rehearsed(chromosomes.subspan(first, count), remembered);
      const auto at = static_cast<std::ptrdiff_t>(first);
      std::ranges::copy(test_batch(poses, thrown), scores.begin() + at);
      if (remembered) std::ranges::move(poses, tested.begin() + at);
    } catch (...) {
#pragma omp critical
      failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
  if (stop && *stop) return std::nullopt;
  for (std::size_t i = 0; i < tested.size(); ++i) remembered->add(chromosomes[i], tested[i]);
  return scores;
}

double PoseTrial::mean_pain(std::span<const sim::SimulationResult> results) const {
  double sum = 0;
  for (const sim::SimulationResult& result : results)
    sum += pain_of(options_.pain, figure_.bodies, result.places);
  return sum / static_cast<double>(results.size());
}

std::vector<sim::SimulationResult> PoseTrial::thrown_at(
    const motion::Motion& motion, JointFailure failure,
    std::span<const features::Ball> balls) const {
  const sim::Simulator& simulator = simulator_of(failure);
  const sim::Rehearsal rehearsal = simulator.rehearse(motion, options_.delay_s, duration_s());
  std::vector<sim::Throw> throws;
  for (const features::Ball& ball : balls) throws.push_back({rehearsal, ball});
  return sim::ThrowSimulator(simulator).simulate(throws);
}

PoseScore PoseTrial::test_idle(std::uint64_t draw) const {
  PoseScore score;
  score.pain =
      mean_pain(thrown_at(motion_to(start_, JointFailure::none), JointFailure::none, balls(draw)));
  return score;
}

std::vector<sim::SimulationResult> PoseTrial::simulate(
    const Chromosome& chromosome, JointFailure failure,
    std::span<const features::Ball> balls) const {
  return thrown_at(motion_to(pose(chromosome), failure), failure, balls);
}

std::vector<sim::SimulationResult> PoseTrial::simulate_by_reference(
    const Chromosome& chromosome, JointFailure failure,
    std::span<const features::Ball> balls) const {
  const sim::OdeSimulator simulator(figure_.character, simulator_of(failure).options());
  const motion::Motion motion = motion_to(pose(chromosome), failure);
  std::vector<sim::SimulationResult> results;
  for (const features::Ball& ball : balls)
    results.push_back(simulator.simulate(motion, &ball, duration_s()));
  return results;
}

}  // namespace flinch::evolve
