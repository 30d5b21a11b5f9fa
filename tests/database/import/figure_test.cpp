// SPDX-License-Identifier: MIT
// Figures of files whose joints, End Sites and OFFSETs are not where a human has them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "database/import/foot_drift.h"
#include "database/import/retarget.h"
#include "database/import/source_character.h"
#include "motion/default_character.h"
#include "motion/limb_ik.h"
#include "motion/rotation.h"
#include "tests/database/import/place_deviation.h"
#include "tests/database/import/synthetic_figure.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using motion::JointFrames;
using motion::Pose;
using motion::radians;
using motion::Role;
using tests::synthetic_bvh;
using tests::SyntheticRig;

constexpr double kFrameTime_s = 1.0 / 30;

const motion::Skeleton& character_skeleton() {
  static const motion::Skeleton kSkeleton = motion::default_character().skeleton;
  return kSkeleton;
}

// The feet stay where they are in the rest pose.
Pose with_feet_on_ground(const motion::Skeleton& figure, Pose pose) {
  const JointFrames rest = forward_kinematics(figure, motion::rest_pose(figure));
  for (motion::Limb leg : {motion::Limb::left_leg, motion::Limb::right_leg}) {
    const Role foot = motion::roles_of(leg).end;
    pose = with_limb_end(figure, pose, leg, rest.position[foot], Eigen::Quaternionf::Identity());
  }
  return pose;
}

// A figure that stands and then bends knees, trunk and arms.
std::vector<Pose> bows(const motion::Skeleton& figure, float largest) {
  std::vector<Pose> poses;
  for (int k = 0; k <= 30; ++k) {
    const float bend = largest * static_cast<float>(k) / 30;
    Pose pose = motion::rest_pose(figure);
    pose.root_position.z() -= 0.05F + 0.1F * static_cast<float>(k) / 30;
    pose.rotation[Role::abdomen] = motion::rotation_about(Vector3f::UnitY(), 0.6F * bend);
    pose.rotation[Role::chest] =
        motion::rotation_about(Vector3f(0.3F, 1, 0.4F).normalized(), 0.4F * bend);
    pose.rotation[Role::left_forearm] = motion::rotation_about(-Vector3f::UnitZ(), 0.5F + bend);
    poses.push_back(with_feet_on_ground(figure, pose));
  }
  return poses;
}

Bvh bow_file() {
  return synthetic_bvh(character_skeleton(), SyntheticRig(), bows(character_skeleton(), 0.5F),
                       kFrameTime_s);
}

BvhJoint& joint_of(Bvh& bvh, const std::string& name) {
  return *std::find_if(bvh.joints.begin(), bvh.joints.end(),
                       [&](const BvhJoint& joint) { return joint.name == name; });
}

// Calls `change(joint)` for the joints left_NAME and right_NAME.
template <class Change>
void change_both(Bvh& bvh, const std::string& name, Change change) {
  for (const char* side : {"left_", "right_"}) change(joint_of(bvh, side + name));
}

// Returns the file with position channels on every joint that hold `factor` times its OFFSET.
Bvh with_positions(const Bvh& bvh, double factor) {
  Bvh result = bvh;
  result.values.clear();
  result.channel_count = 0;
  for (BvhJoint& joint : result.joints) {
    if (joint.parent >= 0) {
      joint.channels.insert(joint.channels.begin(), {BvhChannel::x_position, BvhChannel::y_position,
                                                     BvhChannel::z_position});
    }
    joint.first_channel = result.channel_count;
    result.channel_count += static_cast<int>(joint.channels.size());
  }
  for (int frame = 0; frame < bvh.frame_count; ++frame) {
    for (const BvhJoint& joint : bvh.joints) {
      if (joint.parent >= 0) {
        for (int axis = 0; axis < 3; ++axis) result.values.push_back(factor * joint.offset[axis]);
      }
      const auto first = bvh.values.begin() + frame * bvh.channel_count + joint.first_channel;
      result.values.insert(result.values.end(), first,
                           first + static_cast<std::ptrdiff_t>(joint.channels.size()));
    }
  }
  return result;
}

motion::Motion retargeted(const Source& source, const motion::Skeleton& figure) {
  const SourceMotion motion = source_motion(source);
  return retarget(motion, figure, {0, motion.duration_s(), 0},
                  static_cast<float>(1 / motion.frame_time_s));
}

tests::PlaceDeviation deviation_of(const Source& source) {
  const motion::Skeleton figure = character_of(source).skeleton;
  const Segment whole{0, source.bvh.duration_s(), 0};
  return tests::largest(tests::place_deviations(source, figure, whole, retargeted(source, figure)));
}

