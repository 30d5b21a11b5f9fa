// SPDX-License-Identifier: MIT
#include "tests/database/import/named_rigs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "motion/default_character.h"
#include "tests/database/import/synthetic_figure.h"

namespace flinch::tests {
namespace {

using database::Bvh;
using database::BvhJoint;
using motion::Role;

std::vector<NamedRig> make_rigs() {
  return {

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
      {"Mixamo", rig_names({"mixamorig:Hips", "mixamorig:Spine", "mixamorig:Spine2",
                            "mixamorig:Neck", "mixamorig:Head"},
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
           {"CC_Base_Hip", "CC_Base_Waist", "CC_Base_Spine02", "CC_Base_NeckTwist01",
            "CC_Base_Head"},
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
      {"SMPL", rig_names({"Pelvis", "Spine1", "Spine3", "Neck", "Head"},
                         {"L_Collar", "L_Shoulder", "L_Elbow", "L_Wrist"},
                         {"L_Hip", "L_Knee", "L_Ankle", "L_Foot"}, "L_", "R_")},
      {"SMPL-X", rig_names({"pelvis", "spine1", "spine3", "neck", "head"},
                           {"left_collar", "left_shoulder", "left_elbow", "left_wrist"},
                           {"left_hip", "left_knee", "left_ankle", "left_foot"}, "left", "right")},
      {"SMPL in Unity",
       rig_names({"m_avg_Pelvis", "m_avg_Spine1", "m_avg_Spine3", "m_avg_Neck", "m_avg_Head"},
                 {"m_avg_L_Collar", "m_avg_L_Shoulder", "m_avg_L_Elbow", "m_avg_L_Wrist"},
                 {"m_avg_L_Hip", "m_avg_L_Knee", "m_avg_L_Ankle", "m_avg_L_Foot"}, "_L_", "_R_")},
      {"Kinect", rig_names({"SpineBase", "SpineMid", "SpineShoulder", "Neck", "Head"},
                           {"-", "ShoulderLeft", "ElbowLeft", "WristLeft"},
                           {"HipLeft", "KneeLeft", "AnkleLeft", "FootLeft"}, "Left", "Right")},
      {"Azure Kinect",
       rig_names({"PELVIS", "SPINE_NAVEL", "SPINE_CHEST", "NECK", "HEAD"},
                 {"CLAVICLE_LEFT", "SHOULDER_LEFT", "ELBOW_LEFT", "WRIST_LEFT"},
                 {"HIP_LEFT", "KNEE_LEFT", "ANKLE_LEFT", "FOOT_LEFT"}, "LEFT", "RIGHT")},
      {"OptiTrack Motive",
       rig_names({"Hip", "Ab", "Chest", "Neck", "Head"}, {"LShoulder", "LUArm", "LFArm", "LHand"},
                 {"LThigh", "LShin", "LFoot", "LToe"}, "L", "R")},
      {"Xsens", rig_names({"Hips", "Chest", "Chest4", "Neck", "Head"},
                          {"LeftCollar", "LeftShoulder", "LeftElbow", "LeftWrist"},
                          {"LeftHip", "LeftKnee", "LeftAnkle", "LeftToe"}, "Left", "Right")},
      {"Perception Neuron", rig_names({"Hips", "Spine", "Spine2", "Neck", "Head"},
                                      {"LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand"},
                                      {"LeftUpLeg", "LeftLeg", "LeftFoot", "-"}, "Left", "Right")},
      {"Rokoko", rig_names({"Hips", "Spine1", "Spine4", "Neck", "Head"},
                           {"LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand"},
                           {"LeftThigh", "LeftShin", "LeftFoot", "LeftToe"}, "Left", "Right")},
      {"Daz Genesis 3 and 8", rig_names({"hip", "abdomenLower", "chestLower", "neckLower", "head"},
                                        {"lCollar", "lShldrBend", "lForearmBend", "lHand"},
                                        {"lThighBend", "lShin", "lFoot", "lToe"}, "l", "r")},
      {"MMD, Japanese", rig_names({"センター", "上半身", "上半身2", "首", "頭"},
                                  {"左肩", "左腕", "左ひじ", "左手首"},
                                  {"左足", "左ひざ", "左足首", "左つま先"}, "左", "右")},
      {"MMD, Japanese in Blender",
       rig_names({"下半身", "上半身", "上半身2", "首", "頭"}, {"肩.L", "腕.L", "ひじ.L", "手首.L"},
                 {"足.L", "ひざ.L", "足首.L", "足先EX.L"}, ".L", ".R")},
      {"MMD, English", rig_names({"center", "upper body", "upper body2", "neck", "head"},
                                 {"shoulder_L", "arm_L", "elbow_L", "wrist_L"},
                                 {"leg_L", "knee_L", "ankle_L", "toe_L"}, "_L", "_R")},
      {"MakeHuman", rig_names({"root", "spine05", "spine01", "neck01", "head"},
                              {"clavicle.L", "upperarm01.L", "lowerarm01.L", "wrist.L"},
                              {"upperleg01.L", "lowerleg01.L", "foot.L", "-"}, ".L", ".R")},
      {"Rigify's deform bones",
       rig_names({"DEF-spine", "DEF-spine.001", "DEF-spine.003", "DEF-spine.004", "DEF-spine.006"},
                 {"DEF-shoulder.L", "DEF-upper_arm.L", "DEF-forearm.L", "DEF-hand.L"},
                 {"DEF-thigh.L", "DEF-shin.L", "DEF-foot.L", "DEF-toe.L"}, ".L", ".R")},
      {"Genea", rig_names({"b_root", "b_spine0", "b_spine3", "b_neck0", "b_head"},
                          {"b_l_shoulder", "b_l_arm", "b_l_forearm", "b_l_wrist"},
                          {"b_l_upleg", "b_l_leg", "b_l_foot", "b_l_toe"}, "_l_", "_r_")},
      {"Second Life",
       rig_names({"mPelvis", "mTorso", "mChest", "mNeck", "mHead"},
                 {"mCollarLeft", "mShoulderLeft", "mElbowLeft", "mWristLeft"},
                 {"mHipLeft", "mKneeLeft", "mAnkleLeft", "mFootLeft"}, "Left", "Right")},
      {"Advanced Skeleton", rig_names({"Root_M", "Spine1_M", "Chest_M", "Neck_M", "Head_M"},
                                      {"Scapula_L", "Shoulder_L", "Elbow_L", "Wrist_L"},
                                      {"Hip_L", "Knee_L", "Ankle_L", "Toes_L"}, "_L", "_R")},
      {"an unknown prefix",
       rig_names({"Robot_Hips", "Robot_Spine", "Robot_Spine1", "Robot_Neck", "Robot_Head"},
                 {"Robot_LeftShoulder", "Robot_LeftArm", "Robot_LeftForeArm", "Robot_LeftHand"},
                 {"Robot_LeftUpLeg", "Robot_LeftLeg", "Robot_LeftFoot", "Robot_LeftToeBase"},
                 "Left", "Right")},
      {"an unknown suffix",
       rig_names({"hips_JNT", "spine_JNT", "spine2_JNT", "neck_JNT", "head_JNT"},
                 {"l_shoulder_JNT", "l_arm_JNT", "l_forearm_JNT", "l_hand_JNT"},
                 {"l_upleg_JNT", "l_leg_JNT", "l_foot_JNT", "l_toebase_JNT"}, "l_", "r_")},
      {"lower case, run together",
       rig_names({"hips", "spine", "spine1", "neck", "head"},
                 {"leftshoulder", "leftarm", "leftforearm", "lefthand"},
                 {"leftupleg", "leftleg", "leftfoot", "lefttoebase"}, "left", "right")},
      {"3ds Max Biped",
       rig_names({"Bip01 Pelvis", "Bip01 Spine", "Bip01 Spine1", "Bip01 Neck", "Bip01 Head"},
                 {"Bip01 L Clavicle", "Bip01 L UpperArm", "Bip01 L Forearm", "Bip01 L Hand"},
                 {"Bip01 L Thigh", "Bip01 L Calf", "Bip01 L Foot", "Bip01 L Toe0"}, " L ", " R ")},
  };
}

}  // namespace

const std::vector<NamedRig>& named_rigs() {
  static const std::vector<NamedRig> kRigs = make_rigs();
  return kRigs;
}

const motion::PerRole<std::string>& names_in(const std::string& title) {
  for (const NamedRig& named : named_rigs()) {
    if (named.title == title) return named.names;
  }
  throw std::logic_error("no rig " + title);
}

Bvh named_figure(const motion::PerRole<std::string>& names) {
  SyntheticRig rig;
  rig.names = names;
  return synthetic_bvh(motion::default_character().skeleton, rig, {motion::Pose()}, 0.01);
}

std::size_t joint_named(const Bvh& bvh, const std::string& name) {
  const auto at = std::ranges::find(bvh.joints, name, &BvhJoint::name);
  if (at == bvh.joints.end()) throw std::logic_error("no joint " + name);
  return static_cast<std::size_t>(at - bvh.joints.begin());
}

void insert_above(Bvh& bvh, const std::string& below, const std::string& name, double fraction) {
  const std::size_t at = joint_named(bvh, below);
  BvhJoint inserted;
  inserted.name = name;
  inserted.parent = bvh.joints[at].parent;
  inserted.offset = fraction * bvh.joints[at].offset;
  bvh.joints[at].offset *= 1 - fraction;
  for (BvhJoint& joint : bvh.joints) {
    if (joint.parent >= static_cast<int>(at)) ++joint.parent;
  }
  bvh.joints[at].parent = static_cast<int>(at);
  bvh.joints.insert(bvh.joints.begin() + static_cast<std::ptrdiff_t>(at), inserted);
}

std::string joint_of(const Bvh& bvh, const database::RoleMap& map, Role role) {
  const int joint = map.joint[role];
  return joint < 0 ? "" : bvh.joints[static_cast<std::size_t>(joint)].name;
}

void expect_roles(const Bvh& bvh, const motion::PerRole<std::string>& names) {
  const database::RoleMap map = database::map_roles(bvh);
  for (Role role : motion::kRoles) {
    EXPECT_EQ(joint_of(bvh, map, role), names[role]) << motion::name_of(role);
    EXPECT_EQ(map.source[role] == database::RoleSource::none, map.joint[role] < 0);
  }
}

}  // namespace flinch::tests
