// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tests/reaction/reaction_scenes.h"

// Plays the reaction of one character that is hit, for the tests of reactions.
namespace flinch::scenes {

inline const motion::Physique& character() {
  static const motion::Physique man = motion::default_character();
  return man;
}

inline const std::vector<NamedMotion>& motions() {
  static const auto all = motions_by_rule(character().skeleton);
  return all;
}

inline std::shared_ptr<const sim::FigureModel> figure_model() {
  static const auto shared = reaction::make_figure_model(character());
  return shared;
}

inline const std::vector<ReactionCase>& cases() {
  static const auto all = random_reaction_cases(character(), motions(), 48, 5);
  return all;
}

inline const motion::BodyModel& model() {
  static const motion::BodyModel bodies = make_body_model(character());
  return bodies;
}

inline motion::JointFrames frames_of(const motion::Pose& pose) {
  return forward_kinematics(character().skeleton, pose);
}

/// Largest distance of a joint between two poses, m.
inline double distance(const motion::Pose& first, const motion::Pose& second) {
  const motion::JointFrames a = frames_of(first);
  const motion::JointFrames b = frames_of(second);
  double most = 0;
  for (motion::Role role : motion::kRoles) {
    most = std::max(most, static_cast<double>((a.position[role] - b.position[role]).norm()));
  }
  return most;
}

inline Eigen::Vector3d middle_of(motion::Body body, const motion::Pose& pose) {
  return centre_of_mass(model(), frames_of(pose), body).cast<double>();
}

inline motion::Motion held(const motion::Pose& pose) {
  motion::Motion motion;
  motion.poses.assign(61, pose);
  return motion;
}

inline const motion::Motion& standing() {
  static const motion::Motion still = held(standing(character().skeleton));
  return still;
}

/// A motion with arms stretched out sideways, one metre above the ground.
inline const motion::Motion& hovering() {
  static const motion::Motion still = [] {
    motion::Pose pose = motion::rest_pose(character().skeleton);
    pose.root_position.z() += 1;
    return held(pose);
  }();
  return still;
}

/// A ball that hits the middle of a part of a motionless figure, flying level, within 0.035 s.
inline ReactionCase aimed_at(motion::Body body, const Eigen::Vector3d& velocity,
                             double mass_kg = 0.27, const motion::Motion& still = standing()) {
  const Eigen::Vector3d place = middle_of(body, still.poses.front());
  features::Ball ball = aimed_ball(place, velocity, 0.035);
  ball.mass_kg = mass_kg;
  return {&still, ball, kFrame_s};
}

inline reaction::ReactionStatus advance(reaction::Reaction& reaction,
                                        const ReactionCase& reaction_case, double since_s,
                                        double dt_s) {
  const motion::Pose wanted = pose_at(*reaction_case.motion, reaction_case.begin_s + since_s);
  return reaction.advance(dt_s, wanted, wanted);
}

/// Returns the displayed poses, frame by frame, starting with the pose at begin().
inline std::vector<motion::Pose> play(reaction::Reaction& reaction,
                                      const ReactionCase& reaction_case, double duration_s,
                                      double frame_s = kFrame_s) {
  EXPECT_EQ(begin(reaction, reaction_case), reaction::ReactionStatus::ok);
  std::vector<motion::Pose> poses{reaction.pose()};
  for (int k = 1; k * frame_s < duration_s + 1e-9; ++k) {
    EXPECT_EQ(advance(reaction, reaction_case, k * frame_s, frame_s), reaction::ReactionStatus::ok);
    poses.push_back(reaction.pose());
  }
  return poses;
}

inline bool same_bits(const motion::Pose& first, const motion::Pose& second) {
  return std::memcmp(first.root_position.data(), second.root_position.data(), 3 * sizeof(float)) ==
             0 &&
         std::equal(first.rotation.begin(), first.rotation.end(), second.rotation.begin(),
                    [](const auto& a, const auto& b) { return a.coeffs() == b.coeffs(); });
}

inline bool same_bits(const std::vector<motion::Pose>& first,
                      const std::vector<motion::Pose>& second) {
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const auto& a, const auto& b) { return same_bits(a, b); });
}

}  // namespace flinch::scenes
