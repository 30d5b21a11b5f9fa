// SPDX-License-Identifier: MIT
#include "motion/default_character.h"

namespace flinch::motion {
namespace {

constexpr float kStature = 1.75F;  // m
constexpr float kMass = 75;        // kg

// Fractions of the stature. From Drillis and Contini: hip, knee, ankle, foot. From de Leva, stature
// 1.741 m: arm segments; navel and xiphion, measured up from the mid-hip. The others are estimates
// that agree with both.
constexpr float kPelvisHeight = 0.550F;
constexpr float kHipHeight = 0.530F;
constexpr float kHalfBetweenHips = 0.050F;
constexpr float kKneeHeight = 0.285F;
constexpr float kAnkleHeight = 0.039F;
constexpr float kBallHeight = 0.012F;
constexpr float kAbdomenHeight = 0.600F;
constexpr float kChestHeight = 0.720F;
constexpr float kNeckHeight = 0.850F;
constexpr float kHeadHeight = 0.920F;
constexpr float kClavicleHeight = 0.810F;
constexpr float kHalfBetweenClavicles = 0.012F;
constexpr float kShoulderHeight = 0.818F;
constexpr float kHalfBetweenShoulders = 0.100F;
constexpr float kUpperArmLength = 0.2817F / 1.741F;
constexpr float kForearmLength = 0.2689F / 1.741F;
constexpr float kHandLength = 0.1879F / 1.741F;
constexpr float kFootLength = 0.152F;
constexpr float kAnkleToTip = 0.75F * kFootLength;
constexpr float kAnkleToBall = 0.47F * kFootLength;

struct SideRoles {
  Role clavicle, upper_arm, forearm, hand, thigh, shin, foot, toes;
  float sign;  // of y
};

void set_side_offsets(Skeleton& skeleton, const SideRoles& side) {
  const float y = side.sign;
  skeleton.offset[side.clavicle] = {0, y * kHalfBetweenClavicles, kClavicleHeight - kChestHeight};
  skeleton.offset[side.upper_arm] = {0, y * (kHalfBetweenShoulders - kHalfBetweenClavicles),
                                     kShoulderHeight - kClavicleHeight};
  skeleton.offset[side.forearm] = {0, y * kUpperArmLength, 0};
  skeleton.offset[side.hand] = {0, y * kForearmLength, 0};
  skeleton.tip[side.hand] = {0, y * kHandLength, 0};
  skeleton.offset[side.thigh] = {0, y * kHalfBetweenHips, kHipHeight - kPelvisHeight};
  skeleton.offset[side.shin] = {0, 0, kKneeHeight - kHipHeight};
  skeleton.offset[side.foot] = {0, 0, kAnkleHeight - kKneeHeight};
  skeleton.offset[side.toes] = {kAnkleToBall, 0, kBallHeight - kAnkleHeight};
  skeleton.tip[side.toes] = {kAnkleToTip - kAnkleToBall, 0, 0};
  for (auto [role, next] : {std::pair{side.clavicle, side.upper_arm},
                            {side.upper_arm, side.forearm},
                            {side.forearm, side.hand},
                            {side.thigh, side.shin},
                            {side.shin, side.foot},
                            {side.foot, side.toes}}) {
    skeleton.tip[role] = skeleton.offset[next];
  }
}

}  // namespace

Physique default_character() {
  Skeleton skeleton;
  skeleton.offset[Role::pelvis] = {0, 0, kPelvisHeight};
  skeleton.offset[Role::abdomen] = {0, 0, kAbdomenHeight - kPelvisHeight};
  skeleton.offset[Role::chest] = {0, 0, kChestHeight - kAbdomenHeight};
  skeleton.offset[Role::neck] = {0, 0, kNeckHeight - kChestHeight};
  skeleton.offset[Role::head] = {0, 0, kHeadHeight - kNeckHeight};
  skeleton.tip[Role::pelvis] = skeleton.offset[Role::abdomen];
  skeleton.tip[Role::abdomen] = skeleton.offset[Role::chest];
  skeleton.tip[Role::chest] = skeleton.offset[Role::neck];
  skeleton.tip[Role::neck] = skeleton.offset[Role::head];
  skeleton.tip[Role::head] = {0, 0, 1 - kHeadHeight};
  set_side_offsets(skeleton,
                   {Role::left_clavicle, Role::left_upper_arm, Role::left_forearm, Role::left_hand,
                    Role::left_thigh, Role::left_shin, Role::left_foot, Role::left_toes, 1});
  set_side_offsets(
      skeleton, {Role::right_clavicle, Role::right_upper_arm, Role::right_forearm, Role::right_hand,
                 Role::right_thigh, Role::right_shin, Role::right_foot, Role::right_toes, -1});
  for (Role role : kRoles) {
    skeleton.offset[role] *= kStature;
    skeleton.tip[role] *= kStature;
  }
  return {skeleton, kMass, Sex::male};
}

}  // namespace flinch::motion
