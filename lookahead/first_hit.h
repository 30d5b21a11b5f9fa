// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>

#include "features/ball.h"
#include "lookahead/response_reference.h"

namespace flinch::lookahead {

/// What is known of a ball's first hit without simulating it.
struct FirstHit {
  double damage_ns = 0;  ///< at least; 0 where nothing is known
  /// Time of the contact, s after perception; infinite where nothing is known.
  double contact_s = std::numeric_limits<double>::infinity();
};

/// Finds the first hit of `ball`, as it is at perception, on the response that `reference` follows,
/// and the least damage that it does to a figure which is within kMaxLag_m of the response. `frame`
/// is the first after which the ball may come near. Knows nothing of hits after a bounce, of those
/// that come late, and of those before which the ball grazes another part. Not for rods, whose
/// effective mass depends on the place. `vulnerability` is v_b.
FirstHit least_first_hit(ResponseReference& reference, const sim::FigureModel& figure_model,
                         const features::Ball& ball, std::size_t frame,
                         const motion::PerBody<double>& vulnerability);

/// By how much the figure is beside the response where it is hit, m.
inline constexpr double kMaxLag_m = 0.01;

}  // namespace flinch::lookahead
