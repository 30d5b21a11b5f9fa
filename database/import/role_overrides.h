// SPDX-License-Identifier: MIT
#pragma once

#include "database/files/toml_reader.h"
#include "database/import/role_map.h"

namespace flinch::database {

/// Reads the lines `role = "joint name"` of a table. Throws Error for an unknown role.
RoleOverrides role_overrides(const TomlReader& roles);

}  // namespace flinch::database
