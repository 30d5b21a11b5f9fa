// SPDX-License-Identifier: MIT
#include "program/film.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/error.h"
#include "reaction/reacting_character.h"
#include "runtime/workspace.h"

namespace flinch::program {
namespace {

// The reaction takes over this long before the impact, so that a ball that comes early is met.
constexpr float kAhead = 0.15F;  // s
constexpr float kAfter = 0.5F;   // s of idling at the end
constexpr float kFall = 1.5F;    // s that a fall is shown for
constexpr float kLongest = 15;   // s

void check(runtime::Status status) {
  if (status != runtime::Status::ok) throw Error("", runtime::message_of(status));
}

void check(reaction::ReactionStatus status) {
  if (status != reaction::ReactionStatus::ok) throw Error("", reaction::message_of(status));
}

// What is seen at one moment.
void shoot(const reaction::ReactingCharacter& character, const features::Threat& threat,
           float time_s, Film& film) {
  film.motion.poses.push_back(character.pose());
  std::optional<Eigen::Vector3f> ball;
  if (character.mover() == reaction::Mover::physics) {
    ball = character.reaction().ball().position.cast<float>();
  } else if (character.reaction().phase() == reaction::ReactionPhase::none) {
    ball = features::position_at(threat, time_s);
  }
  film.ball.positions.push_back(ball);
}

bool idles(const reaction::ReactingCharacter& character) {
  return character.mover() == reaction::Mover::character &&
         character.character().phase() == runtime::Phase::idle;
}

}  // namespace

Film film_response(const runtime::Library& library, const features::Threat& threat,
                   motion::Target target, float time_to_impact_s, float rate_hz) {
  runtime::Workspace workspace;
  if (workspace.make_room(library.selection_bytes()) != database::LoadStatus::ok)
    throw Error("", "there is not enough memory");
  reaction::ReactingCharacter character(library, reaction::make_reaction_kit(library));
  check(character.character().perceive(threat, target, time_to_impact_s, workspace));

  Film film;
  film.motion.rate_hz = rate_hz;
  film.ball.radius = threat.radius;
  film.clip = character.character().clip();
  film.impact_s = time_to_impact_s;
  const float dt_s = 1 / rate_hz;
  float ends_s = kLongest;
  float met_s = std::numeric_limits<float>::infinity();
  for (int frame = 0;; ++frame) {
    const float time_s = static_cast<float>(frame) * dt_s;
    shoot(character, threat, time_s, film);
    if (time_s >= ends_s) break;
    check(character.update(dt_s));
    if (std::isinf(met_s) && time_s + dt_s >= time_to_impact_s - kAhead) {
      met_s = time_s + dt_s;
      check(character.meet(reaction::ball_of(features::advanced(threat, met_s))));
    }
    if (character.reaction_clip()) film.reaction_clip = character.reaction_clip();
    if (character.reaction().phase() == reaction::ReactionPhase::knocked_over &&
        !film.knocked_over) {
      film.knocked_over = true;
      ends_s = time_s + kFall;
    }
    if (time_s > met_s && idles(character)) ends_s = std::min(ends_s, time_s + kAfter);
  }
  film.contact_s = met_s + static_cast<float>(character.reaction().contact_s());
  for (const double part : character.reaction().impulse()) {
    film.impulse_ns += static_cast<float>(part);
  }
  return film;
}

}  // namespace flinch::program
