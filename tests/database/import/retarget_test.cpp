// SPDX-License-Identifier: MIT
#include "database/import/retarget.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "database/import/foot_drift.h"
#include "database/import/source_character.h"
#include "motion/default_character.h"
#include "motion/limb_ik.h"
#include "tests/database/import/synthetic_figure.h"

namespace flinch::database {
namespace {

using Eigen::AngleAxisf;
using Eigen::Quaternionf;
using Eigen::Vector3f;
using motion::JointFrames;
using motion::kRoles;
using motion::Limb;
using motion::Pose;
using motion::Role;
using tests::synthetic_bvh;
using tests::SyntheticRig;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr double kFrameTime = 1.0 / 60;

const motion::Skeleton& skeleton() {
  static const motion::Skeleton kSkeleton = motion::default_character().skeleton;
  return kSkeleton;
}

Quaternionf random_rotation(std::mt19937& random, float max_angle) {
  std::normal_distribution<float> normal;
  std::uniform_real_distribution<float> uniform(-max_angle, max_angle);
  const Vector3f axis = Vector3f(normal(random), normal(random), normal(random)).normalized();
  return Quaternionf(AngleAxisf(uniform(random), axis));
}

// Random poses of a figure that stands on its feet with bent knees; trunk and arms are arbitrary,
// but the elbows bend only about their hinges.
std::vector<Pose> standing_poses(int count, unsigned seed) {
  std::mt19937 random(seed);
  const JointFrames rest = forward_kinematics(skeleton(), motion::rest_pose(skeleton()));
  std::vector<Pose> poses;
  for (int k = 0; k < count; ++k) {
    std::uniform_real_distribution<float> uniform(0, 1);
    Pose pose = motion::rest_pose(skeleton());
    pose.root_position +=
        Vector3f(0.1F * uniform(random), 0.1F * uniform(random), -0.05F - 0.25F * uniform(random));
    for (Role role :
         {Role::pelvis, Role::abdomen, Role::chest, Role::neck, Role::head, Role::left_clavicle,
          Role::right_clavicle, Role::left_hand, Role::right_hand}) {
      pose.rotation[role] = random_rotation(random, 0.3F);
    }
    for (Role role : {Role::left_upper_arm, Role::right_upper_arm}) {
      pose.rotation[role] = random_rotation(random, 1.2F);
    }
    for (Limb arm : {Limb::left_arm, Limb::right_arm}) {
      const float bend = 0.3F + 1.5F * uniform(random);
      pose.rotation[motion::roles_of(arm).lower] = AngleAxisf(bend, motion::hinge_axis(arm));
    }
    for (Limb leg : {Limb::left_leg, Limb::right_leg}) {
      pose = with_limb_end(skeleton(), pose, leg, rest.position[motion::roles_of(leg).end],
                           Quaternionf::Identity());
    }
    poses.push_back(pose);
  }
  return poses;
}

SourceMotion understood(const SyntheticRig& rig, const std::vector<Pose>& poses) {
  return source_motion(analyse_source(synthetic_bvh(skeleton(), rig, poses, kFrameTime)));
}

// Places both alike: the pelvis of the first pose above the origin and facing +X.
Pose placed_like_first(const Pose& pose, const Pose& first) {
  const float yaw = [&] {
    const Vector3f left = first.rotation[Role::pelvis] * Vector3f::UnitY();
    return -std::atan2(-left.x(), left.y());
  }();
  Vector3f shift = -(AngleAxisf(yaw, Vector3f::UnitZ()) * first.root_position);
  shift.z() = 0;
  return motion::placed(pose, yaw, shift);
}

void expect_same_motion(const motion::Motion& motion, const std::vector<Pose>& poses,
                        float tolerance_m) {
  ASSERT_EQ(motion.poses.size(), poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const JointFrames expected =
        forward_kinematics(skeleton(), placed_like_first(poses[k], poses.front()));
    const JointFrames found = forward_kinematics(skeleton(), motion.poses[k]);
    for (Role role : kRoles) {
      EXPECT_LT((found.position[role] - expected.position[role]).norm(), tolerance_m)
          << "pose " << k << ", " << motion::name_of(role);
      EXPECT_LT(found.orientation[role].angularDistance(expected.orientation[role]), 0.02F)
          << "pose " << k << ", " << motion::name_of(role);
    }
  }
}

Segment whole(const SourceMotion& source) {
  return {0, source.duration_s(), 0};
}

// A rest figure whose arms hang `angle` below the horizontal.
Pose arms_lowered(float angle) {
  Pose rest;
  rest.rotation[Role::left_upper_arm] = AngleAxisf(-angle, Vector3f::UnitX());
  rest.rotation[Role::right_upper_arm] = AngleAxisf(angle, Vector3f::UnitX());
  return rest;
}

TEST(Retarget, ReproducesItsOwnMotionForAnyRestFigure) {
  const std::vector<Pose> poses = standing_poses(40, 1);
  for (float degrees : {0.0F, 45.0F, 90.0F}) {
    SyntheticRig rig;
    rig.rest = arms_lowered(degrees * kPi / 180);
    const SourceMotion source = understood(rig, poses);
    expect_same_motion(retarget(source, skeleton(), whole(source), 60), poses, 2e-3F);
  }
}

TEST(Retarget, FindsUnitsAndUpAxis) {
  const std::vector<Pose> poses = standing_poses(20, 2);
  const std::pair<double, LengthUnit> units[] = {{1, LengthUnit::metre},
                                                 {100, LengthUnit::centimetre},
                                                 {1000, LengthUnit::millimetre},
                                                 {1 / 0.0254, LengthUnit::inch},
                                                 {0.45 / 0.0254, LengthUnit::cmu}};
  for (const auto& [units_per_metre, unit] : units) {
    for (UpAxis up :
         {UpAxis::x, UpAxis::y, UpAxis::z, UpAxis::minus_x, UpAxis::minus_y, UpAxis::minus_z}) {
      SyntheticRig rig;
      rig.units_per_metre = units_per_metre;
      rig.axes = to_world(up).conjugate();
      const Source source = analyse_source(synthetic_bvh(skeleton(), rig, poses, kFrameTime));
      EXPECT_EQ(source.report.unit, unit);
      EXPECT_EQ(source.report.up, up);
      EXPECT_EQ(source.report.reference_frame, -1);
      const SourceMotion motion = source_motion(source);
      expect_same_motion(retarget(motion, skeleton(), whole(motion), 60), poses, 2e-3F);
    }
  }
}

TEST(Retarget, UsesTheMotionsReferencePoseIfTheOffsetsDoNotStand) {
  std::vector<Pose> poses = standing_poses(30, 3);
  poses[7] = motion::rest_pose(skeleton());
  SyntheticRig rig;
  rig.rest.rotation[Role::left_thigh] = AngleAxisf(kPi, Vector3f::UnitY());
  rig.rest.rotation[Role::right_thigh] = AngleAxisf(kPi, Vector3f::UnitY());
  rig.rest.rotation[Role::abdomen] = AngleAxisf(kPi / 2, Vector3f::UnitY());
  const Source source = analyse_source(synthetic_bvh(skeleton(), rig, poses, kFrameTime));
  EXPECT_EQ(source.report.reference_frame, 7);
  const SourceMotion motion = source_motion(source);
  expect_same_motion(retarget(motion, skeleton(), whole(motion), 60), poses, 3e-3F);
}

TEST(Retarget, StartsAtTheOriginWithTheActorFacingForward) {
  std::vector<Pose> poses = standing_poses(40, 4);
  for (Pose& pose : poses) pose = motion::placed(pose, 2.0F, {3, -4, 0});
  const SourceMotion source = understood(SyntheticRig(), poses);
  Segment segment = whole(source);
  segment.start_s = 0.25;
  segment.heading = 0.4;
  const motion::Motion motion = retarget(source, skeleton(), segment, 60);
  const Pose& first = motion.poses.front();
  EXPECT_NEAR(first.root_position.x(), 0, 1e-5);
  EXPECT_NEAR(first.root_position.y(), 0, 1e-5);
  // The actor faces +X; `heading` is the angle from the pelvis' facing to the actor's.
  const Vector3f left = first.rotation[Role::pelvis] * Vector3f::UnitY();
  EXPECT_NEAR(std::atan2(-left.x(), left.y()), -0.4, 1e-4);
}

TEST(Retarget, ResamplesByTime) {
  const std::vector<Pose> poses = standing_poses(31, 5);
  const SourceMotion source = understood(SyntheticRig(), poses);
  const Segment segment{0.1, 0.4, 0};
  EXPECT_EQ(retarget(source, skeleton(), segment, 60).poses.size(), 19U);
  EXPECT_EQ(retarget(source, skeleton(), segment, 100).poses.size(), 31U);
  // Halfway between two frames the head has turned halfway.
  const SourceFrame between = sample(source, 2.5 / 60);
  const Quaternionf& one = source.frames[2].orientation[Role::head];
  const Quaternionf& other = source.frames[3].orientation[Role::head];
  EXPECT_NEAR(between.orientation[Role::head].angularDistance(one),
              between.orientation[Role::head].angularDistance(other), 1e-3);
}

TEST(Retarget, QuaternionsAreSignContinuous) {
  const std::vector<Pose> poses = standing_poses(60, 6);
  const SourceMotion source = understood(SyntheticRig(), poses);
  const motion::Motion motion = retarget(source, skeleton(), whole(source), 60);
  for (std::size_t k = 1; k < motion.poses.size(); ++k) {
    for (Role role : kRoles) {
      EXPECT_GE(motion.poses[k].rotation[role].dot(motion.poses[k - 1].rotation[role]), 0);
    }
  }
}

TEST(Retarget, ScalesByLegLength) {
  motion::Skeleton small = skeleton();
  for (Role role : kRoles) {
    small.offset[role] *= 0.5F;
    small.tip[role] *= 0.5F;
  }
  const std::vector<Pose> poses = standing_poses(30, 7);
  const SourceMotion source = understood(SyntheticRig(), poses);
  EXPECT_NEAR(leg_ratio(source, small), 0.5, 1e-4);
  const motion::Motion motion = retarget(source, small, whole(source), 60);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Pose expected = placed_like_first(poses[k], poses.front());
    EXPECT_LT((motion.poses[k].root_position - 0.5F * expected.root_position).norm(), 2e-3F);
  }
}

TEST(FootDrift, IsZeroOnTheOwnSkeletonAndMeasuresAddedDrift) {
  std::vector<Pose> poses = standing_poses(1, 8);
  poses.resize(61, poses.front());
  const SourceMotion source = understood(SyntheticRig(), poses);
  const Segment segment = whole(source);
  motion::Motion motion = retarget(source, skeleton(), segment, 60);
  const FootDrift still = measure_foot_drift(source, skeleton(), segment, motion);
  EXPECT_LT(still.added_m, 1e-4F);
  EXPECT_LT(still.source_m, 1e-4F);
  EXPECT_NEAR(still.planted_s, 4.0F, 1e-3F);  // two ankles and two balls for one second
  EXPECT_NEAR(still.lowest_sole_m, 0, 2e-3F);

  for (std::size_t k = 0; k < motion.poses.size(); ++k) {
    motion.poses[k].root_position.x() += 0.02F * static_cast<float>(k) / 60;
  }
  const FootDrift slid = measure_foot_drift(source, skeleton(), segment, motion);
  EXPECT_NEAR(slid.added_m, 0.02F, 1e-4F);
}

TEST(SourceCharacter, HasSymmetricBonesOfTheSourcesLengths) {
  const Source source =
      analyse_source(synthetic_bvh(skeleton(), SyntheticRig(), standing_poses(3, 9), kFrameTime));
  const motion::Physique character = character_of(source);
  for (Role role : kRoles) {
    EXPECT_LT((character.skeleton.offset[role] - skeleton().offset[role]).norm(), 2e-3F)
        << motion::name_of(role);
    Vector3f other = character.skeleton.offset[motion::mirrored(role)];
    other.y() = -other.y();
    if (motion::mirrored(role) == role) continue;
    EXPECT_EQ(other, character.skeleton.offset[role]);
  }
  EXPECT_NEAR(character.mass_kg, 23 * 1.75F * 1.75F, 0.2F);
}

TEST(SourceCharacter, FillsMissingBonesInProportion) {
  SyntheticRig rig;
  for (Role role : {Role::abdomen, Role::neck, Role::left_clavicle, Role::right_clavicle,
                    Role::left_hand, Role::right_hand, Role::left_toes, Role::right_toes}) {
    rig.names[role].clear();
  }
  const Source source =
      analyse_source(synthetic_bvh(skeleton(), rig, standing_poses(3, 10), kFrameTime));
  const motion::Physique character = character_of(source);
  const JointFrames found =
      forward_kinematics(character.skeleton, motion::rest_pose(character.skeleton));
  const JointFrames expected = forward_kinematics(skeleton(), motion::rest_pose(skeleton()));
  for (Role role : kRoles) {
    EXPECT_LT((found.position[role] - expected.position[role]).norm(), 0.03F)
        << motion::name_of(role);
  }
}

TEST(SourceCharacter, TakesHeightMassAndSexFromTheOptions) {
  const Source source =
      analyse_source(synthetic_bvh(skeleton(), SyntheticRig(), standing_poses(3, 11), kFrameTime));
  CharacterOptions options;
  options.height_m = 1.6F;
  options.mass_kg = 55;
  options.sex = motion::Sex::female;
  const motion::Physique character = character_of(source, options);
  const JointFrames rest =
      forward_kinematics(character.skeleton, motion::rest_pose(character.skeleton));
  EXPECT_NEAR(rest.position[Role::head].z() + character.skeleton.tip[Role::head].z(), 1.6, 1e-4);
  EXPECT_EQ(character.mass_kg, 55);
  EXPECT_EQ(character.sex, motion::Sex::female);
}

}  // namespace
}  // namespace flinch::database
