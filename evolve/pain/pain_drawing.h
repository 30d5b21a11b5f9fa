// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "evolve/pain/pain.h"
#include "motion/figure.h"

namespace flinch::evolve {

/// Draws the pain regions on the outlines of a figure in its rest pose as an SVG document: the
/// front, the back, and the head enlarged, with a legend of the multipliers.
std::string pain_svg(const motion::Figure& figure, const PainMap& map);

/// The first bytes of every such drawing, and of few other SVG files.
inline constexpr std::string_view kPainDrawingMark =
    "<svg xmlns='http://www.w3.org/2000/svg' id='pain' viewBox='0 0 ";

}  // namespace flinch::evolve
