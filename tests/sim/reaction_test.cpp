// SPDX-License-Identifier: MIT
#include "sim/reaction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "motion/interpolation.h"
#include "tests/sim/reaction_scenes.h"

namespace flinch::sim {
namespace {

using motion::Body;
using motion::Role;
using scenes::Blow;
using scenes::kFrame_s;
using scenes::pose_at;

const motion::Character& character() {
  static const motion::Character man = motion::default_character();
  return man;
}

const std::vector<scenes::NamedMotion>& motions() {
  static const auto all = scenes::motions_by_rule(character().skeleton);
  return all;
}

std::shared_ptr<const FigurePlan> plan() {
  static const auto shared = make_figure_plan(character());
  return shared;
}

const std::vector<Blow>& blows() {
  static const auto all = scenes::random_blows(character(), motions(), 48, 5);
  return all;
}

const motion::BodyModel& model() {
  static const motion::BodyModel bodies = make_body_model(character());
  return bodies;
}

motion::JointFrames frames_of(const motion::Pose& pose) {
  return forward_kinematics(character().skeleton, pose);
}

/// How far the joint that is farthest off is, m.
double distance(const motion::Pose& first, const motion::Pose& second) {
  const motion::JointFrames a = frames_of(first);
  const motion::JointFrames b = frames_of(second);
  double most = 0;
  for (Role role : motion::kRoles) {
    most = std::max(most, static_cast<double>((a.position[role] - b.position[role]).norm()));
  }
  return most;
}

Eigen::Vector3d middle_of(Body body, const motion::Pose& pose) {
  return centre_of_mass(model(), frames_of(pose), body).cast<double>();
}

motion::Motion held(const motion::Pose& pose) {
  motion::Motion motion;
  motion.poses.assign(61, pose);
  return motion;
}

const motion::Motion& standing() {
  static const motion::Motion still = held(scenes::standing(character().skeleton));
  return still;
}

/// With arms stretched out sideways, one metre above the ground.
const motion::Motion& hovering() {
  static const motion::Motion still = [] {
    motion::Pose pose = motion::rest_pose(character().skeleton);
    pose.root_position.z() += 1;
    return held(pose);
  }();
  return still;
}

/// A ball that is to hit the middle of a part of a figure that keeps still, level, within 0.035 s.
Blow aimed_at(Body body, const Eigen::Vector3d& velocity, double mass_kg = 0.27,
              const motion::Motion& still = standing()) {
  const Eigen::Vector3d place = middle_of(body, still.poses.front());
  Ball ball = scenes::aimed_ball(place, velocity, 0.035);
  ball.mass_kg = mass_kg;
  return {&still, ball, kFrame_s};
}

ReactionStatus advance(Reaction& reaction, const Blow& blow, double since_s, double dt_s) {
  const motion::Pose wanted = pose_at(*blow.motion, blow.begin_s + since_s);
  return reaction.advance(dt_s, wanted, wanted);
}

/// The poses shown, frame by frame, the one at begin first.
std::vector<motion::Pose> play(Reaction& reaction, const Blow& blow, double duration_s,
                               double frame_s = kFrame_s) {
  EXPECT_EQ(scenes::begin(reaction, blow), ReactionStatus::ok);
  std::vector<motion::Pose> poses{reaction.pose()};
  for (int k = 1; k * frame_s < duration_s + 1e-9; ++k) {
    EXPECT_EQ(advance(reaction, blow, k * frame_s, frame_s), ReactionStatus::ok);
    poses.push_back(reaction.pose());
  }
  return poses;
}

TEST(Reaction, WithoutABallFollowsTheMotion) {
  for (const auto& [name, motion] : motions()) {
    Reaction reaction(plan());
    const double begin_s = 0.1;
    ASSERT_EQ(reaction.begin(pose_at(motion, begin_s - kFrame_s), pose_at(motion, begin_s),
                             kFrame_s, nullptr),
              ReactionStatus::ok);
    // Elbows at a thousand degrees a second are the hardest.
    const double most_m = name == "fast block" ? 0.02 : 0.005;
    for (int k = 1; k < 64; ++k) {
      const motion::Pose wanted = pose_at(motion, begin_s + k * kFrame_s);
      ASSERT_EQ(reaction.advance(kFrame_s, wanted, wanted), ReactionStatus::ok);
      EXPECT_LT(distance(reaction.pose(), wanted), most_m) << name << ", frame " << k;
    }
    EXPECT_EQ(reaction.phase(), ReactionPhase::over);
    EXPECT_TRUE(std::isinf(reaction.contact_s()));
  }
}

TEST(Reaction, TouchesWhenAndAsTheTrainersFigureDoes) {
  const Simulator simulator(character(), {});
  int hits = 0;
  int alike = 0;
  for (const Blow& blow : blows()) {
    Reaction reaction(plan());
    play(reaction, blow, 0.1);
    EXPECT_NEAR(reaction.contact_s(), scenes::kLead_s, 0.001);
    ++hits;
    Ball ball = blow.ball;
    const Eigen::Vector3d gravity(0, 0, -9.81);
    ball.velocity -= blow.begin_s * gravity;
    ball.position -= blow.begin_s * ball.velocity + blow.begin_s * blow.begin_s / 2 * gravity;
    const auto trained = simulator.simulate(*blow.motion, &ball, blow.begin_s + 0.1);
    double sum = 0;
    double difference = 0;
    for (Body body : motion::kBodies) {
      sum += trained.impulse[body];
      difference += std::abs(trained.impulse[body] - reaction.impulse()[body]);
    }
    if (difference < 0.05 * sum) ++alike;
  }
  EXPECT_GT(hits, 40);
  // Where a part that was hit then hits another, how soft its springs are does matter.
  EXPECT_GT(alike, hits * 8 / 10);
}

// The momentum of the figure by the poses shown half a millisecond apart, against the ball's loss.
TEST(Reaction, FigureTakesTheMomentumThatTheBallLoses) {
  constexpr double kShort_s = 0.0005;
  for (const auto& [body, velocity] : {std::pair{Body::head, Eigen::Vector3d(-20, 0, 0)},
                                       {Body::chest, {-15, 0, 0}},
                                       {Body::left_forearm, {-12, 0, 0}},
                                       {Body::pelvis, {-18, 0, 0}}}) {
    const Blow blow = aimed_at(body, velocity, 0.27, hovering());
    Reaction reaction(plan());
    scenes::begin(reaction, blow);
    double since_s = 0;
    const auto step = [&] {
      const motion::Pose before = reaction.pose();
      since_s += kShort_s;
      advance(reaction, blow, since_s, kShort_s);
      Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
      for (Body part : motion::kBodies) {
        momentum += static_cast<double>(model()[part].mass_kg) / kShort_s *
                    (middle_of(part, reaction.pose()) - middle_of(part, before));
      }
      return momentum;
    };
    Eigen::Vector3d figure = step();
    // Until what is shown lies within the step of the blow.
    while (since_s - kShort_s < reaction.contact_s() && since_s < 0.1) figure = step();
    ASSERT_LT(reaction.contact_s(), since_s) << name_of(body);
    const Eigen::Vector3d ball_before = blow.ball.velocity;
    const Eigen::Vector3d lost = blow.ball.mass_kg * (ball_before - reaction.ball().velocity);
    EXPECT_LT((figure - lost).head<2>().norm(), 0.03 * lost.norm()) << name_of(body);
    // A free ball against a mass at rest loses between m v and (1 + e) m v; here the mass gives.
    EXPECT_GT(lost.norm(), 0.5 * blow.ball.mass_kg * velocity.norm());
    EXPECT_LT(lost.norm(), 1.75 * blow.ball.mass_kg * velocity.norm());
  }
}

// A character that runs into a ball that hangs in the air before its face.
TEST(Reaction, FigureMovesFromTheVeryBeginning) {
  constexpr double kSpeed_mps = 3;
  const motion::Pose now = standing().poses.front();
  const auto at = [&](double time_s) {
    motion::Pose pose = now;
    pose.root_position.x() += static_cast<float>(kSpeed_mps * time_s);
    return pose;
  };
  const motion::Shape& skull = model()[Body::head].shape;
  Ball ball;
  ball.position =
      (frames_of(now).position[Role::head] + skull.centre).cast<double>() +
      (static_cast<double>(skull.radius) + ball.radius + 5e-5) * Eigen::Vector3d::UnitX();
  Reaction reaction(plan());
  ASSERT_EQ(reaction.begin(at(-kFrame_s), now, kFrame_s, &ball), ReactionStatus::ok);
  ASSERT_EQ(reaction.advance(0.002, at(0.002), at(0.002)), ReactionStatus::ok);
  EXPECT_EQ(reaction.contact_s(), 0);
  // Of a head that weighs much more than the ball: close to (1 + e) v.
  EXPECT_GT(reaction.ball().velocity.x(), 1.4 * kSpeed_mps);
  EXPECT_LT(reaction.ball().velocity.x(), 1.7 * kSpeed_mps);
}

TEST(Reaction, StruckPartGivesWayAlongTheBallsFlight) {
  for (const auto& [body, velocity, least_m, most_m] :
       {std::tuple{Body::head, Eigen::Vector3d(-20, 0, 0), 0.02, 0.2},
        {Body::head, {0, 20, 0}, 0.02, 0.2},
        {Body::chest, {-25, 0, 0}, 0.004, 0.05},
        {Body::left_forearm, {-20, 0, 0}, 0.03, 0.4},
        {Body::left_hand, {0, 0, -20}, 0.03, 0.5},
        {Body::left_shin, {-20, 0, 0}, 0.002, 0.2}}) {
    const bool arm = target_of(body) == motion::Target::trunk && body != Body::chest;
    const Blow blow = aimed_at(body, velocity, 0.27, arm ? hovering() : standing());
    Reaction reaction(plan());
    double most = 0;
    for (const motion::Pose& pose : play(reaction, blow, 0.25)) {
      const Eigen::Vector3d moved =
          middle_of(body, pose) - middle_of(body, blow.motion->poses.front());
      most = std::max(most, moved.dot(velocity.normalized()));
    }
    EXPECT_GT(most, least_m) << name_of(body);
    EXPECT_LT(most, most_m) << name_of(body);
  }
}

TEST(Reaction, ReturnsToTheMotionWhenTheScheduleIsOver) {
  const double over_s = scenes::kLead_s + duration_s(RecoverySchedule{});
  int returned = 0;
  for (const Blow& blow : blows()) {
    // To another motion than the one tracked.
    const motion::Motion& other = motions()[(&blow - blows().data()) % 6].motion;
    Reaction reaction(plan());
    scenes::begin(reaction, blow);
    motion::Pose returning;
    for (int k = 1; k * kFrame_s < over_s + 2 * kFrame_s; ++k) {
      const double time_s = blow.begin_s + k * kFrame_s;
      returning = pose_at(other, time_s);
      reaction.advance(kFrame_s, pose_at(*blow.motion, time_s), returning);
    }
    EXPECT_EQ(reaction.phase(), ReactionPhase::over);
    EXPECT_LT(distance(reaction.pose(), returning), 1e-3);
    for (Role role : motion::kRoles) {
      EXPECT_LT(reaction.pose().rotation[role].angularDistance(returning.rotation[role]),
                0.1F * scenes::kDegrees);
    }
    ++returned;
  }
  EXPECT_GT(returned, 40);
}

/// The most by which a joint's velocity, less that of the motion, changes from one frame to the
/// next, m/s; frame by frame.
std::vector<double> velocity_changes(const std::vector<motion::Pose>& poses, const Blow& blow) {
  std::vector<double> changes;
  std::vector<motion::PerRole<Eigen::Vector3f>> off;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto shown = frames_of(poses[k]);
    const auto wanted =
        frames_of(pose_at(*blow.motion, blow.begin_s + static_cast<double>(k) * kFrame_s));
    off.emplace_back();
    for (Role role : motion::kRoles) {
      off.back()[role] = shown.position[role] - wanted.position[role];
    }
    double most = 0;
    for (Role role : motion::kRoles) {
      const Eigen::Vector3f before =
          k > 1 ? Eigen::Vector3f(off[k - 1][role] - off[k - 2][role]) : Eigen::Vector3f::Zero();
      if (k == 0) continue;
      most = std::max(
          most, static_cast<double>((off[k][role] - off[k - 1][role] - before).norm()) / kFrame_s);
    }
    changes.push_back(most);
  }
  return changes;
}

TEST(Reaction, NothingSnapsWhereItIsTakenOverOrHandedBack) {
  const RecoverySchedule schedule;
  for (const Blow& blow : blows()) {
    Reaction reaction(plan());
    const auto poses = play(reaction, blow, 0.9);
    EXPECT_LT(distance(poses.front(), pose_at(*blow.motion, blow.begin_s)), 1e-5);
    const auto changes = velocity_changes(poses, blow);
    EXPECT_LT(changes[1], 0.3);  // the contact comes after the first frame
    for (std::size_t k = 2; k < changes.size(); ++k) {
      const double since_contact_s = static_cast<double>(k) * kFrame_s - scenes::kLead_s;
      // A hand that is hit may well get to several m/s, and may strike another part.
      EXPECT_LT(changes[k], since_contact_s < schedule.alone_s + kFrame_s ? 8 : 0.5)
          << since_contact_s << " s after the contact";
    }
  }
}

bool is_hit_on_the_leg(const Reaction& reaction, Role foot) {
  for (Body body = body_of(foot); body != Body::pelvis; body = *parent_of(body)) {
    if (reaction.impulse()[body] > 0) return true;
  }
  return false;
}

TEST(Reaction, StandingFeetHardlySlide) {
  int feet = 0;
  for (const Blow& blow : blows()) {
    Reaction reaction(plan());
    const auto poses = play(reaction, blow, 0.8);
    for (Role foot : {Role::left_foot, Role::right_foot}) {
      if (is_hit_on_the_leg(reaction, foot)) continue;
      const auto first = frames_of(poses.front()).position[foot];
      if ((frames_of(blow.motion->poses.back()).position[foot] - first).norm() > 1e-3F) continue;
      ++feet;
      for (const motion::Pose& pose : poses) {
        EXPECT_LT((frames_of(pose).position[foot] - first).norm(), 0.003F);
      }
    }
  }
  EXPECT_GT(feet, 30);
}

TEST(Reaction, StretchesNoBone) {
  Reaction reaction(plan());
  for (const motion::Pose& pose : play(reaction, aimed_at(Body::left_hand, {-30, 0, 0}), 0.4)) {
    const auto frames = frames_of(pose);
    for (Role role : motion::kRoles) {
      EXPECT_NEAR(pose.rotation[role].norm(), 1, 1e-5);
      const auto parent = parent_of(role);
      if (!parent) continue;
      EXPECT_NEAR((frames.position[role] - frames.position[*parent]).norm(),
                  character().skeleton.offset[role].norm(), 1e-5);
    }
  }
}

TEST(Reaction, AHeavyFastBallKnocksOverAndNothingBreaks) {
  for (Body body : {Body::chest, Body::abdomen, Body::pelvis}) {
    const Blow blow = aimed_at(body, {-10, 0, 0}, 20);
    Reaction reaction(plan());
    play(reaction, blow, 0.2);
    EXPECT_EQ(reaction.phase(), ReactionPhase::knocked_over) << name_of(body);
    double lowest = 1;
    for (int k = 0; k < 180; ++k) {
      ASSERT_EQ(advance(reaction, blow, 0.2 + k * kFrame_s, kFrame_s), ReactionStatus::ok);
      for (const Eigen::Vector3f& joint : frames_of(reaction.pose()).position) {
        ASSERT_TRUE(joint.allFinite());
        lowest = std::min(lowest, static_cast<double>(joint.z()));
      }
    }
    // It lies on the ground, and not in it.
    EXPECT_LT(reaction.pose().root_position.z(), 0.4F) << name_of(body);
    EXPECT_GT(lowest, -0.2) << name_of(body);
  }
}

TEST(Reaction, VolleyballsKnockNobodyOver) {
  for (const Blow& blow : blows()) {
    Reaction reaction(plan());
    play(reaction, blow, 0.5);
    EXPECT_NE(reaction.phase(), ReactionPhase::knocked_over);
  }
}

bool same_bits(const motion::Pose& first, const motion::Pose& second) {
  return std::memcmp(first.root_position.data(), second.root_position.data(), 3 * sizeof(float)) ==
             0 &&
         std::equal(first.rotation.begin(), first.rotation.end(), second.rotation.begin(),
                    [](const auto& a, const auto& b) { return a.coeffs() == b.coeffs(); });
}

bool same_bits(const std::vector<motion::Pose>& first, const std::vector<motion::Pose>& second) {
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const auto& a, const auto& b) { return same_bits(a, b); });
}

