// SPDX-License-Identifier: MIT
#include "database/import/role_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/default_character.h"
#include "tests/database/import/named_rigs.h"
#include "tests/database/import/synthetic_figure.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::Role;
using testing::HasSubstr;
using tests::error_of;
using tests::expect_roles;
using tests::joint_of;
using tests::named_figure;
using tests::named_rigs;
using tests::NamedRig;
using tests::names_in;
using tests::synthetic_bvh;
using tests::SyntheticRig;

TEST(RoleMap, FindsEveryRoleOfKnownRigs) {
  for (const NamedRig& named : named_rigs()) {
    SCOPED_TRACE(named.title);
    expect_roles(named_figure(named.names), named.names);
  }
}

TEST(RoleMap, IsNotMisledByDummiesAndTwistBones) {
  for (const NamedRig& named : named_rigs()) {
    SCOPED_TRACE(named.title);
    SyntheticRig rig;
    rig.names = named.names;
    rig.dummy_suffix = "Dummy";
    rig.twist_suffix = "Twist";
    expect_roles(synthetic_bvh(motion::default_character().skeleton, rig, {motion::Pose()}, 0.01),
                 named.names);
  }
}

// Names that say nothing: the roles come from the skeleton's shape, as a table to correct and give.
TEST(RoleMap, SuggestsRolesByShapeThatMapTheFileWhenGiven) {
  motion::PerRole<std::string> names;
  int number = 0;
  for (Role role : kRoles) names[role] = "bone\"" + std::to_string(100 - ++number);
  const Bvh bvh = named_figure(names);
  const tests::TemporaryFolder folder;
  try {
    map_roles(bvh);
    FAIL() << "mapped names that say nothing";
  } catch (const RoleError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    const std::string path = folder.write("roles.toml", error.suggestion);
    const RoleMap map = map_roles(bvh, read_role_overrides(path));
    for (Role role : kRoles) {
      EXPECT_EQ(joint_of(bvh, map, role), names[role]) << motion::name_of(role);
    }
  }
}

TEST(RoleMap, SuggestsWhatNamesSayBesideWhatTheShapeSays) {
  motion::PerRole<std::string> names = names_in("LaFAN1");
  names[Role::left_thigh] = "muslo";
  names[Role::left_shin] = "pantorrilla";
  const Bvh bvh = named_figure(names);
  try {
    map_roles(bvh);
    FAIL() << "mapped a thigh without a known name";
  } catch (const RoleError& error) {
    for (Role role : kRoles) {
      EXPECT_THAT(error.suggestion, HasSubstr("\n" + std::string(motion::name_of(role)) + " = \"" +
                                              names[role] + "\"\n"));
    }
  }
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

TEST(RoleMap, RefusesMoreJointsThanAHumanRigHas) {
  Bvh chain;
  chain.path = "chain.bvh";
  for (int i = 0; i < 5000; ++i) {
    chain.joints.push_back({"LeftUpLeg", i - 1, {0, 1, 0}, {}, 0, {}});
  }
  EXPECT_THAT(error_of([&] { map_roles(chain); }),
              HasSubstr("chain.bvh: not a human figure: 5000 joints"));
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
