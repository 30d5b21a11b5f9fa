// SPDX-License-Identifier: MIT
#include "motion/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "motion/default_character.h"
#include "motion/mirror.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

float mass_of(const BodyModel& model) {
  float sum = 0;
  for (const BodyProperties& body : model) sum += body.mass_kg;
  return sum;
}

Physique with_sex(Sex sex) {
  Physique character = default_character();
  character.sex = sex;
  return character;
}

TEST(Body, EveryBodyHasOneRoleAndAnEarlierParent) {
  std::set<Role> roles;
  for (Body body : kBodies) {
    EXPECT_EQ(body_of(role_of(body)), body);
    roles.insert(role_of(body));
    if (body == Body::pelvis) {
      EXPECT_FALSE(parent_of(body));
    } else {
      ASSERT_TRUE(parent_of(body));
      EXPECT_LT(*parent_of(body), body);
      EXPECT_EQ(body_of(*parent_of(role_of(body))), *parent_of(body)) << name_of(body);
    }
    EXPECT_EQ(name_of(body), name_of(role_of(body)));
  }
  EXPECT_EQ(roles.size(), 17U);
  EXPECT_EQ(body_of(Role::left_clavicle), Body::chest);
  EXPECT_EQ(body_of(Role::right_toes), Body::right_foot);
}

TEST(Body, EveryBodyMapsToItsTarget) {
  EXPECT_EQ(target_of(Body::neck), Target::head);
  EXPECT_EQ(target_of(Body::right_hand), Target::trunk);
  EXPECT_EQ(target_of(Body::pelvis), Target::pelvis);
  EXPECT_EQ(target_of(Body::left_foot), Target::legs);
}

TEST(Body, SexNamesRoundTrip) {
  EXPECT_EQ(sex_named(name_of(Sex::female)), Sex::female);
  EXPECT_EQ(sex_named(name_of(Sex::male)), Sex::male);
  EXPECT_FALSE(sex_named("other"));
}

TEST(BodyModel, BodyMassesSumToTheCharactersMass) {
  for (Sex sex : {Sex::female, Sex::male}) {
    for (float mass_kg : {45.0F, 75.0F, 120.0F}) {
      Physique character = with_sex(sex);
      character.mass_kg = mass_kg;
      EXPECT_NEAR(mass_of(make_body_model(character)), mass_kg, 1e-4F * mass_kg);
    }
  }
}

// De Leva (1996), table 4, for a man of 75 kg: thigh 14.16 %, trunk 43.46 %, arm 4.94 %.
TEST(BodyModel, MaleMassesMatchDeLeva) {
  const BodyModel model = make_body_model(with_sex(Sex::male));
  EXPECT_NEAR(model[Body::left_thigh].mass_kg, 10.62F, 1e-3F);
  EXPECT_NEAR(
      model[Body::pelvis].mass_kg + model[Body::abdomen].mass_kg + model[Body::chest].mass_kg,
      32.595F, 1e-3F);
  EXPECT_NEAR(model[Body::right_upper_arm].mass_kg + model[Body::right_forearm].mass_kg +
                  model[Body::right_hand].mass_kg,
              3.705F, 1e-3F);
  EXPECT_NEAR(model[Body::head].mass_kg, 4.4F, 1e-3F);
  EXPECT_NEAR(model[Body::head].mass_kg + model[Body::neck].mass_kg, 5.205F, 1e-3F);
}

// Women: thigh 14.78 %, trunk 42.57 %; the table sums to 99.99 %.
TEST(BodyModel, FemaleMassesMatchDeLeva) {
  const BodyModel model = make_body_model(with_sex(Sex::female));
  EXPECT_NEAR(model[Body::left_thigh].mass_kg, 0.1478F * 75 / 0.9999F, 1e-3F);
  EXPECT_NEAR(
      model[Body::pelvis].mass_kg + model[Body::abdomen].mass_kg + model[Body::chest].mass_kg,
      0.4257F * 75 / 0.9999F, 1e-3F);
}

// The thigh's centre is at 40.95 % (women: 36.12 %) from hip to knee; the hand's at 36.24 % from
// wrist to fingertip (de Leva's own second row for the hand, with 34.27 % for women).
TEST(BodyModel, CentresOfMassMatchDeLevasFractions) {
  const Physique man = with_sex(Sex::male);
  const BodyModel male = make_body_model(man);
  const BodyModel female = make_body_model(with_sex(Sex::female));
  const Skeleton& skeleton = man.skeleton;
  const Eigen::Vector3f& knee = skeleton.offset[Role::left_shin];
  EXPECT_LT((male[Body::left_thigh].centre_of_mass - 0.4095F * knee).norm(), 1e-5F);
  EXPECT_LT((female[Body::left_thigh].centre_of_mass - 0.3612F * knee).norm(), 1e-5F);
  const Eigen::Vector3f& fingertip = skeleton.tip[Role::right_hand];
  EXPECT_LT((male[Body::right_hand].centre_of_mass - 0.3624F * fingertip).norm(), 1e-4F);
  EXPECT_LT((female[Body::right_hand].centre_of_mass - 0.3427F * fingertip).norm(), 1e-4F);
}

