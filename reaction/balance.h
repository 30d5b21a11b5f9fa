// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/figure/figure_rows.h"

namespace flinch::reaction {

/// Returns the distance of a ground point outside the convex hull of `points`, m; 0 inside it.
/// There must be at least one of `points`. Allocates nothing.
double distance_outside(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& point);

/// Returns the distance of a figure's extrapolated centre of mass outside its soles, m; 0 inside
/// them (Hof, Gazendam and Sinke 2005, "The condition for dynamic stability"):
///
///     XcoM = x + v / w0,   w0 = sqrt(g / l)
///
/// with horizontal position x and velocity v of the centre of mass, and its height l. Only corners
/// of the soles within 5 cm of the ground count, or all corners if the figure is in the air.
double out_of_balance_m(const sim::FigureModel& figure_model,
                        const motion::PerBody<sim::BodyState>& bodies);

/// Whether a figure that is out of balance by `out_m` cannot recover with a step. In the time T of
/// a step the distance grows by e^(w0 T), and the foot reaches at most the leg's length (Hof 2008,
/// "The 'extrapolated center of mass' concept"; T = 0.2 s, a quick step).
bool is_beyond_a_step(const sim::FigureModel& figure_model, double out_m);

}  // namespace flinch::reaction
