// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "database/import/joint_tree.h"
#include "database/import/limb_match.h"
#include "database/import/role_map.h"
#include "database/import/role_names.h"

namespace flinch::database {

/// Finds the joints of roles by name and topology, as map_roles describes, without judging the
/// result. `bvh` must outlive the finder.
class RoleFinder {
 public:
  explicit RoleFinder(const Bvh& bvh);

  /// Takes the joints that the user names. Throws Error for a joint that the file does not have.
  void give(const RoleOverrides& overrides);
  void give(motion::Role role, int joint);

  /// Finds pelvis, neck and head by name, then the limbs as chains, then the trunk.
  void find();

  /// The steps of find().
  void find_by_name(motion::Role role);
  void find_limbs(const LimbRoles& left, const LimbRoles& right);
  void find_trunk();

  /// Takes the joints of `joints` for those of the roles that have none yet.
  void complete(std::span<const motion::Role> roles, const motion::PerRole<int>& joints);

  const RoleMap& map() const { return map_; }
  const motion::PerRole<int>& given() const { return given_; }  ///< else kNoJoint
  NamedTree figure() const { return {tree_, names_, given_}; }
  const Bvh& bvh() const { return bvh_; }
  bool found(motion::Role role) const { return map_.joint[role] != kNoJoint; }
  /// Joints without a role, in the file's order.
  std::vector<int> free_joints() const;
  /// The joints' own names, separated by commas; of more than 40 the first.
  std::string listed(const std::vector<int>& joints) const;

 private:
  static std::size_t index(int joint) { return static_cast<std::size_t>(joint); }
  int joint(motion::Role role) const { return map_.joint[role]; }
  void assign(motion::Role role, int joint, RoleSource source);
  void release(motion::Role role);
  void assign_limb(const LimbRoles& roles, const LimbMatch& limb);
  void find_pelvis();
  int arm_root(motion::Role clavicle, motion::Role upper_arm) const;
  void find_spine();
  void find_abdomen();
  void find_head_and_neck();

  const Bvh& bvh_;
  JointTree tree_;
  std::vector<PlainName> names_;  ///< one per joint
  std::vector<bool> used_;        ///< per joint: whether it has a role
  motion::PerRole<int> given_;    ///< joints that the user gives
  RoleMap map_;
};

}  // namespace flinch::database
