// SPDX-License-Identifier: MIT
#include "sim/rehearsal/track_run.h"

#include <algorithm>

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

TrackRun::TrackRun(const FigureModel& figure_model, const SimulationOptions& options)
    : figure_model_(figure_model),
      encounter_(figure_model, options, 0, figure_model, motion::PerBody<BodyState>{}, nullptr,
                 options.gravity_mps2) {}

void TrackRun::start(Rehearsal::Track& track) {
  track_ = &track;
  now_ = track.reference.at(track.recorded_s);
  if (track.figures.empty()) track.figures.push_back(now_.body);
  encounter_.restart(track.recorded_s, track.figures.back(), nullptr);
}

bool TrackRun::begin_step() {
  Rehearsal::Track& track = *track_;
  const double time_s = encounter_.time_s();
  if (time_s >= track.duration_s) {
    if (track.first_kept > 0) track.figures.shrink_to_fit();
    return false;
  }
  if (time_s <= track.from_s) {  // only the last figure until then is kept
    track.figures.erase(track.figures.begin(), track.figures.end() - 1);
    track.first_kept = track.step_begins_s.size();
  }
  track.step_begins_s.push_back(time_s);
  step_s_ = encounter_.begin_step(now_, track.duration_s - time_s);
  return true;
}

void TrackRun::record() {
  Rehearsal::Track& track = *track_;
  track.figures.push_back(encounter_.scene().bodies());
  const std::size_t count = track.figures.size();
  track.reach.push_back(
      reach_sphere(figure_model_, {track.figures[count - 2], track.figures[count - 1], step_s_}));
  track.recorded_s = encounter_.time_s();
}

}  // namespace flinch::sim