TEST(Reaction, RepeatsBitForBitAlsoOnThreadsAtOnce) {
  const auto run = [&](std::vector<std::vector<motion::Pose>>& results) {
    Reaction reaction(plan());  // one for all: what it did before does not count
    for (std::size_t i = 0; i < 12; ++i) results.push_back(play(reaction, blows()[i], 0.5));
  };
  std::vector<std::vector<motion::Pose>> alone;
  run(alone);
  std::array<std::vector<std::vector<motion::Pose>>, 3> together;
  std::vector<std::thread> threads;
  for (auto& results : together) threads.emplace_back([&] { run(results); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& results : together) {
    for (std::size_t i = 0; i < alone.size(); ++i) {
      EXPECT_TRUE(same_bits(alone[i], results[i])) << i;
      EXPECT_TRUE(same_bits(alone[i], play(*std::make_unique<Reaction>(plan()), blows()[i], 0.5)));
    }
  }
}

TEST(Reaction, GoesOnOnAnotherThread) {
  const Blow& blow = blows().front();
  Reaction here(plan());
  const auto poses = play(here, blow, 0.4);
  Reaction there(plan());
  ASSERT_EQ(scenes::begin(there, blow), ReactionStatus::ok);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    std::thread([&] { advance(there, blow, static_cast<double>(k) * kFrame_s, kFrame_s); }).join();
    EXPECT_TRUE(same_bits(there.pose(), poses[k])) << k;
  }
}

