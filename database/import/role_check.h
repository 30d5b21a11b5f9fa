// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/role_finder.h"

namespace flinch::database {

/// Throws RoleError where the joints found are no human figure, as map_roles says, with a
/// suggestion where the skeleton's shape allows one.
void check_roles(const RoleFinder& finder);

}  // namespace flinch::database
