// SPDX-License-Identifier: MIT
#include "database/import/role_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "database/import/role_names.h"
#include "motion/default_character.h"
#include "tests/database/import/synthetic_figure.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::Role;
using testing::HasSubstr;
using tests::error_of;
using tests::rig_names;
using tests::synthetic_bvh;
using tests::SyntheticRig;

struct NamedRig {
  const char* title;
  motion::PerRole<std::string> names;
};

// Joint names as tools and data sets write them.
const NamedRig kRigs[] = {
    {"LaFAN1", rig_names({"Hips", "Spine", "Spine2", "Neck", "Head"},
                         {"LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand"},
                         {"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToe"}, "Left", "Right")},
    {"CMU, MotionBuilder-friendly",
     rig_names({"Hips", "Spine", "Spine1", "Neck1", "Head"},
               {"LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand"},
               {"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToeBase"}, "Left", "Right")},
    {"CMU, 3dsMax-friendly",
     rig_names({"Hips", "Chest", "Chest2", "Neck", "Head"},
               {"LeftCollar", "LeftShoulder", "LeftElbow", "LeftWrist"},
               {"LeftHip", "LeftKnee", "LeftAnkle", "LeftToe"}, "Left", "Right")},
    {"CMU, Daz-friendly", rig_names({"hip", "abdomen", "chest", "neck", "head"},
                                    {"lCollar", "lShldr", "lForeArm", "lHand"},
                                    {"lThigh", "lShin", "lFoot", "-"}, "l", "r")},
    {"Acclaim", rig_names({"root", "upperback", "thorax", "lowerneck", "head"},
                          {"lclavicle", "lhumerus", "lradius", "lwrist"},
                          {"lfemur", "ltibia", "lfoot", "ltoes"}, "l", "r")},
    {"Bandai-Namco", rig_names({"Hips", "Spine", "Chest", "Neck", "Head"},
                               {"Shoulder_L", "UpperArm_L", "LowerArm_L", "Hand_L"},
                               {"UpperLeg_L", "LowerLeg_L", "Foot_L", "Toes_L"}, "_L", "_R")},
    {"Mixamo", rig_names({"mixamorig:Hips", "mixamorig:Spine", "mixamorig:Spine2", "mixamorig:Neck",
                          "mixamorig:Head"},
                         {"mixamorig:LeftShoulder", "mixamorig:LeftArm", "mixamorig:LeftForeArm",
                          "mixamorig:LeftHand"},
                         {"mixamorig:LeftUpLeg", "mixamorig:LeftLeg", "mixamorig:LeftFoot",
                          "mixamorig:LeftToeBase"},
                         "Left", "Right")},
    {"Unity humanoid",
     rig_names({"Hips", "Spine", "UpperChest", "Neck", "Head"},
               {"LeftShoulder", "LeftUpperArm", "LeftLowerArm", "LeftHand"},
               {"LeftUpperLeg", "LeftLowerLeg", "LeftFoot", "LeftToes"}, "Left", "Right")},
    {"VRM humanoid",
     rig_names({"hips", "spine", "upperChest", "neck", "head"},
               {"leftShoulder", "leftUpperArm", "leftLowerArm", "leftHand"},
               {"leftUpperLeg", "leftLowerLeg", "leftFoot", "leftToes"}, "left", "right")},
    {"VRoid's VRM",
     rig_names(
         {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_UpperChest", "J_Bip_C_Neck", "J_Bip_C_Head"},
         {"J_Bip_L_Shoulder", "J_Bip_L_UpperArm", "J_Bip_L_LowerArm", "J_Bip_L_Hand"},
         {"J_Bip_L_UpperLeg", "J_Bip_L_LowerLeg", "J_Bip_L_Foot", "J_Bip_L_ToeBase"}, "_L_",
         "_R_")},
    {"Unreal mannequin", rig_names({"pelvis", "spine_01", "spine_03", "neck_01", "head"},
                                   {"clavicle_l", "upperarm_l", "lowerarm_l", "hand_l"},
                                   {"thigh_l", "calf_l", "foot_l", "ball_l"}, "_l", "_r")},
    {"Rigify", rig_names({"spine", "spine.001", "spine.003", "spine.004", "spine.006"},
                         {"shoulder.L", "upper_arm.L", "forearm.L", "hand.L"},
                         {"thigh.L", "shin.L", "foot.L", "toe.L"}, ".L", ".R")},
    {"ReActIdle", rig_names({"pelvis", "spine", "spine.001", "neck", "face"},
                            {"shoulder.L", "upper_arm.L", "forearm.L", "-"},
                            {"thigh.L", "shin.L", "foot.L", "-"}, ".L", ".R")},
    {"Character Creator",
     rig_names(
         {"CC_Base_Hip", "CC_Base_Waist", "CC_Base_Spine02", "CC_Base_NeckTwist01", "CC_Base_Head"},
         {"CC_Base_L_Clavicle", "CC_Base_L_Upperarm", "CC_Base_L_Forearm", "CC_Base_L_Hand"},
         {"CC_Base_L_Thigh", "CC_Base_L_Calf", "CC_Base_L_Foot", "CC_Base_L_ToeBase"}, "_L_",
         "_R_")},
    {"SNU",
     [] {
       auto names = rig_names({"Hips", "Spine", "Spine1", "-", "Head"},
                              {"LeftShoulder1", "LeftArm", "LeftForeArm", "LeftHand"},
                              {"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToes"}, "Left", "Right");
       names[Role::right_clavicle] = "RightShoulder";
       return names;
     }()},
    {"DeepMimic",
     rig_names({"root", "-", "chest", "-", "neck"}, {"-", "left_shoulder", "left_elbow", "-"},
               {"left_hip", "left_knee", "left_ankle", "-"}, "left", "right")},
    {"3ds Max Biped",
     rig_names({"Bip01 Pelvis", "Bip01 Spine", "Bip01 Spine1", "Bip01 Neck", "Bip01 Head"},
               {"Bip01 L Clavicle", "Bip01 L UpperArm", "Bip01 L Forearm", "Bip01 L Hand"},
               {"Bip01 L Thigh", "Bip01 L Calf", "Bip01 L Foot", "Bip01 L Toe0"}, " L ", " R ")},
};

void expect_mapped(const NamedRig& named, const SyntheticRig& made) {
  const Bvh bvh = synthetic_bvh(motion::default_character().skeleton, made, {motion::Pose()}, 0.01);
  const RoleMap map = map_roles(bvh);
  for (Role role : kRoles) {
    const int joint = map.joint[role];
    const std::string found = joint < 0 ? "" : bvh.joints[static_cast<std::size_t>(joint)].name;
    EXPECT_EQ(found, named.names[role]) << named.title << ", " << motion::name_of(role);
    EXPECT_EQ(map.source[role] == RoleSource::none, joint < 0);
  }
}

TEST(RoleMap, FindsEveryRoleOfKnownRigs) {
  for (const NamedRig& named : kRigs) {
    SyntheticRig rig;
    rig.names = named.names;
    expect_mapped(named, rig);
  }
}

TEST(RoleMap, IsNotMisledByDummiesAndTwistBones) {
  for (const NamedRig& named : kRigs) {
    SyntheticRig rig;
    rig.names = named.names;
    rig.dummy_suffix = "Dummy";
    rig.twist_suffix = "Twist";
    expect_mapped(named, rig);
  }
}

TEST(RoleMap, KeepsSidesApart) {
  EXPECT_EQ(plain_name("LeftUpLeg").side, NameSide::left);
  EXPECT_EQ(plain_name("RightUpLeg").side, NameSide::right);
  EXPECT_EQ(plain_name("thigh_r").side, NameSide::right);
  EXPECT_EQ(plain_name("Bip01 L Thigh").side, NameSide::left);
  EXPECT_EQ(plain_name("upper_arm.R").stem, "upperarm");
  EXPECT_EQ(plain_name("lShldr").stem, "shldr");
  EXPECT_EQ(plain_name("LHipJoint").stem, "hipjoint");
  EXPECT_EQ(plain_name("a|b:mixamorig:Hips").stem, "hips");
  EXPECT_EQ(plain_name("Root").side, NameSide::none);
}

TEST(RoleMap, FindsALimbJointBetweenItsNeighbours) {
  SyntheticRig rig;
  rig.names[Role::left_forearm] = "codo";
  rig.names[Role::right_foot] = "tobillo";
  const Bvh bvh = synthetic_bvh(motion::default_character().skeleton, rig, {motion::Pose()}, 0.01);
  const RoleMap map = map_roles(bvh);
  EXPECT_EQ(bvh.joints[static_cast<std::size_t>(map.joint[Role::left_forearm])].name, "codo");
  EXPECT_EQ(map.source[Role::left_forearm], RoleSource::topology);
  EXPECT_EQ(bvh.joints[static_cast<std::size_t>(map.joint[Role::right_foot])].name, "tobillo");
}

TEST(RoleMap, ErrorNamesTheMissingRoleUnusedJointsAndTomlLine) {
  SyntheticRig rig;
  rig.names[Role::left_thigh] = "muslo";
  rig.names[Role::left_shin] = "pantorrilla";
  const Bvh bvh = synthetic_bvh(motion::default_character().skeleton, rig, {motion::Pose()}, 0.01);
  const std::string message = error_of([&] { map_roles(bvh); });
  EXPECT_THAT(message, HasSubstr("made.bvh: no joint found for left_thigh"));
  EXPECT_THAT(message, HasSubstr("muslo"));
  EXPECT_THAT(message, HasSubstr("[roles] left_thigh = \"muslo\""));
  EXPECT_EQ(message.find('\n'), std::string::npos);

  const RoleMap map = map_roles(bvh, {{Role::left_thigh, "muslo"}});
  EXPECT_EQ(map.source[Role::left_thigh], RoleSource::override_);
  EXPECT_EQ(bvh.joints[static_cast<std::size_t>(map.joint[Role::left_shin])].name, "pantorrilla");
}

TEST(RoleMap, RefusesNonHumanSkeletons) {
  Bvh chain;
  chain.path = "chain.bvh";
  for (int i = 0; i < 4; ++i) {
    chain.joints.push_back({"link" + std::to_string(i), i - 1, {0, 1, 0}, {}, 0, {}});
  }
  EXPECT_THAT(error_of([&] { map_roles(chain); }), HasSubstr("chain.bvh: not a human figure"));
}

TEST(RoleMap, RefusesDisconnectedLimbs) {
  const Bvh bvh =
      synthetic_bvh(motion::default_character().skeleton, SyntheticRig(), {motion::Pose()}, 0.01);
  const RoleOverrides crossed{{Role::left_shin, "right_shin"}, {Role::right_shin, "left_shin"}};
  EXPECT_THAT(error_of([&] { map_roles(bvh, crossed); }),
              HasSubstr("left_shin (right_shin) does not hang from left_thigh"));
}

TEST(RoleMap, RefusesOverridesOfJointsThatAreNotThere) {
  const Bvh bvh =
      synthetic_bvh(motion::default_character().skeleton, SyntheticRig(), {motion::Pose()}, 0.01);
  EXPECT_THAT(error_of([&] {
                map_roles(bvh, {{Role::head, "kopf"}});
              }),
              HasSubstr("no joint is named \"kopf\", which the roles give for head"));
}

TEST(RoleOverrides, ReportTomlErrorsWithTheirLines) {
  const tests::TemporaryFolder folder;
  const std::string path = folder.write("roles.toml", "[roles]\nhead = \"Kopf\"\n");
  EXPECT_EQ(read_role_overrides(path), (RoleOverrides{{Role::head, "Kopf"}}));
  folder.write("roles.toml", "[roles]\n\nhaed = \"Kopf\"\n");
  const std::string message = error_of([&] { read_role_overrides(path); });
  EXPECT_THAT(message, HasSubstr("roles.toml:3: [roles] names an unknown role \"haed\""));
  EXPECT_THAT(message, HasSubstr("left_upper_arm"));
  folder.write("roles.toml", "head = \"Kopf\"\n");
  EXPECT_THAT(error_of([&] { read_role_overrides(path); }), HasSubstr("roles.toml:1: "));
}

}  // namespace
}  // namespace flinch::database
