// SPDX-License-Identifier: MIT
#include "database/import/role_finder.h"

#include <algorithm>

namespace flinch::database {

using motion::kRoles;
using motion::PerRole;
using motion::Role;

namespace {

std::vector<std::string> names_of(const Bvh& bvh) {
  std::vector<std::string> names;
  for (const BvhJoint& joint : bvh.joints) names.push_back(joint.name);
  return names;
}

PerRole<int> no_joints() {
  PerRole<int> none;
  for (Role role : kRoles) none[role] = kNoJoint;
  return none;
}

}  // namespace

RoleFinder::RoleFinder(const Bvh& bvh)
    : bvh_(bvh),
      tree_(bvh),
      names_(plain_names(names_of(bvh))),
      used_(bvh.joints.size()),
      given_(no_joints()) {
  map_.joint = no_joints();
}

void RoleFinder::give(const RoleOverrides& overrides) {
  for (const auto& [role, joint_name] : overrides) {
    const auto named = [&wanted = joint_name](const BvhJoint& joint) {
      return joint.name == wanted;
    };
    const auto at = std::find_if(bvh_.joints.begin(), bvh_.joints.end(), named);
    if (at == bvh_.joints.end()) {
      std::vector<int> all;
      for (int i = 0; i < tree_.count(); ++i) all.push_back(i);
      throw Error(bvh_.path, "no joint is named \"" + joint_name + "\", which the roles give for " +
                                 std::string(name_of(role)) + "; its joints are: " + listed(all));
    }
    give(role, static_cast<int>(at - bvh_.joints.begin()));
  }
}

void RoleFinder::give(Role role, int joint) {
  given_[role] = joint;
  assign(role, joint, RoleSource::override_);
}

void RoleFinder::find() {
  for (Role role : {Role::pelvis, Role::neck, Role::head}) find_by_name(role);
  find_limbs(kLeftArm, kRightArm);
  find_limbs(kLeftLeg, kRightLeg);
  find_trunk();
}

void RoleFinder::assign(Role role, int joint, RoleSource source) {
  map_.joint[role] = joint;
  map_.source[role] = source;
  used_[index(joint)] = true;
}

void RoleFinder::release(Role role) {
  used_[index(map_.joint[role])] = false;
  map_.joint[role] = kNoJoint;
  map_.source[role] = RoleSource::none;
}

void RoleFinder::find_by_name(Role role) {
  if (found(role)) return;
  for (std::string_view stem : middle_stems(role)) {
    for (int candidate = 0; candidate < tree_.count(); ++candidate) {
      if (used_[index(candidate)] || !is_named(names_[index(candidate)], stem)) continue;
      assign(role, candidate, RoleSource::name);
      return;
    }
  }
}

void RoleFinder::find_limbs(const LimbRoles& left, const LimbRoles& right) {
  const auto [left_limb, right_limb] = match_limbs(figure(), left, right);
  assign_limb(left, left_limb);
  assign_limb(right, right_limb);
}

void RoleFinder::assign_limb(const LimbRoles& roles, const LimbMatch& limb) {
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (!found(roles[i]) && limb.joint[i] != kNoJoint) {
      assign(roles[i], limb.joint[i], limb.source[i]);
    }
  }
}

void RoleFinder::find_trunk() {
  find_pelvis();
  find_spine();
  find_head_and_neck();
}

// The pelvis is where the legs branch. A pelvis found by name is kept unless the legs are not its
// descendants.
void RoleFinder::find_pelvis() {
  if (!found(Role::left_thigh) || !found(Role::right_thigh)) return;
  const int fork = tree_.common_ancestor(joint(Role::left_thigh), joint(Role::right_thigh));
  if (fork == kNoJoint || map_.source[Role::pelvis] == RoleSource::override_) return;
  if (found(Role::pelvis)) {
    if (tree_.hangs_from(fork, joint(Role::pelvis))) return;
    release(Role::pelvis);
  }
  assign(Role::pelvis, fork, RoleSource::topology);
}

