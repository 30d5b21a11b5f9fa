// SPDX-License-Identifier: MIT
#include "database/import/role_map.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "database/import/role_names.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::name_of;
using motion::Role;

constexpr int kNone = -1;
// fraction of the figure's size: joints nearer than this coincide
constexpr double kNoLength = 1e-6;

constexpr std::array kRequired{
    Role::pelvis,          Role::chest,         Role::head,        Role::left_upper_arm,
    Role::left_forearm,    Role::left_thigh,    Role::left_shin,   Role::left_foot,
    Role::right_upper_arm, Role::right_forearm, Role::right_thigh, Role::right_shin,
    Role::right_foot,
};

// The roles along a limb, from the trunk outwards.
struct LimbChain {
  Role trunk;
  std::array<Role, 4> roles;
};
constexpr std::array<LimbChain, 4> kLimbChains{{
    {Role::chest, {Role::left_clavicle, Role::left_upper_arm, Role::left_forearm, Role::left_hand}},
    {Role::chest,
     {Role::right_clavicle, Role::right_upper_arm, Role::right_forearm, Role::right_hand}},
    {Role::pelvis, {Role::left_thigh, Role::left_shin, Role::left_foot, Role::left_toes}},
    {Role::pelvis, {Role::right_thigh, Role::right_shin, Role::right_foot, Role::right_toes}},
}};

class Mapper {
 public:
  explicit Mapper(const Bvh& bvh)
      : bvh_(bvh), rest_(rest_frame(bvh)), children_(bvh.joints.size()), used_(bvh.joints.size()) {
    for (int joint = 0; joint < count(); ++joint) {
      if (parent(joint) != kNone) children_[index(parent(joint))].push_back(joint);
    }
    double size = 0;
    for (const Eigen::Vector3d& position : rest_.position) {
      size = std::max(size, (position - rest_.position.front()).norm());
    }
    no_length_ = kNoLength * size;
    map_.joint = {};
    for (Role role : kRoles) map_.joint[role] = kNone;
  }

  RoleMap map(const RoleOverrides& overrides) {
    apply(overrides);
    for (Role role : kRoles) find_by_name(role);
    find_pelvis();
    fill_limbs();
    find_spine();
    find_head_and_neck();
    check();
    return map_;
  }

 private:
  static std::size_t index(int joint) { return static_cast<std::size_t>(joint); }
  int count() const { return static_cast<int>(bvh_.joints.size()); }
  int parent(int joint) const { return bvh_.joints[index(joint)].parent; }
  const std::string& name(int joint) const { return bvh_.joints[index(joint)].name; }
  bool found(Role role) const { return map_.joint[role] != kNone; }
  int joint(Role role) const { return map_.joint[role]; }

  bool coincide(int one, int other) const {
    return (rest_.position[index(one)] - rest_.position[index(other)]).norm() <= no_length_;
  }

  void assign(Role role, int joint, RoleSource source) {
    map_.joint[role] = joint;
    map_.source[role] = source;
    used_[index(joint)] = true;
  }

