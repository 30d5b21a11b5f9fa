// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/bvh.h"
#include "database/import/bvh_lexer.h"

namespace flinch::database {

/// Reads what follows the word MOTION into `bvh`, whose hierarchy stands: frame_time_s,
/// frame_count, values, warnings. Throws Error.
void parse_bvh_motion(BvhLexer& lexer, Bvh& bvh);

}  // namespace flinch::database
