// SPDX-License-Identifier: MIT
#include "program/response_recording.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/error.h"
#include "reaction/reacting_character.h"
#include "runtime/workspace.h"

namespace flinch::program {
namespace {

// The reaction takes over this long before the impact, in case the ball comes early.
constexpr float kReactionLead_s = 0.15F;  // s
constexpr float kIdleTail_s = 0.5F;       // s of idling at the end
constexpr float kFallDuration_s = 1.5F;   // s, length of a fall that is recorded
constexpr float kMaxDuration_s = 15;      // s

void check(runtime::Status status) {
  if (status != runtime::Status::ok) throw Error("", runtime::message_of(status));
}

void check(reaction::ReactionStatus status) {
  if (status != reaction::ReactionStatus::ok) throw Error("", reaction::message_of(status));
}

// Records what is visible at one moment.
void record_frame(const reaction::ReactingCharacter& character, const features::Threat& threat,
                  float time_s, ResponseRecording& recording) {
  recording.motion.poses.push_back(character.pose());
  std::optional<Eigen::Vector3f> ball;
  if (character.pose_source() == reaction::PoseSource::physics) {
    ball = character.reaction().ball().position.cast<float>();
  } else if (character.reaction().phase() == reaction::ReactionPhase::none) {
    ball = features::position_at(threat, time_s);
  }
  recording.ball.positions.push_back(ball);
}

bool idles(const reaction::ReactingCharacter& character) {
  return character.pose_source() == reaction::PoseSource::character &&
         character.character().phase() == runtime::Phase::idle;
}

}  // namespace

ResponseRecording record_response(const runtime::Library& library, const features::Threat& threat,
                                  motion::Target target, float time_to_impact_s,
                                  lookahead::LookAheadWorkspace* look_ahead, int candidates,
                                  float rate_hz) {
  runtime::Workspace workspace;
  if (workspace.reserve_memory(library.selection_bytes()) != database::LoadStatus::ok)
    throw Error("", "there is not enough memory");
  reaction::ReactingCharacter character(library, reaction::make_reaction_data(library));
  if (look_ahead != nullptr) {
    const runtime::Perception perception{{threat, target, time_to_impact_s, {}}, 0};
    check(lookahead::perceive(character.character(), perception, {.candidates = candidates},
                              *look_ahead)
              .status);
  } else {
    check(character.character().perceive(threat, target, time_to_impact_s, workspace));
  }

  ResponseRecording recording;
  recording.motion.rate_hz = rate_hz;
  recording.ball.radius = threat.radius;
  recording.clip = character.character().clip();
  recording.impact_s = time_to_impact_s;
  const float dt_s = 1 / rate_hz;
  float ends_s = kMaxDuration_s;
  float reaction_begin_s = std::numeric_limits<float>::infinity();
  for (int frame = 0;; ++frame) {
    const float time_s = static_cast<float>(frame) * dt_s;
    record_frame(character, threat, time_s, recording);
    if (time_s >= ends_s) break;
    check(character.update(dt_s));
    if (std::isinf(reaction_begin_s) && time_s + dt_s >= time_to_impact_s - kReactionLead_s) {
      reaction_begin_s = time_s + dt_s;
      check(character.react_to(features::ball_of(features::advanced(threat, reaction_begin_s))));
    }
    if (character.reaction_clip()) recording.reaction_clip = character.reaction_clip();
    if (character.reaction().phase() == reaction::ReactionPhase::knocked_over &&
        !recording.knocked_over) {
      recording.knocked_over = true;
      ends_s = time_s + kFallDuration_s;
    }
    if (time_s > reaction_begin_s && idles(character))
      ends_s = std::min(ends_s, time_s + kIdleTail_s);
  }
  recording.contact_s = reaction_begin_s + static_cast<float>(character.reaction().contact_s());
  const motion::PerBody<double> impulse = character.reaction().impulse();
  for (const motion::Body body : motion::kBodies) {
    recording.impulse_ns += static_cast<float>(impulse[body]);
    if (impulse[body] > impulse[recording.hit_body]) recording.hit_body = body;
  }
  return recording;
}

}  // namespace flinch::program
