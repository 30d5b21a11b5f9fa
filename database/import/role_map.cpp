// SPDX-License-Identifier: MIT
#include "database/import/role_map.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "database/import/limb_match.h"
#include "database/import/role_guess.h"
#include "database/import/role_names.h"
#include "database/import/toml_string.h"

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::name_of;
using motion::PerRole;
using motion::Role;

constexpr std::size_t kMostJoints = 4096;  // no rig of a human has more; bounds the work
constexpr double kMirroredRatio = 2;       // at most, between the lengths of mirrored bones

constexpr std::array kRequired{
    Role::pelvis,          Role::chest,         Role::head,        Role::left_upper_arm,
    Role::left_forearm,    Role::left_thigh,    Role::left_shin,   Role::left_foot,
    Role::right_upper_arm, Role::right_forearm, Role::right_thigh, Role::right_shin,
    Role::right_foot,
};

constexpr std::array kLimbs{kLeftArm, kRightArm, kLeftLeg, kRightLeg};

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

class Mapper {
 public:
  explicit Mapper(const Bvh& bvh)
      : bvh_(bvh), tree_(bvh), names_(plain_names(names_of(bvh))), used_(bvh.joints.size()) {
    given_ = no_joints();
    map_.joint = no_joints();
  }

  RoleMap map(const RoleOverrides& overrides) {
    apply(overrides);
    for (Role role : {Role::pelvis, Role::neck, Role::head}) find_by_name(role);
    find_limbs(kLeftArm, kRightArm);
    find_limbs(kLeftLeg, kRightLeg);
    find_trunk();
    check();
    return map_;
  }

 private:
  static std::size_t index(int joint) { return static_cast<std::size_t>(joint); }
  const std::string& name(int joint) const { return bvh_.joints[index(joint)].name; }
  bool found(Role role) const { return map_.joint[role] != kNoJoint; }
  int joint(Role role) const { return map_.joint[role]; }
  NamedTree figure() const { return {tree_, names_, given_}; }

  void assign(Role role, int joint, RoleSource source) {
    map_.joint[role] = joint;
    map_.source[role] = source;
    used_[index(joint)] = true;
  }

  void release(Role role) {
    used_[index(map_.joint[role])] = false;
    map_.joint[role] = kNoJoint;
    map_.source[role] = RoleSource::none;
  }

  void apply(const RoleOverrides& overrides) {
    for (const auto& [role, joint_name] : overrides) {
      const auto named = [&wanted = joint_name](const BvhJoint& joint) {
        return joint.name == wanted;
      };
      const auto at = std::find_if(bvh_.joints.begin(), bvh_.joints.end(), named);
      if (at == bvh_.joints.end()) {
        throw Error(bvh_.path, "no joint is named \"" + joint_name +
                                   "\", which the roles give for " + std::string(name_of(role)) +
                                   "; its joints are: " + list(all()));
      }
      given_[role] = static_cast<int>(at - bvh_.joints.begin());
      assign(role, static_cast<int>(at - bvh_.joints.begin()), RoleSource::override_);
    }
  }

  void find_by_name(Role role) {
    if (found(role)) return;
    for (std::string_view stem : middle_stems(role)) {
      for (int candidate = 0; candidate < tree_.count(); ++candidate) {
        if (used_[index(candidate)] || !is_named(names_[index(candidate)], stem)) continue;
        assign(role, candidate, RoleSource::name);
        return;
      }
    }
  }

  void find_limbs(const LimbRoles& left, const LimbRoles& right) {
    const auto [left_limb, right_limb] = match_limbs(figure(), left, right);
    assign_limb(left, left_limb);
    assign_limb(right, right_limb);
  }

