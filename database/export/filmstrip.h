// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "motion/clip.h"
#include "motion/figure.h"

namespace flinch::database {

/// A clip drawn as an SVG document: the figure's outlines at eight instants from the first pose to
/// the last, the peak among them, seen from the left side (upper row) and from the front (lower
/// row), with an arrow along which the threat comes. Numbers are seconds.
std::string filmstrip_svg(const motion::Figure& figure, const motion::Clip& clip);

}  // namespace flinch::database
