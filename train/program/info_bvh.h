// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/bvh.h"
#include "database/role_map.h"
#include "train/program/command.h"

namespace flinch::train::program {

/// A BVH file and which of its joints plays which role.
struct MappedBvh {
  database::Bvh bvh;
  database::RoleMap roles;
};

/// `overrides` names a TOML file with a table [roles], or is empty. Throws Error.
MappedBvh read_mapped_bvh(const std::string& path, const std::string& overrides);

Json bvh_document(const MappedBvh& mapped);
void print_bvh(const MappedBvh& mapped);

}  // namespace flinch::train::program