  void assign_limb(const LimbRoles& roles, const LimbMatch& limb) {
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (!found(roles[i]) && limb.joint[i] != kNoJoint) {
        assign(roles[i], limb.joint[i], limb.source[i]);
      }
    }
  }

  void find_trunk() {
    find_pelvis();
    find_spine();
    find_head_and_neck();
  }

  // The pelvis is where the legs branch. A pelvis found by name is kept unless the legs are not its
  // descendants.
  void find_pelvis() {
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
  int arm_root(Role clavicle, Role upper_arm) const {
    return found(clavicle) ? joint(clavicle) : joint(upper_arm);
  }

  void find_spine() {
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

  void find_abdomen() {
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

  void find_head_and_neck() {
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

  std::vector<int> all() const {
    std::vector<int> joints(bvh_.joints.size());
    for (int i = 0; i < tree_.count(); ++i) joints[index(i)] = i;
    return joints;
  }

  std::string list(const std::vector<int>& joints) const {
    constexpr std::size_t kMost = 40;
    std::string text;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (i == kMost) return text + ", … (" + std::to_string(joints.size() - kMost) + " more)";
      text += (i == 0 ? "" : ", ") + name(joints[i]);
    }
    return text;
  }

  bool has_limb(const LimbRoles& roles) const {
    return std::ranges::all_of(roles,
                               [this](Role role) { return found(role) || !is_required(role); });
  }

  void check() const {
    PerRole<int> named = map_.joint;
    for (const LimbRoles& roles : kLimbs) {
      if (!has_limb(roles)) name_limb(roles, named);
    }
    std::vector<Role> missing;
    for (Role role : kRequired) {
      // The chest is where the arms branch off, the pelvis where the legs do: without limbs, it is
      // they that are missing.
      const bool says_nothing =
          (role == Role::chest && !(has_limb(kLeftArm) && has_limb(kRightArm))) ||
          (role == Role::pelvis && !(has_limb(kLeftLeg) && has_limb(kRightLeg)));
      if (named[role] == kNoJoint && !says_nothing) missing.push_back(role);
    }
    if (!missing.empty()) fail_missing(missing);
    for (const LimbRoles& roles : kLimbs) check_chain(roles, named);
    for (const LimbRoles& roles : kLimbs) {
      if (!has_limb(roles)) fail_impossible(roles, named);
    }
    check_mirrored(kLeftArm);
    check_mirrored(kLeftLeg);
  }

  // The joints that the names alone give to a limb that is no chain, to say what is wrong with it.
  void name_limb(const LimbRoles& roles, PerRole<int>& named) const {
    for (Role role : roles) {
      if (given_[role] != kNoJoint) continue;
      NameFit best = NameFit::possible;
      for (int candidate = 0; candidate < tree_.count(); ++candidate) {
        const NameFit fit = fit_of(names_[index(candidate)], role);
        if (fit <= best) continue;
        best = fit;
        named[role] = candidate;
      }
    }
  }

  std::string titled(Role role, const PerRole<int>& named) const {
    return std::string(name_of(role)) + " (" + name(named[role]) + ")";
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw RoleError(bvh_.path, what + "; map both under [roles] in a TOML file",
                    table_of(suggested_roles()));
  }

  [[noreturn]] void fail_missing(const std::vector<Role>& missing) const {
    constexpr std::size_t kMostMissing = 4;
    std::string names;
    for (std::size_t i = 0; i < missing.size(); ++i) {
      if (i == kMostMissing && missing.size() > kMostMissing + 1) {
        names += " and " + std::to_string(missing.size() - i) + " more roles";
        break;
      }
      names += (i == 0 ? "" : ", ") + std::string(name_of(missing[i]));
    }
    std::vector<int> free = all();
    std::erase_if(free, [&](int candidate) { return used_[index(candidate)]; });
    const std::string left_over =
        free.empty() ? "; it has no joint left" : "; joints left over: " + list(free);
    const std::optional<PerRole<int>> suggested = suggested_roles();
    if (!suggested && 2 * missing.size() > kRequired.size()) {
      throw RoleError(bvh_.path,
                      "not a human figure that is known: " + std::to_string(tree_.count()) +
                          " joints, and none for " + names + left_over +
                          "; if it is one, map its joints under [roles] in a TOML file",
                      "");
    }
    const std::string example = suggested      ? name((*suggested)[missing.front()])
                                : free.empty() ? "JOINT"
                                               : name(free.front());
    throw RoleError(bvh_.path,
                    "no joint found for " + names + (suggested ? "" : left_over) +
                        "; map it in a TOML file: [roles] " +
                        std::string(name_of(missing.front())) + " = " + toml_string(example),
                    table_of(suggested));
  }

  void check_chain(const LimbRoles& roles, const PerRole<int>& named) const {
    std::optional<Role> above;
    for (Role role : roles) {
      if (named[role] == kNoJoint) continue;
      if (above) check_link(*above, role, named);
      above = role;
    }
  }

  void check_link(Role upper, Role lower, const PerRole<int>& named) const {
    const bool both_given = given_[upper] != kNoJoint && given_[lower] != kNoJoint;
    if (!tree_.hangs_from(named[lower], named[upper])) {
      fail(titled(lower, named) + " does not hang from " + titled(upper, named));
    }
    for (int between : tree_.between(named[upper], named[lower])) {
      if (both_given ||
          needs_no_role(figure(), between, {upper, named[upper]}, {lower, named[lower]})) {
        continue;
      }
      fail("the joint " + name(between) + " between " + titled(upper, named) + " and " +
           titled(lower, named) + " has a length but no role");
    }
  }

  [[noreturn]] void fail_impossible(const LimbRoles& roles, const PerRole<int>& named) const {
    const Role first = is_required(roles[0]) ? roles[0] : roles[1];
    if (tree_.coincide(named[first], named[motion::mirrored(first)])) {
      fail(titled(first, named) + " and " + titled(motion::mirrored(first), named) +
           " are at one place");
    }
    std::string limb;
    for (Role role : roles) {
      if (named[role] != kNoJoint) limb += (limb.empty() ? "" : ", ") + titled(role, named);
    }
    fail("no human has bones as long as those of " + limb);
  }

  void check_mirrored(const LimbRoles& left) const {
    for (std::size_t i = 1; i < left.size(); ++i) {
      const Role upper = left[i - 1];
      const Role lower = left[i];
      if (!is_required(upper) || !is_required(lower)) continue;
      const double one = length(upper, lower);
      const double other = length(motion::mirrored(upper), motion::mirrored(lower));
      if (std::max(one, other) <= kMirroredRatio * std::min(one, other)) continue;
      if (is_given(upper) || is_given(lower)) continue;
      fail(titled(upper, map_.joint) + " is more than twice as long or short as " +
           titled(motion::mirrored(upper), map_.joint));
    }
  }

  double length(Role upper, Role lower) const { return tree_.distance(joint(upper), joint(lower)); }

  bool is_given(Role role) const {
    return given_[role] != kNoJoint || given_[motion::mirrored(role)] != kNoJoint;
  }

  // What was found by name, completed by the skeleton's shape; nothing where that does not give all
  // required roles.
  std::optional<PerRole<int>> suggested_roles() const {
    const std::optional<PerRole<int>> guess = guess_roles(tree_, names_);
    if (!guess) return std::nullopt;
    Mapper other(bvh_);
    for (Role role : kRoles) {
      if (given_[role] != kNoJoint) other.assign(role, given_[role], RoleSource::override_);
    }
    for (const LimbRoles& roles : kLimbs) {
      other.complete(roles, has_limb(roles) ? map_.joint : *guess);
    }
    for (Role role : {Role::pelvis, Role::neck, Role::head}) other.find_by_name(role);
    other.complete(std::array{Role::head}, *guess);
    other.find_trunk();
    if (!std::ranges::all_of(kRequired, [&](Role role) { return other.found(role); })) {
      return std::nullopt;
    }
    return other.map_.joint;
  }

  std::string table_of(const std::optional<PerRole<int>>& joints) const {
    if (!joints) return "";
    std::string table =
        "# Suggested by the skeleton's shape. Correct it, save it, and give the file with "
        "--roles.\n"
        "[roles]\n";
    for (Role role : kRoles) {
      if ((*joints)[role] == kNoJoint) continue;
      table += std::string(name_of(role)) + " = " + toml_string(name((*joints)[role])) + '\n';
    }
    return table;
  }

  void complete(std::span<const Role> roles, const PerRole<int>& joints) {
    for (Role role : roles) {
      if (!found(role) && joints[role] != kNoJoint && !used_[index(joints[role])]) {
        assign(role, joints[role], RoleSource::topology);
      }
    }
  }

  const Bvh& bvh_;
  JointTree tree_;
  std::vector<PlainName> names_;  ///< one per joint
  std::vector<bool> used_;        ///< per joint: whether it has a role
  PerRole<int> given_;            ///< joints that the user gives
  RoleMap map_;
};

}  // namespace

std::string_view name_of(RoleSource source) {
  switch (source) {
    case RoleSource::none:
      return "none";
    case RoleSource::override_:
      return "override";
    case RoleSource::name:
      return "name";
    case RoleSource::topology:
      return "topology";
  }
  return "none";
}

bool is_required(Role role) {
  return std::find(kRequired.begin(), kRequired.end(), role) != kRequired.end();
}

RoleMap map_roles(const Bvh& bvh, const RoleOverrides& overrides) {
  if (bvh.joints.size() > kMostJoints) {
    throw Error(bvh.path, "not a human figure: " + std::to_string(bvh.joints.size()) + " joints");
  }
  return Mapper(bvh).map(overrides);
}

}  // namespace flinch::database
