// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/reference_pose.h"
#include "database/import/source_figure.h"

namespace flinch::database {

/// Replaces the ends of hands, feet and toes that no human has. Exporters write End Sites as stubs
/// of no length and as tails that point anywhere, and put toe joints on the ankle. Whether an end
/// is possible shows in a standing pose.
///
/// The end of a foot becomes its ball. That is the toes' joint, or the End Site where that is no
/// farther from the ankle than a ball; of an End Site as far as the tip of the toes, a part of the
/// way. Where neither is possible, the ball is that of a mean foot, in proportion to the legs. A
/// foot whose toes' joint is at its ankle turns with that joint. An impossible hand, toe or wrist
/// has no end.
SourceFigure with_human_ends(SourceFigure figure, const StandingPose& standing);

}  // namespace flinch::database
