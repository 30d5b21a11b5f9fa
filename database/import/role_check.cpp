// SPDX-License-Identifier: MIT
#include "database/import/role_check.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "database/files/toml_string.h"
#include "database/import/role_guess.h"

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::name_of;
using motion::PerRole;
using motion::Role;

constexpr double kMirroredRatio = 2;  // at most, between the lengths of mirrored bones

constexpr std::array kLimbs{kLeftArm, kRightArm, kLeftLeg, kRightLeg};

class RoleChecker {
 public:
  explicit RoleChecker(const RoleFinder& finder) : finder_(finder) {}

  void check() const {
    PerRole<int> named = finder_.map().joint;
    for (const LimbRoles& roles : kLimbs) {
      if (!has_limb(roles)) name_limb(roles, named);
    }
    std::vector<Role> missing;
    for (Role role : kRequiredRoles) {
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

 private:
  static std::size_t index(int joint) { return static_cast<std::size_t>(joint); }
  const JointTree& tree() const { return finder_.figure().tree; }
  const std::vector<PlainName>& names() const { return finder_.figure().names; }
  const std::string& name(int joint) const { return finder_.bvh().joints[index(joint)].name; }

  bool has_limb(const LimbRoles& roles) const {
    return std::ranges::all_of(
        roles, [this](Role role) { return finder_.found(role) || !is_required(role); });
  }

  // The joints that the names alone give to a limb that is no chain, to say what is wrong with it.
  void name_limb(const LimbRoles& roles, PerRole<int>& named) const {
    for (Role role : roles) {
      if (finder_.given()[role] != kNoJoint) continue;
      NameFit best = NameFit::possible;
      for (int candidate = 0; candidate < tree().count(); ++candidate) {
        const NameFit fit = fit_of(names()[index(candidate)], role);
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
    throw RoleError(finder_.bvh().path, what + "; map both under [roles] in a TOML file",
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
    const std::vector<int> free = finder_.free_joints();
    const std::string left_over =
        free.empty() ? "; it has no joint left" : "; joints left over: " + finder_.listed(free);
    const std::optional<PerRole<int>> suggested = suggested_roles();
    if (!suggested && 2 * missing.size() > kRequiredRoles.size()) {
      throw RoleError(finder_.bvh().path,
                      "not a human figure that is known: " + std::to_string(tree().count()) +
                          " joints, and none for " + names + left_over +
                          "; if it is one, map its joints under [roles] in a TOML file",
                      "");
    }
    const std::string example = suggested      ? name((*suggested)[missing.front()])
                                : free.empty() ? "JOINT"
                                               : name(free.front());
    throw RoleError(finder_.bvh().path,
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
    const bool both_given =
        finder_.given()[upper] != kNoJoint && finder_.given()[lower] != kNoJoint;
    if (!tree().hangs_from(named[lower], named[upper])) {
      fail(titled(lower, named) + " does not hang from " + titled(upper, named));
    }
    for (int between : tree().between(named[upper], named[lower])) {
      if (both_given ||
          needs_no_role(finder_.figure(), between, {upper, named[upper]}, {lower, named[lower]})) {
        continue;
      }
      fail("the joint " + name(between) + " between " + titled(upper, named) + " and " +
           titled(lower, named) + " has a length but no role");
    }
  }

  [[noreturn]] void fail_impossible(const LimbRoles& roles, const PerRole<int>& named) const {
    const Role first = is_required(roles[0]) ? roles[0] : roles[1];
    if (tree().coincide(named[first], named[motion::mirrored(first)])) {
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
      fail(titled(upper, finder_.map().joint) + " is more than twice as long or short as " +
           titled(motion::mirrored(upper), finder_.map().joint));
    }
  }

  double length(Role upper, Role lower) const {
    return tree().distance(finder_.map().joint[upper], finder_.map().joint[lower]);
  }

  bool is_given(Role role) const {
    return finder_.given()[role] != kNoJoint || finder_.given()[motion::mirrored(role)] != kNoJoint;
  }

  // What was found by name, completed by the skeleton's shape; nothing where that does not give all
  // required roles.
  std::optional<PerRole<int>> suggested_roles() const {
    const std::optional<PerRole<int>> guess = guess_roles(tree(), names());
    if (!guess) return std::nullopt;
    RoleFinder other(finder_.bvh());
    for (Role role : kRoles) {
      if (finder_.given()[role] != kNoJoint) other.give(role, finder_.given()[role]);
    }
    for (const LimbRoles& roles : kLimbs) {
      other.complete(roles, has_limb(roles) ? finder_.map().joint : *guess);
    }
    for (Role role : {Role::pelvis, Role::neck, Role::head}) other.find_by_name(role);
    other.complete(std::array{Role::head}, *guess);
    other.find_trunk();
    if (!std::ranges::all_of(kRequiredRoles, [&](Role role) { return other.found(role); })) {
      return std::nullopt;
    }
    return other.map().joint;
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

  const RoleFinder& finder_;
};

}  // namespace

void check_roles(const RoleFinder& finder) {
  RoleChecker(finder).check();
}

}  // namespace flinch::database
