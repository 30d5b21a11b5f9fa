// SPDX-License-Identifier: MIT
#include "sim/rehearsal/rehearsal.h"

#include <algorithm>
#include <cmath>

#include "sim/encounter/encounter.h"
#include "sim/rehearsal/rehearsal_track.h"

namespace flinch::sim {
namespace {

Rehearsal::Track::Sphere reach_sphere(const FigureModel& figure_model, const StepPath& path) {
  Rehearsal::Track::Sphere sphere;
  sphere.centre.setZero();
  for (const BodyState& body : path.from) sphere.centre += body.position / motion::kBodyCount;
  for (motion::Body body : motion::kBodies) {
    const BodyState state = path.moving(body);
    const double radius = figure_model.radius[body];
    const double speed = state.velocity.norm() + state.angular_velocity.norm() * radius;
    sphere.radius = std::max(
        sphere.radius, (state.position - sphere.centre).norm() + radius + speed * path.step_s);
  }
  return sphere;
}

}  // namespace

Rehearsal::Track::Track(const FigureModel& figure_model, const SimulationOptions& options,
                        const motion::Motion& response, double kept_from_s, double rehearsed_s)
    : motion(response),
      reference(figure_model.skeleton, figure_model.model, motion),
      from_s(kept_from_s),
      duration_s(rehearsed_s) {
  const auto steps = static_cast<std::size_t>(std::ceil(duration_s / options.free_step_s)) + 1;
  step_begins_s.reserve(steps);
  reach.reserve(steps);
  figures.reserve(steps + 1);
  ReferenceState now = reference.at(0);
  Encounter<TreeScene> encounter(figure_model, options, 0, figure_model, now.body, nullptr,
                                 options.gravity_mps2);
  while (encounter.time_s() < duration_s) {
    if (encounter.time_s() <= from_s) {
      figures.clear();
      first_kept = step_begins_s.size();
    }
    step_begins_s.push_back(encounter.time_s());
    figures.push_back(encounter.scene().bodies());
    const double step_s = encounter.begin_step(now, duration_s - encounter.time_s());
    const ReferenceState target = reference.at(encounter.time_s() + step_s);
    encounter.end_step(now, target, step_s);
    reach.push_back(
        reach_sphere(figure_model, {figures.back(), encounter.scene().bodies(), step_s}));
    now = target;
  }
  figures.push_back(encounter.scene().bodies());
  if (first_kept > 0) figures.shrink_to_fit();
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