// Moves the joints of the spine to other heights; shoulders and head stay.
motion::Skeleton with_spine(float abdomen_up, float chest_up) {
  motion::Skeleton moved = character_skeleton();
  moved.offset[Role::abdomen].z() += abdomen_up;
  moved.offset[Role::chest].z() += chest_up - abdomen_up;
  for (Role role : {Role::neck, Role::left_clavicle, Role::right_clavicle}) {
    moved.offset[role].z() -= chest_up;
  }
  return moved;
}

TEST(Trunk, FollowsSourcesWhoseSpineBendsElsewhere) {
  // The chest's joint at the shoulders and above them; both joints low, which allows for less:
  // below its own abdomen the character cannot bend; and no difference.
  struct Spine {
    float abdomen_up, chest_up, bow;
  };
  for (const auto& [abdomen_up, chest_up, bow] :
       {Spine{0.08F, 0.16F, 1.6F}, {0.10F, 0.20F, 1.6F}, {-0.08F, -0.10F, 0.8F}, {0, 0, 1.6F}}) {
    const motion::Skeleton moved = with_spine(abdomen_up, chest_up);
    for (bool has_neck : {true, false}) {
      SyntheticRig rig;
      if (!has_neck) rig.names[Role::neck].clear();
      const Source source =
          analyse_source(synthetic_bvh(moved, rig, bows(moved, bow), kFrameTime_s));
      const tests::PlaceDeviation deviation = deviation_of(source);
      EXPECT_LT(deviation.head, 0.03F) << chest_up;
      EXPECT_LT(deviation.shoulder, 0.03F) << chest_up;
      EXPECT_LT(deviation.hand, 0.03F) << chest_up;
    }
  }
}

TEST(Trunk, BendsSmoothlyWhereTheSourcesSpineIsNearlyStraight) {
  // A spine whose length flickers by 4 mm would fold by many degrees if its end were to follow.
  const Source source = analyse_source(bow_file());
  SourceMotion motion = source_motion(source);
  const SourceFrame slightly_bent = motion.frames[6];
  motion.frames.assign(2, slightly_bent);
  motion.frames[1].trunk.shoulders *= 0.99F;
  motion.frames[1].trunk.head *= 0.99F;
  const motion::Motion clip =
      retarget(motion, character_skeleton(), {0, motion.duration_s(), 0}, 30);
  for (Role role : {Role::abdomen, Role::chest, Role::neck}) {
    EXPECT_LT(clip.poses[0].rotation[role].angularDistance(clip.poses[1].rotation[role]),
              radians(5))
        << motion::name_of(role);
  }
}

// The ball of the foot and the length of the hand in the character of a file.
struct Ends {
  float forward, down, toes, hand;
};
Ends ends_of(const Bvh& bvh) {
  const motion::Skeleton figure = character_of(analyse_source(bvh)).skeleton;
  const Vector3f ball = figure.offset[Role::left_toes];
  return {ball.x(), -ball.z(), figure.tip[Role::left_toes].x(), figure.tip[Role::left_hand].y()};
}

// Numbers of the default character: ball 0.125 m forward of and 0.047 m below the ankle, toes 0.074
// m, hand 0.189 m.
void expect_human(const Ends& ends) {
  EXPECT_NEAR(ends.forward, 0.125F, 0.01F);
  EXPECT_NEAR(ends.down, 0.047F, 0.01F);
  EXPECT_NEAR(ends.toes, 0.074F, 0.01F);
  EXPECT_NEAR(ends.hand, 0.189F, 0.01F);
}

TEST(HumanEnds, AreKeptWhereTheyArePossible) {
  expect_human(ends_of(bow_file()));
}

TEST(HumanEnds, ReplaceStubs) {
  Bvh bvh = bow_file();
  change_both(bvh, "hand", [](BvhJoint& hand) { hand.end_sites = {Vector3d(0.01, 0, 0)}; });
  change_both(bvh, "toes", [](BvhJoint& toes) { toes.end_sites = {Vector3d(0, -0.01, 0)}; });
  expect_human(ends_of(bvh));
}

