// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "database/import/joint_tree.h"
#include "database/import/role_names.h"
#include "motion/role.h"

namespace flinch::database {

/// Guesses the joints of the pelvis, the limbs and the head from the tree's shape and lengths
/// alone: the two longest pairs of equally long branches are the legs and, above them, the arms;
/// the longest other branch beside the arms is neck and head. A joint with a helper's name is left
/// out. Where branches have no side in their names, left follows from the head, which is up, and
/// from the feet, which point forward.
///
/// A guess to show to a user, not to use unseen. Roles that it cannot tell are kNoJoint. Nothing
/// where the tree has no such branches.
std::optional<motion::PerRole<int>> guess_roles(const JointTree& tree,
                                                const std::vector<PlainName>& names);

}  // namespace flinch::database
