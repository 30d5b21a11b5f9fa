// SPDX-License-Identifier: MIT
#include "database/import/limb_match.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/database/import/named_rigs.h"
#include "tests/database/import/synthetic_figure.h"
#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

using motion::Role;
using testing::HasSubstr;
using tests::error_of;
using tests::expect_roles;
using tests::insert_above;
using tests::joint_named;
using tests::joint_of;
using tests::named_figure;
using tests::names_in;
using tests::rig_names;

void add_below(Bvh& bvh, const std::string& above, const std::string& name,
               const Eigen::Vector3d& offset) {
  BvhJoint added;
  added.name = name;
  added.parent = static_cast<int>(joint_named(bvh, above));
  added.offset = offset;
  bvh.joints.push_back(added);
}

TEST(Limbs, ReadsAHandBelowTheWristAsFingers) {
  for (const char* title : {"SMPL", "Kinect", "Azure Kinect"}) {
    Bvh bvh = named_figure(names_in(title));
    for (Role wrist : {Role::left_hand, Role::right_hand}) {
      std::string hand = names_in(title)[wrist];
      const std::size_t at = hand.find(title == std::string("Azure Kinect") ? "WRIST" : "Wrist");
      hand.replace(at, 5, title == std::string("Azure Kinect") ? "HAND" : "Hand");
      add_below(bvh, names_in(title)[wrist], hand, {wrist == Role::left_hand ? 9.0 : -9.0, 0, 0});
    }
    expect_roles(bvh, names_in(title));
  }
}

std::string on_the_right(std::string name) {
  const std::pair<std::string, std::string> sides[] = {{".L", ".R"}, {"_L", "_R"}, {"左", "右"}};
  for (const auto& [left, right] : sides) {
    const std::size_t at = name.find(left);
    if (at != std::string::npos) return name.replace(at, left.size(), right);
  }
  name.front() = 'r';
  return name;
}

TEST(Limbs, TakesTheSecondPartOfABoneForNoJoint) {
  struct Part {
    const char* rig;
    const char* below;
    const char* name;
  };
  // Daz Genesis, MMD, MakeHuman and Rigify have twist bones between a bone and the next.
  const Part parts[] = {
      {"Daz Genesis 3 and 8", "lShin", "lThighTwist"},
      {"Daz Genesis 3 and 8", "lForearmBend", "lShldrTwist"},
      {"Daz Genesis 3 and 8", "lHand", "lForearmTwist"},
      {"Daz Genesis 3 and 8", "lToe", "lMetatarsals"},
      {"MMD, Japanese", "左ひじ", "左腕捩"},
      {"MMD, Japanese", "左手首", "左手捩"},
      {"MMD, English", "elbow_L", "arm twist_L"},
      {"MakeHuman", "upperarm01.L", "shoulder01.L"},
      {"MakeHuman", "lowerarm01.L", "upperarm02.L"},
      {"MakeHuman", "lowerleg01.L", "upperleg02.L"},
      {"Rigify's deform bones", "DEF-shin.L", "DEF-thigh.L.001"},
      {"Rigify's deform bones", "DEF-hand.L", "DEF-forearm.L.001"},
  };
  for (const Part& part : parts) {
    SCOPED_TRACE(part.name);
    Bvh bvh = named_figure(names_in(part.rig));
    insert_above(bvh, part.below, part.name, 0.5);
    insert_above(bvh, on_the_right(part.below), on_the_right(part.name), 0.5);
    expect_roles(bvh, names_in(part.rig));
  }
}

TEST(Limbs, RefusesAJointWithLengthBetweenTwoRoles) {
  Bvh bvh = named_figure(names_in("LaFAN1"));
  insert_above(bvh, "LeftFoot", "Zorp", 0.5);
  EXPECT_THAT(error_of([&] { map_roles(bvh); }),
              HasSubstr("the joint Zorp between left_shin (LeftLeg) and left_foot (LeftFoot) has a "
                        "length but no role; map both"));
  const RoleMap map = map_roles(bvh, {{Role::left_shin, "LeftLeg"}, {Role::left_foot, "LeftFoot"}});
  EXPECT_EQ(joint_of(bvh, map, Role::left_foot), "LeftFoot");
  bvh.joints[joint_named(bvh, "Zorp")].offset.setZero();
  EXPECT_EQ(joint_of(bvh, map_roles(bvh), Role::left_foot), "LeftFoot");
}

