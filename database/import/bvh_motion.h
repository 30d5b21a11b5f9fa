// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/bvh.h"
#include "database/import/bvh_lexer.h"

namespace flinch::database {

/// Parses what follows the word MOTION into `bvh`, whose hierarchy is complete: frame_time_s,
/// frame_count, values, warnings. Where each line is a frame and `Frames` is wrong or the last line
/// cut short, reads the whole frames and adds a warning. Throws Error.
void parse_bvh_motion(BvhLexer& lexer, Bvh& bvh);

}  // namespace flinch::database
