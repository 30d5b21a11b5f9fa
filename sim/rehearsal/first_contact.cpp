// SPDX-License-Identifier: MIT
#include "sim/rehearsal/first_contact.h"

#include <algorithm>

#include "motion/error.h"
#include "sim/contact/next_step.h"

namespace flinch::sim {

std::optional<FirstContact> first_contact(const FigureModel& figure_model,
                                          const Rehearsal::Track& track,
                                          const features::Ball& ball) {
  for (std::size_t step = 0; step < track.step_begins_s.size(); ++step) {
    const features::Ball flight = ball.at(track.step_begins_s[step]);
    if (flight.window.is_over()) return std::nullopt;
    const double step_s = track.step_s(step);
    if (!flight.window.opens_within(step_s)) continue;
    const auto bounce_s = features::time_of_bounce(flight, step_s, kContactDistance_m);
    if (!bounce_s && !track.reach[step].may_reach(flight, step_s, kContactDistance_m)) continue;
    if (step < track.first_kept) {
      throw Error("simulation", "the ball reaches the figure before the rehearsal starts, at " +
                                    std::to_string(track.from_s) + " s");
    }
    const StepPath path = track.path_of(step);
    const auto contact_s = first_contact(figure_model, path, flight, bounce_s);
    if (!contact_s) continue;
    const double until_s = std::max(*contact_s, kMinStep_s);
    if (until_s >= step_s) continue;
    return FirstContact{track.step_begins_s[step] + until_s, contact_s == bounce_s,
                        path.at(until_s)};
  }
  return std::nullopt;
}

}  // namespace flinch::sim
