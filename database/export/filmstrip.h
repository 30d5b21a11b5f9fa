// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "database/export/ball_track.h"
#include "motion/clip.h"
#include "motion/figure.h"

namespace flinch::database {

/// Draws a clip as an SVG document: the figure's outlines at eight times from the first pose to the
/// last, including the peak, seen from the left side (upper row) and from the front (lower row). An
/// arrow shows the threat's direction; times are labelled in seconds. The threat is drawn too where
/// it is given and near: its track has a place for each pose.
std::string filmstrip_svg(const motion::Figure& figure, const motion::Clip& clip,
                          const BallTrack* threat = nullptr);

/// The first bytes of every filmstrip, and of few other SVG files.
inline constexpr std::string_view kFilmstripMark =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 ";

}  // namespace flinch::database
