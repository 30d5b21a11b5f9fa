// SPDX-License-Identifier: MIT
#include "database/import/role_names.h"

#include <gtest/gtest.h>

namespace flinch::database {
namespace {

TEST(RoleNames, KeepSidesApart) {
  EXPECT_EQ(plain_name("LeftUpLeg").side, NameSide::left);
  EXPECT_EQ(plain_name("RightUpLeg").side, NameSide::right);
  EXPECT_EQ(plain_name("thigh_r").side, NameSide::right);
  EXPECT_EQ(plain_name("Bip01 L Thigh").side, NameSide::left);
  EXPECT_EQ(plain_name("upper_arm.R").stem, "upperarm");
  EXPECT_EQ(plain_name("lShldr").stem, "shldr");
  EXPECT_EQ(plain_name("LHipJoint").stem, "hipjoint");
  EXPECT_EQ(plain_name("a|b:mixamorig:Hips").stem, "hips");
  EXPECT_EQ(plain_name("Root").side, NameSide::none);
  EXPECT_EQ(plain_name("DEF-thigh.L.001").side, NameSide::left);
  EXPECT_EQ(plain_name("右腕").side, NameSide::right);
  EXPECT_EQ(plain_name("rightforearm").stem, "forearm");
  EXPECT_EQ(plain_name("LFArm").stem, "farm");
}

TEST(RoleNames, LeaveOutWhatAllJointsShare) {
  const auto stems = [](const std::vector<std::string>& names) {
    std::vector<std::string> found;
    for (const PlainName& name : plain_names(names)) found.push_back(name.stem);
    return found;
  };
  const std::vector<std::string> plain{"hips", "neck", "head", "upleg", "upleg"};
  EXPECT_EQ(stems({"X_Hips", "X_Neck", "X_Head", "X_LeftUpLeg", "X_RightUpLeg"}), plain);
  EXPECT_EQ(stems({"Hips", "X_Neck", "X_Head", "X_LeftUpLeg", "X_RightUpLeg"}), plain);
  EXPECT_EQ(stems({"rig_hips_a", "rig_neck_a", "rig_head_a", "rig_l_upleg_a", "rig_r_upleg_a"}),
            plain);
  EXPECT_EQ(stems({"Hips_01", "Neck_02", "Head_03", "LeftUpLeg_04", "RightUpLeg_055"}), plain);
  EXPECT_EQ(stems({"root", "zotneck", "zothead", "zotleftupleg", "zotrightupleg"}),
            (std::vector<std::string>{"root", "neck", "head", "upleg", "upleg"}));
  // What all share may be all that a name says.
  EXPECT_EQ(stems({"left_hand", "right_hand", "hand"}),
            (std::vector<std::string>{"hand", "hand", "hand"}));
}

}  // namespace
}  // namespace flinch::database