// Returns the joint of one arm that is nearest to the trunk.
int RoleFinder::arm_root(Role clavicle, Role upper_arm) const {
  return found(clavicle) ? joint(clavicle) : joint(upper_arm);
}

void RoleFinder::find_spine() {
  if (!found(Role::pelvis)) return;
  const int pelvis = joint(Role::pelvis);
  if (!found(Role::chest)) {
    const int left = arm_root(Role::left_clavicle, Role::left_upper_arm);
    const int right = arm_root(Role::right_clavicle, Role::right_upper_arm);
    if (left == kNoJoint || right == kNoJoint) return;
    int fork = tree_.common_ancestor(left, right);
    // In some rigs the clavicles are children of the neck.
    while (fork != kNoJoint && map_.joint[Role::neck] == fork) fork = tree_.parent(fork);
    // The pelvis may be a leaf beside the spine: then any joint above their common ancestor will
    // do.
    if (fork == kNoJoint || tree_.hangs_from(pelvis, fork)) return;
    assign(Role::chest, fork, RoleSource::topology);
  }
  if (!found(Role::abdomen)) find_abdomen();
}

void RoleFinder::find_abdomen() {
  const int pelvis = joint(Role::pelvis);
  const int chest = joint(Role::chest);
  const int fork = tree_.common_ancestor(pelvis, chest);
  if (fork == kNoJoint) return;
  int taken = kNoJoint;
  for (int candidate : tree_.between(fork, chest)) {
    if (used_[index(candidate)] || tree_.coincide(candidate, chest)) continue;
    // A joint of zero length still rotates: better than none. Of several at one position, the
    // last has the rotations of all.
    const bool is_better = taken == kNoJoint || tree_.coincide(taken, pelvis);
    if (is_better || tree_.coincide(candidate, taken)) taken = candidate;
  }
  if (taken != kNoJoint) assign(Role::abdomen, taken, RoleSource::topology);
}

void RoleFinder::find_head_and_neck() {
  if (!found(Role::head) && found(Role::neck)) {
    const int neck = joint(Role::neck);
    release(Role::neck);
    assign(Role::head, neck, RoleSource::topology);
  }
  if (!found(Role::chest) || !found(Role::head)) return;
  if (map_.source[Role::neck] == RoleSource::override_) return;
  if (found(Role::neck)) {
    // A named neck at the position of the chest joint has no length of its own.
    if (!tree_.coincide(joint(Role::neck), joint(Role::chest))) return;
    release(Role::neck);
  }
  int taken = kNoJoint;
  for (int candidate : tree_.between(joint(Role::chest), joint(Role::head))) {
    const bool has_length = !tree_.coincide(candidate, joint(Role::chest)) &&
                            !tree_.coincide(candidate, joint(Role::head));
    // As with the abdomen, the last of several at one position.
    if (has_length && (taken == kNoJoint || tree_.coincide(candidate, taken))) taken = candidate;
  }
  if (taken != kNoJoint) assign(Role::neck, taken, RoleSource::topology);
}

void RoleFinder::complete(std::span<const Role> roles, const PerRole<int>& joints) {
  for (Role role : roles) {
    if (!found(role) && joints[role] != kNoJoint && !used_[index(joints[role])]) {
      assign(role, joints[role], RoleSource::topology);
    }
  }
}

std::vector<int> RoleFinder::free_joints() const {
  std::vector<int> free;
  for (int i = 0; i < tree_.count(); ++i) {
    if (!used_[index(i)]) free.push_back(i);
  }
  return free;
}

std::string RoleFinder::listed(const std::vector<int>& joints) const {
  constexpr std::size_t kMost = 40;
  std::string text;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (i == kMost) return text + ", … (" + std::to_string(joints.size() - kMost) + " more)";
    text += (i == 0 ? "" : ", ") + bvh_.joints[index(joints[i])].name;
  }
  return text;
}

}  // namespace flinch::database
