// SPDX-License-Identifier: MIT
#include "train/film.h"

#include <algorithm>
#include <limits>

#include "motion/error.h"
#include "runtime/character.h"
#include "runtime/workspace.h"

namespace flinch::train {
namespace {

// The reaction takes over this long before the impact, so that a ball that comes early is met.
constexpr float kAhead = 0.15F;  // s
constexpr float kAfter = 0.5F;   // s of idling at the end
constexpr float kFall = 1.5F;    // s that a fall is shown for
constexpr float kLongest = 15;   // s

struct Scene {
  runtime::Character character;
  sim::Reaction reaction;
  features::Threat threat;
};

void check(runtime::Status status) {
  if (status != runtime::Status::ok) throw Error("", runtime::message_of(status));
}

sim::Ball ball_at(const features::Threat& threat, float time_s) {
  sim::Ball ball;
  ball.position = features::position_at(threat, time_s).cast<double>();
  ball.velocity = features::velocity_at(threat, time_s).cast<double>();
  ball.radius = double{threat.radius};
  ball.mass_kg = double{threat.mass_kg};
  return ball;
}

bool has_the_body(sim::ReactionPhase phase) {
  return phase != sim::ReactionPhase::none && phase != sim::ReactionPhase::over;
}

// What is seen at one moment.
void shoot(const Scene& scene, float time_s, Film& film) {
  const sim::ReactionPhase phase = scene.reaction.phase();
  film.motion.poses.push_back(has_the_body(phase) ? scene.reaction.pose() : scene.character.pose());
  if (phase == sim::ReactionPhase::none) {
    film.ball.positions.emplace_back(features::position_at(scene.threat, time_s));
  } else if (has_the_body(phase)) {
    film.ball.positions.emplace_back(scene.reaction.ball().position.cast<float>());
  } else {
    film.ball.positions.emplace_back(std::nullopt);
  }
}

}  // namespace

Film film_response(const runtime::Library& library, const features::Threat& threat,
                   motion::Target target, float time_to_impact_s, float rate_hz) {
  runtime::Workspace workspace;
  if (workspace.make_room(library.selection_bytes()) != database::LoadStatus::ok)
    throw Error("", "there is not enough memory");
  Scene scene{runtime::Character(library),
              sim::Reaction(sim::make_figure_plan(library.clips().character)), threat};
  check(scene.character.perceive(threat, target, time_to_impact_s, workspace));

  Film film;
  film.motion.rate_hz = rate_hz;
  film.ball.radius = threat.radius;
  film.clip = scene.character.clip();
  film.impact_s = time_to_impact_s;
  const float dt_s = 1 / rate_hz;
  float ends_s = kLongest;
  float begun_s = 0;  // of the reaction
  for (int frame = 0;; ++frame) {
    const float time_s = static_cast<float>(frame) * dt_s;
    shoot(scene, time_s, film);
    if (time_s >= ends_s) break;
    const motion::Pose before = scene.character.pose();
    check(scene.character.update(dt_s));
    const motion::Pose wanted = scene.character.pose();
    if (has_the_body(scene.reaction.phase())) {
      scene.reaction.advance(double{dt_s}, wanted, wanted);
    } else if (scene.reaction.phase() == sim::ReactionPhase::none &&
               time_s + dt_s >= time_to_impact_s - kAhead) {
      const sim::Ball ball = ball_at(threat, time_s + dt_s);
      scene.reaction.begin(before, wanted, double{dt_s}, &ball);
      begun_s = time_s + dt_s;
    }
    const sim::ReactionPhase phase = scene.reaction.phase();
    if (phase == sim::ReactionPhase::knocked_over && !film.knocked_over) {
      film.knocked_over = true;
      ends_s = time_s + kFall;
    }
    const bool is_over =
        phase == sim::ReactionPhase::over && scene.character.phase() == runtime::Phase::idle;
    if (is_over) ends_s = std::min(ends_s, time_s + kAfter);
  }
  film.contact_s = begun_s + static_cast<float>(scene.reaction.contact_s());
  for (const double part : scene.reaction.impulse()) film.impulse_ns += static_cast<float>(part);
  return film;
}

}  // namespace flinch::train
