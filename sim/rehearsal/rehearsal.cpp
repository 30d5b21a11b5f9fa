// SPDX-License-Identifier: MIT
#include "sim/rehearsal/rehearsal.h"

#include <cmath>
#include <utility>

#include "sim/rehearsal/rehearsal_track.h"

namespace flinch::sim {

Rehearsal::Track::Track(const FigureModel& figure_model, const SimulationOptions& options,
                        motion::Motion response, double kept_from_s, double rehearsed_s)
    : motion(std::move(response)),
      reference(figure_model.skeleton, figure_model.model, motion),
      from_s(kept_from_s),
      duration_s(rehearsed_s) {
  const auto steps = static_cast<std::size_t>(std::ceil(duration_s / options.free_step_s)) + 1;
  step_begins_s.reserve(steps);
  reach.reserve(steps);
  figures.reserve(steps + 1);
}

void Rehearsal::Track::copy_recording(const Track& other) {
  recorded_s = other.recorded_s;
  step_begins_s = other.step_begins_s;
  reach = other.reach;
  first_kept = other.first_kept;
  figures = other.figures;
}

bool Rehearsal::Track::Sphere::may_reach(const features::Ball& ball, double time_s,
                                         double distance_m) const {
  const double speed = ball.pivot_velocity().norm() + ball.turning_mps();
  const double travel = speed * time_s + ball.gravity_mps2 * time_s * time_s / 2;
  const double max_distance = radius + ball.bounding_radius() + travel + distance_m;
  return (ball.position - centre).squaredNorm() <= max_distance * max_distance;
}

std::size_t Rehearsal::Track::byte_count() const {
  return sizeof(Track) + motion.poses.capacity() * sizeof(motion::Pose) + reference.byte_count() +
         step_begins_s.capacity() * sizeof(double) + reach.capacity() * sizeof(Sphere) +
         figures.capacity() * sizeof(motion::PerBody<BodyState>);
}

Rehearsal::Rehearsal(std::unique_ptr<const Track> track) : track_(std::move(track)) {}
Rehearsal::~Rehearsal() = default;
Rehearsal::Rehearsal(Rehearsal&&) noexcept = default;
Rehearsal& Rehearsal::operator=(Rehearsal&&) noexcept = default;

double Rehearsal::from_s() const {
  return track_->from_s;
}

double Rehearsal::duration_s() const {
  return track_->duration_s;
}

std::size_t Rehearsal::byte_count() const {
  return sizeof(Rehearsal) + track_->byte_count();
}

}  // namespace flinch::sim
