// SPDX-License-Identifier: MIT
#include "motion/body.h"

#include <algorithm>
#include <span>

#include "motion/enum_names.h"
#include "motion/rotation.h"

namespace flinch::motion {
namespace {

struct BodyInfo {
  std::string_view name;
  Role role;
  Body parent;  // the pelvis names itself
  Target target;
};

constexpr PerBody<BodyInfo> kBodyInfo{{{
    {"pelvis", Role::pelvis, Body::pelvis, Target::pelvis},
    {"abdomen", Role::abdomen, Body::pelvis, Target::trunk},
    {"chest", Role::chest, Body::abdomen, Target::trunk},
    {"neck", Role::neck, Body::chest, Target::head},
    {"head", Role::head, Body::neck, Target::head},
    {"left_upper_arm", Role::left_upper_arm, Body::chest, Target::trunk},
    {"left_forearm", Role::left_forearm, Body::left_upper_arm, Target::trunk},
    {"left_hand", Role::left_hand, Body::left_forearm, Target::trunk},
    {"right_upper_arm", Role::right_upper_arm, Body::chest, Target::trunk},
    {"right_forearm", Role::right_forearm, Body::right_upper_arm, Target::trunk},
    {"right_hand", Role::right_hand, Body::right_forearm, Target::trunk},
    {"left_thigh", Role::left_thigh, Body::pelvis, Target::legs},
    {"left_shin", Role::left_shin, Body::left_thigh, Target::legs},
    {"left_foot", Role::left_foot, Body::left_shin, Target::legs},
    {"right_thigh", Role::right_thigh, Body::pelvis, Target::legs},
    {"right_shin", Role::right_shin, Body::right_thigh, Target::legs},
    {"right_foot", Role::right_foot, Body::right_shin, Target::legs},
}}};

constexpr const BodyInfo& info_of(Body body) {
  return kBodyInfo[body];
}

constexpr EnumArray<Sex, std::string_view, 2> kSexNames{"female", "male"};

constexpr std::array kHeadCore{Body::head};
constexpr std::array kTrunkCore{Body::chest, Body::abdomen};
constexpr std::array kPelvisCore{Body::pelvis};
constexpr std::array kLegsCore{Body::left_thigh, Body::right_thigh, Body::left_shin,
                               Body::right_shin};

std::span<const Body> core_of(Target target) {
  switch (target) {
    case Target::head:
      return kHeadCore;
    case Target::trunk:
      return kTrunkCore;
    case Target::pelvis:
      return kPelvisCore;
    case Target::legs:
      break;
  }
  return kLegsCore;
}

// c = sum m_i c_i / sum m_i
Eigen::Vector3f weighted_centre(const BodyModel& model, const JointFrames& frames,
                                std::span<const Body> bodies) {
  Eigen::Vector3f moment = Eigen::Vector3f::Zero();
  float mass_kg = 0;
  for (Body body : bodies) {
    moment += model[body].mass_kg * centre_of_mass(model, frames, body);
    mass_kg += model[body].mass_kg;
  }
  return moment / mass_kg;
}

}  // namespace

Role role_of(Body body) {
  return info_of(body).role;
}

Body body_of(Role role) {
  if (role == Role::left_clavicle || role == Role::right_clavicle) return Body::chest;
  if (role == Role::left_toes) return Body::left_foot;
  if (role == Role::right_toes) return Body::right_foot;
  const auto found =
      std::find_if(kBodyInfo.begin(), kBodyInfo.end(),
                   [role](const BodyInfo& candidate) { return candidate.role == role; });
  return static_cast<Body>(found - kBodyInfo.begin());
}

std::optional<Body> parent_of(Body body) {
  if (body == Body::pelvis) return std::nullopt;
  return info_of(body).parent;
}

std::string_view name_of(Body body) {
  return info_of(body).name;
}

Target target_of(Body body) {
  return info_of(body).target;
}

std::string_view name_of(Sex sex) {
  return kSexNames[sex];
}

std::optional<Sex> sex_named(std::string_view name) {
  return enum_named(kSexNames, name);
}

Eigen::Vector3f centre_of_mass(const BodyModel& model, const JointFrames& frames, Body body) {
  const Role role = role_of(body);
  return frames.position[role] + rotated(model[body].centre_of_mass, frames.orientation[role]);
}

Eigen::Vector3f centre_of_mass(const BodyModel& model, const JointFrames& frames) {
  return weighted_centre(model, frames, kBodies);
}

Eigen::Vector3f target_centre(const BodyModel& model, const JointFrames& frames, Target target) {
  return weighted_centre(model, frames, core_of(target));
}

}  // namespace flinch::motion
