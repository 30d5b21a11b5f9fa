// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/import/bvh.h"
#include "database/import/role_map.h"
#include "motion/role.h"

namespace flinch::tests {

/// Joint names as a tool or data set writes them.
struct NamedRig {
  std::string title;
  motion::PerRole<std::string> names;  ///< empty: the rig has no such joint
};

/// One rig per family of tools that docs/importing.md lists, and more.
const std::vector<NamedRig>& named_rigs();

/// The names of the rig with this title.
const motion::PerRole<std::string>& names_in(const std::string& title);

/// The default character in T-pose for one frame, with these names.
database::Bvh named_figure(const motion::PerRole<std::string>& names);

/// The index of the first joint with this name. Throws std::logic_error without one.
std::size_t joint_named(const database::Bvh& bvh, const std::string& name);

/// Puts a joint into the bone above `below`, at a fraction of its length.
void insert_above(database::Bvh& bvh, const std::string& below, const std::string& name,
                  double fraction);

/// The name of the joint that has the role; empty without one.
std::string joint_of(const database::Bvh& bvh, const database::RoleMap& map, motion::Role role);

/// Maps the file's joints to roles and expects these names.
void expect_roles(const database::Bvh& bvh, const motion::PerRole<std::string>& names);

}  // namespace flinch::tests