TEST(Reaction, UnevenFramesGiveTheSameMotion) {
  std::mt19937 generator(7);
  std::vector<double> worst_m;
  for (const Blow& blow : blows()) {
    Reaction even(plan());
    const auto poses = play(even, blow, 0.8);
    Reaction uneven(plan());
    scenes::begin(uneven, blow);
    double since_s = 0;
    double worst = 0;
    for (std::size_t tenth = 1; tenth <= 8; ++tenth) {
      const double until_s = 0.1 * static_cast<double>(tenth);
      while (since_s < until_s - 1e-9) {
        double dt_s = std::uniform_real_distribution<double>(0.001, 0.05)(generator);
        if (since_s + dt_s > until_s - 1e-3) dt_s = until_s - since_s;
        since_s += dt_s;
        EXPECT_EQ(advance(uneven, blow, since_s, dt_s), ReactionStatus::ok);
      }
      worst = std::max(worst, distance(uneven.pose(), poses[6 * tenth]));
    }
    worst_m.push_back(worst);
  }
  std::sort(worst_m.begin(), worst_m.end());
  EXPECT_LT(worst_m[worst_m.size() / 2], 0.001);
  EXPECT_LT(worst_m.back(), 0.02);
}

TEST(Reaction, BallFliesOnAndBouncesUntilItIsOver) {
  const Blow blow = aimed_at(Body::chest, {-12, 0, 0});
  Reaction reaction(plan());
  ASSERT_EQ(scenes::begin(reaction, blow), ReactionStatus::ok);
  Eigen::Vector3d last = reaction.ball().position;
  double lowest = 2;
  double highest_after = 0;
  for (int k = 1; k <= 120; ++k) {
    advance(reaction, blow, k * kFrame_s, kFrame_s);
    const Ball ball = reaction.ball();
    EXPECT_LT((ball.position - last).norm(), 14 * kFrame_s);
    last = ball.position;
    lowest = std::min(lowest, ball.position.z());
    if (lowest < 0.15) highest_after = std::max(highest_after, ball.position.z());
  }
  EXPECT_NEAR(lowest, blow.ball.radius, 0.05);
  EXPECT_GT(highest_after, 0.3);
  EXPECT_GT(last.x(), 0.5);  // thrown back
}

