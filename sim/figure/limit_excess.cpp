// SPDX-License-Identifier: MIT
#include "sim/figure/limit_excess.h"

namespace flinch::sim {

double limit_excess_rad(const FigureModel& figure_model, const motion::PerBody<BodyState>& figure,
                        const ReferenceState& reference) {
  const auto rotation = [](const motion::PerBody<BodyState>& bodies, motion::Body body) {
    return bodies[*parent_of(body)].orientation.conjugate() * bodies[body].orientation;
  };
  double sum = 0;
  for (const motion::Body body : motion::kBodies) {
    if (!parent_of(body) || figure_model.kinds[body] == JointKind::fixed) continue;
    sum += limit_violation(figure_model.limits[body], rotation(figure, body),
                           rotation(reference.body, body))
               .norm();
  }
  return sum;
}

}  // namespace flinch::sim
