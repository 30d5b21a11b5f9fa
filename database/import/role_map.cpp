// SPDX-License-Identifier: MIT
#include "database/import/role_map.h"

#include <algorithm>

#include "database/import/role_check.h"

namespace flinch::database {
namespace {

using motion::Role;

constexpr std::size_t kMostJoints = 4096;  // no rig of a human has more; bounds the work

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
  return std::ranges::find(kRequiredRoles, role) != kRequiredRoles.end();
}

RoleMap map_roles(const Bvh& bvh, const RoleOverrides& overrides) {
  if (bvh.joints.size() > kMostJoints) {
    throw Error(bvh.path, "not a human figure: " + std::to_string(bvh.joints.size()) + " joints");
  }
  RoleFinder finder(bvh);
  finder.give(overrides);
  finder.find();
  check_roles(finder);
  return finder.map();
}

}  // namespace flinch::database
