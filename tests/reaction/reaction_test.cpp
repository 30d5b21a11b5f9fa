// SPDX-License-Identifier: MIT
#include "reaction/reaction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/reaction/reaction_player.h"

namespace flinch::reaction {
namespace {

using motion::Body;
using motion::Role;
using scenes::advance;
using scenes::aimed_at;
using scenes::cases;
using scenes::character;
using scenes::distance;
using scenes::figure_model;
using scenes::frames_of;
using scenes::hovering;
using scenes::kFrame_s;
using scenes::middle_of;
using scenes::model;
using scenes::motions;
using scenes::play;
using scenes::pose_at;
using scenes::ReactionCase;
using scenes::standing;

TEST(Reaction, FollowsTheMotionWithoutABall) {
  for (const auto& [name, motion] : motions()) {
    Reaction reaction(figure_model());
    const double begin_s = 0.1;
    ASSERT_EQ(reaction.begin(pose_at(motion, begin_s - kFrame_s), pose_at(motion, begin_s),
                             kFrame_s, nullptr),
              ReactionStatus::ok);
    // Elbows at a thousand degrees per second are the hardest to track.
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

TEST(Reaction, FirstContactMatchesTheTrainersSimulation) {
  const sim::OdeSimulator simulator(character(), {});
  int hits = 0;
  int alike = 0;
  for (const ReactionCase& reaction_case : cases()) {
    Reaction reaction(figure_model());
    play(reaction, reaction_case, 0.1);
    EXPECT_NEAR(reaction.contact_s(), scenes::kLead_s, 0.001);
    ++hits;
    features::Ball ball = reaction_case.ball;
    const Eigen::Vector3d gravity(0, 0, -9.81);
    ball.velocity -= reaction_case.begin_s * gravity;
    ball.position -= reaction_case.begin_s * ball.velocity +
                     reaction_case.begin_s * reaction_case.begin_s / 2 * gravity;
    const auto trained =
        simulator.simulate(*reaction_case.motion, &ball, reaction_case.begin_s + 0.1);
    double sum = 0;
    double difference = 0;
    for (Body body : motion::kBodies) {
      sum += trained.impulse[body];
      difference += std::abs(trained.impulse[body] - reaction.impulse()[body]);
    }
    if (difference < 0.05 * sum) ++alike;
  }
  EXPECT_GT(hits, 40);
  // Where a part that was hit hits another part, the stiffness of its springs matters.
  EXPECT_GT(alike, hits * 8 / 10);
}

// Compares the figure's change of momentum, from displayed poses half a millisecond apart, with the
// ball's loss.
TEST(Reaction, ConservesMomentum) {
  constexpr double kShort_s = 0.0005;
  for (const auto& [body, velocity] : {std::pair{Body::head, Eigen::Vector3d(-20, 0, 0)},
                                       {Body::chest, {-15, 0, 0}},
                                       {Body::left_forearm, {-12, 0, 0}},
                                       {Body::pelvis, {-18, 0, 0}}}) {
    const ReactionCase reaction_case = aimed_at(body, velocity, 0.27, hovering());
    Reaction reaction(figure_model());
    scenes::begin(reaction, reaction_case);
    double since_s = 0;
    const auto step = [&] {
      const motion::Pose before = reaction.pose();
      since_s += kShort_s;
      advance(reaction, reaction_case, since_s, kShort_s);
      Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
      for (Body part : motion::kBodies) {
        momentum += static_cast<double>(model()[part].mass_kg) / kShort_s *
                    (middle_of(part, reaction.pose()) - middle_of(part, before));
      }
      return momentum;
    };
    Eigen::Vector3d figure = step();
    // Until the displayed pose lies within the step of the blow.
    while (since_s - kShort_s < reaction.contact_s() && since_s < 0.1) figure = step();
    ASSERT_LT(reaction.contact_s(), since_s) << name_of(body);
    const Eigen::Vector3d ball_before = reaction_case.ball.velocity;
    const Eigen::Vector3d lost =
        reaction_case.ball.mass_kg * (ball_before - reaction.ball().velocity);
    EXPECT_LT((figure - lost).head<2>().norm(), 0.03 * lost.norm()) << name_of(body);
    EXPECT_LT((reaction.ball_momentum() - lost).head<2>().norm(), 1e-9) << name_of(body);
    // A free ball against a free mass at rest loses between m v and (1 + e) m v; here the mass
    // gives way.
    EXPECT_GT(lost.norm(), 0.5 * reaction_case.ball.mass_kg * velocity.norm());
    EXPECT_LT(lost.norm(), 1.75 * reaction_case.ball.mass_kg * velocity.norm());
  }
}

// A character runs into a ball that hangs motionless before its face.
TEST(Reaction, FigureStartsWithTheVelocityOfItsMotion) {
  constexpr double kSpeed_mps = 3;
  const motion::Pose now = standing().poses.front();
  const auto at = [&](double time_s) {
    motion::Pose pose = now;
    pose.root_position.x() += static_cast<float>(kSpeed_mps * time_s);
    return pose;
  };
  const motion::Shape& skull = model()[Body::head].shape;
  features::Ball ball;
  ball.position =
      (frames_of(now).position[Role::head] + skull.centre).cast<double>() +
      (static_cast<double>(skull.radius) + ball.radius + 5e-5) * Eigen::Vector3d::UnitX();
  Reaction reaction(figure_model());
  ASSERT_EQ(reaction.begin(at(-kFrame_s), now, kFrame_s, &ball), ReactionStatus::ok);
  ASSERT_EQ(reaction.advance(0.002, at(0.002), at(0.002)), ReactionStatus::ok);
  EXPECT_EQ(reaction.contact_s(), 0);
  // For a head that weighs much more than the ball, the speed is close to (1 + e) v.
  EXPECT_GT(reaction.ball().velocity.x(), 1.4 * kSpeed_mps);
  EXPECT_LT(reaction.ball().velocity.x(), 1.7 * kSpeed_mps);
}

TEST(Reaction, StruckBodyMovesInTheBallsDirection) {
  for (const auto& [body, velocity, least_m, most_m] :
       {std::tuple{Body::head, Eigen::Vector3d(-20, 0, 0), 0.02, 0.2},
        {Body::head, {0, 20, 0}, 0.02, 0.2},
        {Body::chest, {-25, 0, 0}, 0.004, 0.05},
        {Body::left_forearm, {-20, 0, 0}, 0.03, 0.4},
        {Body::left_hand, {0, 0, -20}, 0.03, 0.5},
        {Body::left_shin, {-20, 0, 0}, 0.002, 0.2}}) {
    const bool arm = target_of(body) == motion::Target::trunk && body != Body::chest;
    const ReactionCase reaction_case =
        aimed_at(body, velocity, 0.27, arm ? hovering() : standing());
    Reaction reaction(figure_model());
    double most = 0;
    for (const motion::Pose& pose : play(reaction, reaction_case, 0.25)) {
      const Eigen::Vector3d moved =
          middle_of(body, pose) - middle_of(body, reaction_case.motion->poses.front());
      most = std::max(most, moved.dot(velocity.normalized()));
    }
    EXPECT_GT(most, least_m) << name_of(body);
    EXPECT_LT(most, most_m) << name_of(body);
  }
}

TEST(Reaction, AHeavyFastBallKnocksOverAndStateStaysFinite) {
  for (Body body : {Body::chest, Body::abdomen, Body::pelvis}) {
    const ReactionCase reaction_case = aimed_at(body, {-10, 0, 0}, 20);
    Reaction reaction(figure_model());
    play(reaction, reaction_case, 0.2);
    EXPECT_EQ(reaction.phase(), ReactionPhase::knocked_over) << name_of(body);
    double lowest = 1;
    for (int k = 0; k < 180; ++k) {
      ASSERT_EQ(advance(reaction, reaction_case, 0.2 + k * kFrame_s, kFrame_s), ReactionStatus::ok);
      for (const Eigen::Vector3f& joint : frames_of(reaction.pose()).position) {
        ASSERT_TRUE(joint.allFinite());
        lowest = std::min(lowest, static_cast<double>(joint.z()));
      }
    }
    // It lies on the ground and not below it.
    EXPECT_LT(reaction.pose().root_position.z(), 0.4F) << name_of(body);
    EXPECT_GT(lowest, -0.2) << name_of(body);
  }
}

TEST(Reaction, VolleyballsDoNotKnockOver) {
  for (const ReactionCase& reaction_case : cases()) {
    Reaction reaction(figure_model());
    play(reaction, reaction_case, 0.5);
    EXPECT_NE(reaction.phase(), ReactionPhase::knocked_over);
  }
}

TEST(Reaction, BallKeepsFlyingAndBouncingUntilTheEnd) {
  const ReactionCase reaction_case = aimed_at(Body::chest, {-12, 0, 0});
  Reaction reaction(figure_model());
  ASSERT_EQ(scenes::begin(reaction, reaction_case), ReactionStatus::ok);
  Eigen::Vector3d last = reaction.ball().position;
  double lowest = 2;
  double highest_after = 0;
  for (int k = 1; k <= 120; ++k) {
    advance(reaction, reaction_case, k * kFrame_s, kFrame_s);
    const features::Ball ball = reaction.ball();
    EXPECT_LT((ball.position - last).norm(), 14 * kFrame_s);
    last = ball.position;
    lowest = std::min(lowest, ball.position.z());
    if (lowest < 0.15) highest_after = std::max(highest_after, ball.position.z());
  }
  EXPECT_NEAR(lowest, reaction_case.ball.radius, 0.05);
  EXPECT_GT(highest_after, 0.3);
  EXPECT_GT(last.x(), 0.5);  // thrown back
}

}  // namespace
}  // namespace flinch::reaction