// Head and neck combined: 50.02 % from the crown to the seventh cervical vertebra.
TEST(BodyModel, CombinedHeadAndNeckCentreMatchesDeLeva) {
  const Physique man = default_character();
  const BodyModel model = make_body_model(man);
  const JointFrames rest = forward_kinematics(man.skeleton, rest_pose(man.skeleton));
  const float neck_mass = model[Body::neck].mass_kg;
  const float head_mass = model[Body::head].mass_kg;
  const float height = (neck_mass * centre_of_mass(model, rest, Body::neck).z() +
                        head_mass * centre_of_mass(model, rest, Body::head).z()) /
                       (neck_mass + head_mass);
  EXPECT_NEAR(height, 1.75F + 0.5002F * (rest.position[Role::neck].z() - 1.75F), 1e-4F);
}

// The centre of mass of a standing man with the arms down is at 0.55 to 0.58 of his height; raising
// the arms to the T-pose lifts it by less than 0.02.
TEST(CentreOfMass, IsInThePelvisWhenStanding) {
  const Physique man = default_character();
  const BodyModel model = make_body_model(man);
  Pose pose = rest_pose(man.skeleton);
  const Eigen::Vector3f spread = centre_of_mass(model, forward_kinematics(man.skeleton, pose));
  pose.rotation[Role::left_upper_arm] = Eigen::AngleAxisf(-1.5F, Eigen::Vector3f::UnitX());
  pose.rotation[Role::right_upper_arm] = Eigen::AngleAxisf(1.5F, Eigen::Vector3f::UnitX());
  const Eigen::Vector3f hanging = centre_of_mass(model, forward_kinematics(man.skeleton, pose));
  EXPECT_GT(hanging.z() / 1.75F, 0.55F);
  EXPECT_LT(hanging.z() / 1.75F, 0.58F);
  EXPECT_GT(spread.z(), hanging.z());
  EXPECT_LT(spread.z() - hanging.z(), 0.02F * 1.75F);
  EXPECT_NEAR(hanging.y(), 0, 1e-5F);
}

// Rotating one arm about the shoulder moves the whole centre of mass by m_arm / m of the arm's.
TEST(CentreOfMass, MovesInProportionToTheMovedMass) {
  const Physique man = default_character();
  const BodyModel model = make_body_model(man);
  Pose pose = rest_pose(man.skeleton);
  const Eigen::Vector3f before = centre_of_mass(model, forward_kinematics(man.skeleton, pose));
  pose.rotation[Role::left_hand] = Eigen::AngleAxisf(1.57079633F, Eigen::Vector3f::UnitZ());
  const Eigen::Vector3f after = centre_of_mass(model, forward_kinematics(man.skeleton, pose));
  const float arm = model[Body::left_hand].centre_of_mass.y();
  const Eigen::Vector3f expected = 0.0061F * Eigen::Vector3f(-arm, -arm, 0);
  EXPECT_LT((after - before - expected).norm(), 1e-5F);
}

TEST(CentreOfMass, IsMirroredWithThePose) {
  std::mt19937 random(1);
  const Physique man = default_character();
  const BodyModel model = make_body_model(man);
  for (int i = 0; i < 50; ++i) {
    const Pose pose = tests::random_pose(random);
    Eigen::Vector3f centre = centre_of_mass(model, forward_kinematics(man.skeleton, pose));
    centre.y() = -centre.y();
    const JointFrames frames = forward_kinematics(man.skeleton, mirrored(pose));
    EXPECT_LT((centre_of_mass(model, frames) - centre).norm(), 1e-4F);
  }
}

TEST(TargetCentre, DescendsFromHeadToLegsInTheRestPose) {
  const Physique man = default_character();
  const BodyModel model = make_body_model(man);
  const JointFrames rest = forward_kinematics(man.skeleton, rest_pose(man.skeleton));
  const auto height = [&](Target target) { return target_centre(model, rest, target).z(); };
  EXPECT_FLOAT_EQ(height(Target::head), centre_of_mass(model, rest, Body::head).z());
  EXPECT_GT(height(Target::head), height(Target::trunk));
  EXPECT_GT(height(Target::trunk), height(Target::pelvis));
  EXPECT_GT(height(Target::pelvis), height(Target::legs));
  // Thighs 14.16 %, shanks 4.33 %: the mean of their heights, weighted by mass.
  const float thigh = centre_of_mass(model, rest, Body::left_thigh).z();
  const float shin = centre_of_mass(model, rest, Body::left_shin).z();
  EXPECT_NEAR(height(Target::legs), (14.16F * thigh + 4.33F * shin) / 18.49F, 1e-5F);
}

}  // namespace
}  // namespace flinch::motion