  void release(Role role) {
    used_[index(map_.joint[role])] = false;
    map_.joint[role] = kNone;
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
      assign(role, static_cast<int>(at - bvh_.joints.begin()), RoleSource::override_);
    }
  }

  // Clavicles precede upper arms among the roles, but "shoulder" is a clavicle only where another
  // joint is the upper arm.
  void find_by_name(Role role) {
    if (found(role)) return;
    if (role == Role::left_clavicle) find_by_name(Role::left_upper_arm);
    if (role == Role::right_clavicle) find_by_name(Role::right_upper_arm);
    for (const auto matches : {&Mapper::matches_words, &Mapper::matches_run_together}) {
      for (std::string_view stem : stems_of(role)) {
        for (int candidate = 0; candidate < count(); ++candidate) {
          if (used_[index(candidate)] || !matches(name(candidate), stem, role)) continue;
          assign(role, candidate, RoleSource::name);
          return;
        }
      }
    }
  }

  static bool matches_words(const std::string& joint_name, std::string_view stem, Role role) {
    const PlainName plain = plain_name(joint_name);
    return plain.stem == stem && plain.side == side_of(role);
  }

  // "lfemur": Acclaim's names join side and stem without a separator.
  static bool matches_run_together(const std::string& joint_name, std::string_view stem,
                                   Role role) {
    const NameSide side = side_of(role);
    if (side == NameSide::none) return false;
    const PlainName plain = plain_name(joint_name);
    if (plain.side != NameSide::none || !plain.stem.ends_with(stem)) return false;
    return plain.stem.size() == stem.size() + 1 &&
           plain.stem.front() == (side == NameSide::left ? 'l' : 'r');
  }

  std::vector<int> path_to_root(int joint) const {
    std::vector<int> path;
    for (; joint != kNone; joint = parent(joint)) path.push_back(joint);
    return path;
  }

  bool hangs_from(int joint, int ancestor) const {
    const std::vector<int> path = path_to_root(joint);
    return std::find(path.begin(), path.end(), ancestor) != path.end();
  }

  // Returns the joints between `upper` and `lower`, from `upper` downwards, without either. Returns
  // nothing where `lower` is not a descendant of `upper`.
  std::vector<int> between(int upper, int lower) const {
    if (!hangs_from(lower, upper)) return {};
    std::vector<int> path;
    for (int at = parent(lower); at != upper && at != kNone; at = parent(at)) path.push_back(at);
    std::reverse(path.begin(), path.end());
    return path;
  }

  int common_ancestor(int one, int other) const {
    for (int candidate : path_to_root(one)) {
      if (hangs_from(other, candidate)) return candidate;
    }
    return kNone;
  }

  // The pelvis is where the legs branch. A pelvis found by name is kept unless the legs are not its
  // descendants.
  void find_pelvis() {
    if (!found(Role::left_thigh) || !found(Role::right_thigh)) return;
    const int fork = common_ancestor(joint(Role::left_thigh), joint(Role::right_thigh));
    if (fork == kNone || map_.source[Role::pelvis] == RoleSource::override_) return;
    if (found(Role::pelvis)) {
      if (hangs_from(fork, joint(Role::pelvis))) return;
      release(Role::pelvis);
    }
    assign(Role::pelvis, fork, RoleSource::topology);
  }

  // Maps limb joints without known names, where their neighbours leave one candidate.
  void fill_limbs() {
    for (const LimbChain& chain : kLimbChains) {
      for (std::size_t i = 1; i < chain.roles.size(); ++i) {
        if (found(chain.roles[i])) continue;
        const bool has_next = i + 1 < chain.roles.size() && found(chain.roles[i + 1]);
        const int taken = has_next ? last_with_length_above(joint(chain.roles[i + 1]))
                                   : only_child_with_length(chain.roles[i - 1]);
        if (taken != kNone && !used_[index(taken)]) {
          assign(chain.roles[i], taken, RoleSource::topology);
        }
      }
    }
  }

  int last_with_length_above(int joint) const {
    for (int above = parent(joint); above != kNone; above = parent(above)) {
      if (!coincide(above, joint)) return above;
    }
    return kNone;
  }

  // Returns the next joint below that is not at the same position; none if there are several.
  int only_child_with_length(Role role) const {
    if (!found(role)) return kNone;
    std::vector<int> open{joint(role)};
    std::vector<int> far;
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      for (int child : children_[index(at)]) {
        (coincide(child, joint(role)) ? open : far).push_back(child);
      }
    }
    return far.size() == 1 ? far.front() : kNone;
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
      if (left == kNone || right == kNone) return;
      int fork = common_ancestor(left, right);
      // In some rigs the clavicles are children of the neck.
      while (fork != kNone && map_.joint[Role::neck] == fork) fork = parent(fork);
      // The pelvis may be a leaf beside the spine: then any joint above their common ancestor will
      // do.
      if (fork == kNone || hangs_from(pelvis, fork)) return;
      assign(Role::chest, fork, RoleSource::topology);
    }
    if (!found(Role::abdomen)) find_abdomen();
  }

  void find_abdomen() {
    const int pelvis = joint(Role::pelvis);
    const int chest = joint(Role::chest);
    const int fork = common_ancestor(pelvis, chest);
    if (fork == kNone) return;
    int taken = kNone;
    for (int candidate : between(fork, chest)) {
      if (used_[index(candidate)] || coincide(candidate, chest)) continue;
      // A joint of zero length still rotates: better than none. Of several at one position, the
      // last has the rotations of all.
      const bool is_better = taken == kNone || coincide(taken, pelvis);
      if (is_better || coincide(candidate, taken)) taken = candidate;
    }
    if (taken != kNone) assign(Role::abdomen, taken, RoleSource::topology);
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
      if (!coincide(joint(Role::neck), joint(Role::chest))) return;
      release(Role::neck);
    }
    int taken = kNone;
    for (int candidate : between(joint(Role::chest), joint(Role::head))) {
      const bool has_length =
          !coincide(candidate, joint(Role::chest)) && !coincide(candidate, joint(Role::head));
      // As with the abdomen, the last of several at one position.
      if (has_length && (taken == kNone || coincide(candidate, taken))) taken = candidate;
    }
    if (taken != kNone) assign(Role::neck, taken, RoleSource::topology);
  }

  std::vector<int> all() const {
    std::vector<int> joints(bvh_.joints.size());
    for (int i = 0; i < count(); ++i) joints[index(i)] = i;
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

  void check() const {
    std::vector<Role> missing;
    for (Role role : kRequired) {
      if (!found(role)) missing.push_back(role);
    }
    if (!missing.empty()) throw_missing(missing);
    for (const LimbChain& chain : kLimbChains) check_chain(chain);
  }

  [[noreturn]] void throw_missing(const std::vector<Role>& missing) const {
    std::vector<int> free = all();
    std::erase_if(free, [&](int candidate) { return used_[index(candidate)]; });
    std::string names;
    for (Role role : missing) names += (names.empty() ? "" : ", ") + std::string(name_of(role));
    const std::string joints =
        free.empty() ? "it has no joint left" : "joints left over: " + list(free);
    if (2 * missing.size() > kRequired.size()) {
      throw Error(bvh_.path, "not a human figure that is known: " + std::to_string(count()) +
                                 " joints, and none for " + names + "; " + joints +
                                 "; if it is one, map its joints under [roles] in a TOML file");
    }
    throw Error(bvh_.path, "no joint found for " + names + "; " + joints +
                               "; map it in a TOML file: [roles] " +
                               std::string(name_of(missing.front())) + " = \"" +
                               (free.empty() ? "JOINT" : name(free.front())) + "\"");
  }

  void check_chain(const LimbChain& chain) const {
    Role above = chain.trunk;
    for (Role role : chain.roles) {
      if (!found(role)) continue;
      // A clavicle may be a child of the neck instead of the chest, and a thigh may be a sibling of
      // the pelvis.
      if (above != chain.trunk && !hangs_from(joint(role), joint(above))) {
        throw Error(bvh_.path, std::string(name_of(role)) + " (" + name(joint(role)) +
                                   ") does not hang from " + std::string(name_of(above)) + " (" +
                                   name(joint(above)) + "); map both under [roles] in a TOML file");
      }
      above = role;
    }
  }

  const Bvh& bvh_;
  BvhFrame rest_;
  std::vector<std::vector<int>> children_;
  std::vector<bool> used_;
  double no_length_ = 0;
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
  return Mapper(bvh).map(overrides);
}

}  // namespace flinch::database
