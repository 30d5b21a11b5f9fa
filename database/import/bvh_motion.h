// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/bvh.h"
#include "database/import/bvh_lexer.h"

namespace flinch::database {

/// Parses what follows the word MOTION into `bvh`, whose hierarchy is complete: frame_time_s,
/// frame_count, values, warnings. Throws Error.
void parse_bvh_motion(BvhLexer& lexer, Bvh& bvh);

}  // namespace flinch::database