TEST(HumanEnds, ReplaceTailsThatPointUp) {
  SyntheticRig rig;
  rig.names[Role::left_toes].clear();
  rig.names[Role::right_toes].clear();
  Bvh bvh =
      synthetic_bvh(character_skeleton(), rig, bows(character_skeleton(), 0.5F), kFrameTime_s);
  for (const Vector3d& tail : {Vector3d(0, 14, 0), Vector3d(0, -14, 0), Vector3d(0, 0, -14)}) {
    change_both(bvh, "foot", [&](BvhJoint& foot) { foot.end_sites = {tail}; });
    change_both(bvh, "hand", [](BvhJoint& hand) { hand.end_sites = {Vector3d(0, 18, 0)}; });
    expect_human(ends_of(bvh));
  }
}

TEST(HumanEnds, ReplaceToesOnTheAnkle) {
  Bvh bvh = bow_file();
  change_both(bvh, "toes", [](BvhJoint& toes) {
    toes.offset.setZero();
    toes.end_sites = {Vector3d(0, -0.1, 0)};
  });
  expect_human(ends_of(bvh));
}

TEST(HumanEnds, DivideAFootWhoseOnlyEndIsTheTipOfTheToes) {
  // The tip of the toes is 20.0 cm forward of the ankle.
  Bvh bvh = bow_file();
  change_both(bvh, "toes", [](BvhJoint& toes) {
    toes.offset = {0, -4.7, 0};
    toes.end_sites = {Vector3d(0, 0, 20)};
  });
  expect_human(ends_of(bvh));
  const Source source = analyse_source(bvh);
  EXPECT_FALSE(source.figure.has(Role::left_toes));
  EXPECT_EQ(
      source.bvh.joints[static_cast<std::size_t>(source.figure.carrier[Role::left_foot])].name,
      "left_toes");
}

TEST(PositionChannels, GiveTheBonesTheirLengths) {
  Bvh bvh = with_positions(bow_file(), 1);
  change_both(bvh, "shin", [](BvhJoint& joint) { joint.offset *= 1.04; });
  change_both(bvh, "foot", [](BvhJoint& joint) { joint.offset *= 1.04; });
  const Source source = analyse_source(bvh);
  const motion::Skeleton figure = character_of(source).skeleton;
  for (Role role : {Role::left_shin, Role::left_foot}) {
    EXPECT_NEAR(figure.offset[role].norm(), character_skeleton().offset[role].norm(), 1e-4F);
  }
  EXPECT_TRUE(source.report.warnings.empty());
}

TEST(PositionChannels, MayBeDisplacementsFromTheOffsets) {
  const Source source = analyse_source(with_positions(bow_file(), 0));
  EXPECT_THAT(source.report.warnings, testing::ElementsAre(testing::HasSubstr("are added")));
  const Source plain = analyse_source(bow_file());
  const motion::Motion one = retargeted(source, character_skeleton());
  const motion::Motion other = retargeted(plain, character_skeleton());
  for (Role role : motion::kRoles) {
    EXPECT_LT(one.poses.back().rotation[role].angularDistance(other.poses.back().rotation[role]),
              1e-3F);
  }
}

TEST(Crouch, RaisesThePelvisWhereALegCannotFold) {
  // Heels and buttocks meet: the knees bend by about 165 degrees.
  std::vector<Pose> poses;
  const motion::HingeLimits wide{0.01F, 3.1F};
  const JointFrames rest =
      forward_kinematics(character_skeleton(), motion::rest_pose(character_skeleton()));
  for (int k = 0; k <= 30; ++k) {
    Pose pose = motion::rest_pose(character_skeleton());
    const float hips = 0.86F - 0.75F * static_cast<float>(k) / 30;  // above the ankles
    pose.root_position.z() += hips - 0.859F;
    pose.root_position.x() -= 0.03F;
    for (motion::Limb leg : {motion::Limb::left_leg, motion::Limb::right_leg}) {
      const JointFrames frames = forward_kinematics(character_skeleton(), pose);
      const motion::LimbRoles roles = motion::roles_of(leg);
      const motion::LimbSolution bent =
          solve_limb(character_skeleton(), leg, frames.position[roles.upper],
                     rest.position[roles.end], Vector3f::UnitX(), 0, wide);
      pose.rotation[roles.upper] = bent.upper;
      pose.rotation[roles.lower] = bent.upper.conjugate() * bent.lower;
      pose.rotation[roles.end] = bent.lower.conjugate();
    }
    poses.push_back(pose);
  }
  const Source source =
      analyse_source(synthetic_bvh(character_skeleton(), SyntheticRig(), poses, kFrameTime_s));
  const SourceMotion motion = source_motion(source);
  const Segment whole{0, motion.duration_s(), 0};
  const motion::Motion clip = retarget(motion, character_skeleton(), whole, 30);
  const FootDrift drift = measure_foot_drift(motion, character_skeleton(), whole, clip);
  EXPECT_GT(drift.lowest_sole_m, -0.012F);
  EXPECT_LT(drift.added_m, 0.01F);
  EXPECT_GT(clip.poses.back().root_position.z(), poses.back().root_position.z() + 0.05F);
}

