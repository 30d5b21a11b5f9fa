// SPDX-License-Identifier: MIT
#include "evolve/trial/joint_effort.h"

#include <gtest/gtest.h>

#include "motion/body_distance.h"
#include "motion/default_character.h"
#include "motion/figure.h"
#include "motion/rotation.h"
#include "sim/figure/figure_model.h"

namespace flinch::evolve {
namespace {

using motion::Body;

motion::Motion still(const motion::Pose& pose) {
  motion::Motion motion;
  motion.poses.assign(80, pose);
  return motion;
}

double effort(const motion::Motion& motion, double from_s, double duration_s) {
  const sim::Simulator simulator(motion::default_character(), {});
  return joint_effort(simulator.figure_model(), simulator.rehearse(motion, from_s, duration_s),
                      simulator.options().gravity_mps2);
}

bool is_beyond(Body joint, Body body) {
  for (std::optional<Body> at = body; at; at = parent_of(*at))
    if (*at == joint) return true;
  return false;
}

// At rest a joint's torque carries the weight of what is beyond it: m g times its lever.
TEST(JointEffort, OfAFigureAtRestIsTheMomentOfItsWeights) {
  const motion::Physique character = motion::default_character();
  const motion::BodyModel model = make_body_model(character);
  const motion::Pose pose = motion::rest_pose(character.skeleton);  // arms to the sides
  const motion::JointFrames frames = forward_kinematics(character.skeleton, pose);
  double torque = 0;
  for (const Body joint : kEffortJoints) {
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const Body body : motion::kBodies) {
      if (!is_beyond(joint, body)) continue;
      const Eigen::Vector3f lever =
          centre_of_mass(model, frames, body) - frames.position[role_of(joint)];
      moment += lever.cast<double>().cross(
          Eigen::Vector3d(0, 0, 9.81 * static_cast<double>(model[body].mass_kg)));
    }
    torque += moment.norm();
  }
  EXPECT_NEAR(effort(still(pose), 0.5, 1), 0.5 * torque, 0.05 * torque * 0.5);
  EXPECT_GT(torque, 20);
}

TEST(JointEffort, AddsUpOverTime) {
  const motion::Pose pose = motion::rest_pose(motion::default_character().skeleton);
  const double whole = effort(still(pose), 0.25, 1);
  EXPECT_NEAR(effort(still(pose), 0.25, 0.75) + effort(still(pose), 0.75, 1), whole, 0.03 * whole);
}

TEST(JointEffort, OfAFasterMotionIsGreater) {
  const motion::Pose from = motion::rest_pose(motion::default_character().skeleton);
  const auto raise = [&](double duration_s) {
    motion::Motion motion = still(from);
    for (std::size_t k = 0; k < motion.poses.size(); ++k) {
      const double part = std::clamp(static_cast<double>(k) / 60 / duration_s, 0.0, 1.0);
      motion.poses[k].rotation[motion::Role::left_upper_arm] = motion::rotation_about(
          Eigen::Vector3f::UnitZ(), static_cast<float>(-1.5 * part * part * (3 - 2 * part)));
    }
    return effort(motion, 0, 1);
  };
  EXPECT_GT(raise(0.2), 1.1 * raise(0.8));
}

// Section 6.2.1: the muscles of the back of the hand are weaker. Lifting an outstretched hand by
// its back, against its weight, is extension; holding it palm up, the other way, is not.
TEST(JointEffort, CountsTorqueThatPullsTheBackOfAHandMore) {
  const sim::Simulator simulator(motion::default_character(), {});
  const auto of = [&](const motion::Pose& pose, double weight) {
    return joint_effort(simulator.figure_model(), simulator.rehearse(still(pose), 0.5, 1),
                        simulator.options().gravity_mps2, weight);
  };
  motion::Pose palm_down = motion::rest_pose(motion::default_character().skeleton);
  motion::Pose palm_up = palm_down;
  for (const motion::Role role : {motion::Role::left_forearm, motion::Role::right_forearm})
    palm_up.rotation[role] = motion::rotation_about(Eigen::Vector3f::UnitY(), motion::radians(180));
  const motion::BodyModel model = make_body_model(motion::default_character());
  double weights = 0;  // moment of the hands about the wrists
  for (const Body hand : {Body::left_hand, Body::right_hand})
    weights +=
        9.81 * static_cast<double>(model[hand].mass_kg * std::abs(model[hand].centre_of_mass.y()));
  EXPECT_NEAR(of(palm_down, 3) - of(palm_down, 0), 3 * 0.5 * weights, 0.1 * 3 * 0.5 * weights);
  EXPECT_NEAR(of(palm_up, 3) - of(palm_up, 0), 0, 0.05 * 3 * 0.5 * weights);
  EXPECT_GT(weights, 0.5);
}

}  // namespace
}  // namespace flinch::evolve
