// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sim/ode/figure.h"

namespace flinch::reaction {

inline constexpr double kGravity_mps2 = 9.81;

/// How far a point on the ground is outside the convex hull of others, m; 0 within it. At least one
/// other point. Allocates nothing.
double distance_outside(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& point);

/// How far a figure is out of balance: how far its extrapolated centre of mass is outside its
/// soles, m, 0 within them (Hof, Gazendam and Sinke 2005, "The condition for dynamic stability"):
///
///     XcoM = x + v / w0,   w0 = sqrt(g / l)
///
/// with x and v of the centre of mass, level, and l its height. Of the soles, the corners within
/// 5 cm of the ground count; of a figure in the air, all.
double out_of_balance_m(const sim::FigureModel& figure_model,
                        const motion::PerBody<sim::BodyState>& bodies);

/// Whether no step can save a figure that is out of balance by `out_m`: in the time T that a step
/// takes, the distance grows by e^(w0 T), and the foot reaches no farther than the leg is long (Hof
/// 2008, "The 'extrapolated center of mass' concept"; T = 0.2 s, a quick step).
bool is_beyond_a_step(const sim::FigureModel& figure_model, double out_m);

}  // namespace flinch::reaction