void write_joint(const Bvh& bvh, std::size_t index, std::ostream& text) {
  constexpr std::array<const char*, 6> kChannels{" Xposition", " Yposition", " Zposition",
                                                 " Xrotation", " Yrotation", " Zrotation"};
  const BvhJoint& joint = bvh.joints[index];
  const auto offset = [&](const Vector3d& at) { text << "OFFSET " << at.transpose() << '\n'; };
  text << (joint.parent < 0 ? "ROOT " : "JOINT ") << joint.name << "\n{\n";
  offset(joint.offset);
  text << "CHANNELS " << joint.channels.size();
  for (BvhChannel channel : joint.channels) text << kChannels[static_cast<std::size_t>(channel)];
  text << '\n';
  for (const Vector3d& end : joint.end_sites) {
    text << "End Site\n{\n";
    offset(end);
    text << "}\n";
  }
  for (std::size_t i = index + 1; i < bvh.joints.size(); ++i) {
    if (bvh.joints[i].parent == static_cast<int>(index)) write_joint(bvh, i, text);
  }
  text << "}\n";
}

// For figures whose joints are in the order of their depth-first traversal, as channels are.
std::string text_of(const Bvh& bvh) {
  std::ostringstream text;
  text << std::setprecision(10) << "HIERARCHY\n";
  write_joint(bvh, 0, text);
  text << "MOTION\nFrames: " << bvh.frame_count << "\nFrame Time: " << bvh.frame_time_s << '\n';
  for (std::size_t i = 0; i < bvh.values.size(); ++i) {
    text << bvh.values[i]
         << ((i + 1) % static_cast<std::size_t>(bvh.channel_count) == 0 ? '\n' : ' ');
  }
  return text.str();
}

// A guard in a file whose OFFSETs do not stand.
TEST(RestFile, ShowsHowAFigureStandsThatNeverDoes) {
  std::vector<Pose> guard = bows(character_skeleton(), 0.8F);
  for (Pose& pose : guard) {
    pose.rotation[Role::pelvis] = motion::rotation_about(Vector3f::UnitY(), 0.2F);
    pose.rotation[Role::head] = motion::rotation_about(Vector3f::UnitZ(), 0.6F);
    pose = with_feet_on_ground(character_skeleton(), pose);
  }
  SyntheticRig lying;
  lying.rest.rotation[Role::left_thigh] = motion::rotation_about(Vector3f::UnitY(), 3.1F);
  lying.rest.rotation[Role::right_thigh] = motion::rotation_about(Vector3f::UnitY(), 3.1F);
  lying.rest.rotation[Role::abdomen] = motion::rotation_about(Vector3f::UnitY(), 1.5F);
  const Bvh take = synthetic_bvh(character_skeleton(), lying, guard, kFrameTime_s);
  const Bvh standing = synthetic_bvh(character_skeleton(), lying,
                                     {motion::rest_pose(character_skeleton())}, kFrameTime_s);

  const tests::TemporaryFolder folder;
  SourceOptions options;
  options.rest = folder.write("standing.bvh", text_of(standing));
  const Source own = analyse_source(take);
  const Source source = analyse_source(take, options);
  const auto head_error = [&](const Source& of) {
    const motion::Motion clip = retargeted(of, character_skeleton());
    const JointFrames frames = forward_kinematics(character_skeleton(), clip.poses.front());
    const JointFrames wanted = forward_kinematics(character_skeleton(), guard.front());
    const auto relative = [](const JointFrames& joints) {
      return joints.orientation[Role::pelvis].conjugate() * joints.orientation[Role::head];
    };
    return relative(frames).angularDistance(relative(wanted));
  };
  EXPECT_GT(head_error(own), radians(15));
  EXPECT_LT(head_error(source), radians(1));

  Bvh longer = standing;
  joint_of(longer, "left_shin").offset *= 1.1;
  options.rest = folder.write("longer.bvh", text_of(longer));
  EXPECT_THAT(tests::error_of([&] { analyse_source(take, options); }),
              testing::HasSubstr("its skeleton is not that of made.bvh"));
}

}  // namespace
}  // namespace flinch::database