// Each bone is named after the joint at its far end: the thigh is KneeLeft.
TEST(Limbs, FindsLimbsThatAreNamedAfterTheirFarEnds) {
  motion::PerRole<std::string> names =
      rig_names({"SpineBase", "SpineMid", "SpineShoulder", "Neck", "Head"},
                {"ShoulderLeft", "ElbowLeft", "WristLeft", "HandLeft"},
                {"KneeLeft", "AnkleLeft", "FootLeft", "-"}, "Left", "Right");
  Bvh bvh = named_figure(names);
  insert_above(bvh, "KneeLeft", "HipLeft", 0);
  insert_above(bvh, "KneeRight", "HipRight", 0);
  for (const char* clavicle : {"ShoulderLeft", "ShoulderRight"}) {
    BvhJoint& joint = bvh.joints[joint_named(bvh, clavicle)];
    for (BvhJoint& below : bvh.joints) {
      if (below.parent == static_cast<int>(joint_named(bvh, clavicle)))
        below.offset += joint.offset;
    }
    joint.offset.setZero();
  }
  expect_roles(bvh, names);
}

TEST(Limbs, TakesAToeJointAtTheAnkleForTheFoot) {
  motion::PerRole<std::string> names = names_in("LaFAN1");
  for (Role role : {Role::left_foot, Role::right_foot}) {
    names[role] = role == Role::left_foot ? "LeftToe" : "RightToe";
  }
  names[Role::left_toes].clear();
  names[Role::right_toes].clear();
  expect_roles(named_figure(names), names);
}

TEST(Limbs, MapsMirroredLimbsAlike) {
  const motion::PerRole<std::string>& names = names_in("Perception Neuron");
  Bvh bvh = named_figure(names);
  // A second foot, first in the file, at another distance: the left foot tells which one is meant.
  const std::size_t shin = joint_named(bvh, "RightLeg");
  BvhJoint decoy;
  decoy.name = "RightFoot";
  decoy.parent = static_cast<int>(shin);
  decoy.offset = 0.6 * bvh.joints[joint_named(bvh, "RightFoot")].offset;
  for (BvhJoint& joint : bvh.joints) {
    if (joint.parent > static_cast<int>(shin)) ++joint.parent;
  }
  bvh.joints.insert(bvh.joints.begin() + static_cast<std::ptrdiff_t>(shin) + 1, decoy);
  EXPECT_EQ(map_roles(bvh).joint[Role::right_foot], static_cast<int>(shin) + 2);
}

TEST(Limbs, RefusesMirroredBonesOfVeryDifferentLengths) {
  Bvh bvh = named_figure(names_in("LaFAN1"));
  bvh.joints[joint_named(bvh, "RightLeg")].offset *= 2.5;
  bvh.joints[joint_named(bvh, "RightFoot")].offset *= 2.5;
  EXPECT_THAT(error_of([&] { map_roles(bvh); }),
              HasSubstr("left_thigh (LeftUpLeg) is more than twice as long or short as right_thigh "
                        "(RightUpLeg)"));
}

TEST(Limbs, RefusesLengthsThatNoHumanHas) {
  Bvh bvh = named_figure(names_in("LaFAN1"));
  for (const char* shin : {"LeftLeg", "RightLeg"}) {
    bvh.joints[joint_named(bvh, shin)].offset *= 0.2;
  }
  EXPECT_THAT(
      error_of([&] { map_roles(bvh); }),
      HasSubstr("no human has bones as long as those of left_thigh (LeftUpLeg), left_shin"));
}

TEST(Limbs, RefusesTwoHipsAtOnePlace) {
  Bvh bvh = named_figure(names_in("LaFAN1"));
  bvh.joints[joint_named(bvh, "LeftUpLeg")].offset.setZero();
  bvh.joints[joint_named(bvh, "RightUpLeg")].offset.setZero();
  EXPECT_THAT(error_of([&] { map_roles(bvh); }),
              HasSubstr("left_thigh (LeftUpLeg) and right_thigh (RightUpLeg) are at one place"));
}

TEST(Limbs, ReadsLengthsFromPositionChannelsWhereOffsetsAreZero) {
  Bvh bvh = named_figure(names_in("LaFAN1"));
  for (BvhJoint& joint : bvh.joints) {
    if (joint.parent < 0) continue;
    joint.first_channel = bvh.channel_count;
    joint.channels = {BvhChannel::x_position, BvhChannel::y_position, BvhChannel::z_position};
    bvh.channel_count += 3;
    for (int axis = 0; axis < 3; ++axis) bvh.values.push_back(joint.offset[axis]);
    joint.offset.setZero();
  }
  expect_roles(bvh, names_in("LaFAN1"));
}

}  // namespace
}  // namespace flinch::database
