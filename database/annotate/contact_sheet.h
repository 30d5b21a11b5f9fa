// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/annotate/draft.h"

namespace flinch::database {

/// Draws a draft as an SVG document to look at: a strip of eight poses for the idle and for each
/// clip, from its start to its end, with onset and peak among them, and what was guessed beside it.
/// The figure is seen from its right and front and stays in the middle of its column; the marks
/// on the ground, half a metre apart, show how far it has gone. An arrow at the peak comes from the
/// guessed direction.
std::string contact_sheet_svg(const Take& take, const Draft& draft);

}  // namespace flinch::database