TEST(Reaction, RefusesBadInputAndStaysUsable) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Blow& blow = blows().front();
  const motion::Pose good = pose_at(*blow.motion, blow.begin_s);
  motion::Pose no_place = good;
  no_place.root_position.x() = nan;
  motion::Pose no_turn = good;
  no_turn.rotation[Role::head].w() = nan;
  motion::Pose not_unit = good;
  not_unit.rotation[Role::head].coeffs() *= 2;
  std::vector<Ball> bad_balls(6, blow.ball);
  bad_balls[0].position.x() = static_cast<double>(nan);
  bad_balls[1].velocity.z() = std::numeric_limits<double>::infinity();
  bad_balls[2].radius = 0;
  bad_balls[3].mass_kg = -1;
  bad_balls[4].mass_kg = static_cast<double>(nan);
  bad_balls[5].velocity.x() = 1e9;

  Reaction reaction(plan());
  EXPECT_EQ(reaction.advance(kFrame_s, good, good), ReactionStatus::not_begun);
  const auto try_all = [&] {
    for (double dt_s : {0.0, -1.0, 0.2, static_cast<double>(nan)}) {
      EXPECT_EQ(reaction.begin(good, good, dt_s, &blow.ball), ReactionStatus::bad_time);
    }
    for (const motion::Pose& bad : {no_place, no_turn, not_unit}) {
      EXPECT_EQ(reaction.begin(bad, good, kFrame_s, &blow.ball), ReactionStatus::bad_pose);
      EXPECT_EQ(reaction.begin(good, bad, kFrame_s, &blow.ball), ReactionStatus::bad_pose);
    }
    for (const Ball& bad : bad_balls) {
      EXPECT_EQ(reaction.begin(good, good, kFrame_s, &bad), ReactionStatus::bad_ball);
    }
  };
  try_all();
  EXPECT_EQ(reaction.phase(), ReactionPhase::none);

  Reaction untroubled(plan());
  const auto poses = play(untroubled, blow, 0.3);
  ASSERT_EQ(scenes::begin(reaction, blow), ReactionStatus::ok);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    try_all();
    for (double dt_s : {0.0, -1.0, 0.2, static_cast<double>(nan)}) {
      EXPECT_EQ(reaction.advance(dt_s, good, good), ReactionStatus::bad_time);
    }
    for (const motion::Pose& bad : {no_place, no_turn, not_unit}) {
      EXPECT_EQ(reaction.advance(kFrame_s, bad, good), ReactionStatus::bad_pose);
      EXPECT_EQ(reaction.advance(kFrame_s, good, bad), ReactionStatus::bad_pose);
    }
    advance(reaction, blow, static_cast<double>(k) * kFrame_s, kFrame_s);
    EXPECT_TRUE(same_bits(reaction.pose(), poses[k]));
  }
  EXPECT_EQ(Reaction(nullptr).begin(good, good, kFrame_s, nullptr), ReactionStatus::bad_options);
  for (const ReactionOptions& bad :
       {ReactionOptions{.schedule = {.alone_s = 0}, .stiffness = 0.1},
        ReactionOptions{.schedule = {.alone_s = static_cast<double>(nan)}, .stiffness = 0.1},
        ReactionOptions{.schedule = {}, .stiffness = 0}}) {
    EXPECT_EQ(Reaction(plan(), bad).begin(good, good, kFrame_s, nullptr),
              ReactionStatus::bad_options);
  }
}

}  // namespace
}  // namespace flinch::sim
