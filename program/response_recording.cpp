// SPDX-License-Identifier: MIT
#include "program/response_recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

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

std::shared_ptr<const reaction::ReactionData> reaction_data(const runtime::Library& library,
                                                            Ending ending) {
  if (ending == Ending::clip) return reaction::make_reaction_data(library);
  return std::make_shared<const reaction::ReactionData>(
      reaction::ReactionData{reaction::make_figure_model(library.clip_library().character), false});
}

/// What the character perceives of the first threat, which it knows to hit; nothing if it does not
/// notice it.
std::optional<runtime::Perception> perception_of(const runtime::Character& character,
                                                 const RecordedScene& scene) {
  const RecordedThreat& first = scene.threats.front();
  const motion::JointFrames frames = motion::forward_kinematics(
      character.library().clip_library().character.skeleton, character.pose());
  const runtime::Perceived seen = runtime::perceive(
      first.threat, frames.position[motion::Role::head], scene.limits, scene.seed, 0);
  if (!seen.noticed) return std::nullopt;
  return runtime::Perception{{seen.threat, first.target, first.time_to_impact_s, character.state()},
                             seen.delay_s};
}

std::vector<features::Threat> threats_of(const RecordedScene& scene) {
  std::vector<features::Threat> threats;
  for (const RecordedThreat& recorded : scene.threats) threats.push_back(recorded.threat);
  return threats;
}

/// How the character chooses its answer.
struct Choice {
  runtime::Workspace& workspace;
  lookahead::LookAheadWorkspace* look_ahead;
  lookahead::LookAhead ahead;
};

runtime::Status answer_one(runtime::Character& character, const RecordedScene& scene,
                           const Choice& choice) {
  if (scene.by_rule) {
    character.limit_perception(scene.limits, scene.seed);
    return character.brace(scene.threats.front().threat, scene.startles);
  }
  const auto perception = perception_of(character, scene);
  if (!perception) return runtime::Status::unnoticed;
  if (scene.clip) return character.answer(*perception, *scene.clip, {});
  if (choice.look_ahead != nullptr)
    return lookahead::perceive(character, *perception, choice.ahead, *choice.look_ahead).status;
  std::array<models::Candidate, runtime::Character::kMaxCandidates> best{};
  std::size_t count = 0;
  const runtime::Status status = character.rank(*perception, choice.workspace, best, count);
  if (status != runtime::Status::ok) return status;
  return character.answer(*perception, best[0].clip, std::span(best).first(count));
}

// Several threats are perceived as in a game, which knows where they fly and not what they will
// hit.
runtime::Status answer_all(runtime::Character& character, const RecordedScene& scene,
                           const Choice& choice) {
  character.limit_perception(scene.limits, scene.seed);
  const std::vector<features::Threat> threats = threats_of(scene);
  if (choice.look_ahead == nullptr) return character.perceive(threats, choice.workspace);
  return lookahead::perceive(character, threats, choice.ahead, *choice.look_ahead).status;
}

bool is_in_stance(const reaction::ReactingCharacter& character) {
  return character.pose_source() == reaction::PoseSource::character &&
         character.character().phase() == runtime::Phase::idle;
}

RecordedHit hit_of(const reaction::Reaction& reaction, float begin_s) {
  RecordedHit hit;
  hit.contact_s = begin_s + static_cast<float>(reaction.contact_s());
  const motion::PerBody<double> impulse = reaction.impulse();
  for (const motion::Body body : motion::kBodies) {
    hit.impulse_ns += static_cast<float>(impulse[body]);
    if (impulse[body] > impulse[hit.hit_body]) hit.hit_body = body;
  }
  return hit;
}

/// Plays a scene frame by frame.
class Recorder {
 public:
  Recorder(reaction::ReactingCharacter& character, const RecordedScene& scene, float rate_hz)
      : character_(character), scene_(scene), dt_s_(1 / rate_hz) {
    recording_.motion.rate_hz = rate_hz;
    const features::Threat& first = scene.threats.front().threat;
    recording_.ball.radius = first.radius;
    if (first.rod)
      recording_.ball.half_length = 0.5F * (first.rod->to_butt_m + first.rod->to_tip_m);
    recording_.impact_s = scene.threats.front().time_to_impact_s;
    recording_.clip = character.character().clip();
    recording_.hits.resize(scene.threats.size());
  }

  ResponseRecording play(bool is_noticed) {
    recording_.is_noticed = is_noticed;
    float ends_s = kMaxDuration_s;
    for (int frame = 0;; ++frame) {
      const float time_s = static_cast<float>(frame) * dt_s_;
      record_frame(time_s);
      note_clip();
      if (time_s >= ends_s) return std::move(recording_);
      check(character_.update(dt_s_));
      begin_reactions(time_s + dt_s_);
      note_hit();
      if (character_.reaction_clip()) recording_.reaction_clip = character_.reaction_clip();
      if (!recording_.knocked_over &&
          character_.reaction().phase() == reaction::ReactionPhase::knocked_over) {
        recording_.knocked_over = true;
        ends_s = time_s + kFallDuration_s;
      }
      const bool is_over = begun_ == scene_.threats.size() && time_s > begin_s_;
      if (is_over && is_in_stance(character_)) ends_s = std::min(ends_s, time_s + kIdleTail_s);
    }
  }

 private:
  // The reaction to each ball begins shortly before it may hit.
  void begin_reactions(float time_s) {
    if (begun_ == scene_.threats.size()) return;
    const RecordedThreat& next = scene_.threats[begun_];
    if (time_s < next.time_to_impact_s - kReactionLead_s) return;
    begin_s_ = time_s;
    ++begun_;
    if (scene_.ending == Ending::none) return;
    check(character_.react_to(features::ball_of(features::advanced(next.threat, time_s))));
  }

  // A delayed response begins later.
  void note_clip() {
    const runtime::Phase phase = character_.character().phase();
    if (has_clip_ || phase == runtime::Phase::idle || phase == runtime::Phase::reacting) return;
    has_clip_ = true;
    recording_.clip = character_.character().clip();
  }

  void note_hit() {
    if (begun_ == 0 || scene_.ending == Ending::none) return;
    recording_.hits[begun_ - 1] = hit_of(character_.reaction(), begin_s_);
  }

  // The ball that physics moves or, before and after, the next one to hit.
  void record_frame(float time_s) {
    recording_.motion.poses.push_back(character_.pose());
    const bool is_physical = character_.pose_source() == reaction::PoseSource::physics;
    if (is_physical) {
      record(character_.reaction().ball());
    } else if (begun_ < scene_.threats.size()) {
      record(features::ball_of(shown(scene_.threats[begun_].threat, time_s)));
    } else if (scene_.ending == Ending::none) {
      record(features::ball_of(shown(scene_.threats.back().threat, time_s)));
    } else {
      recording_.ball.positions.push_back(std::nullopt);
      if (recording_.ball.half_length > 0) record_axis(recording_.ball.axes.back());
    }
  }

  /// The threat as it is seen then: where one that waits is, not where it would have come from.
  static features::Threat shown(const features::Threat& threat, float time_s) {
    features::Threat then = features::advanced(threat, time_s);
    if (then.stroke) then.stroke->starts_in_s = 0;
    return then;
  }

  void record(const features::Ball& ball) {
    const features::RodShape& rod = ball.rod;
    const Eigen::Vector3d middle = ball.position + 0.5 * (rod.to_tip_m - rod.to_butt_m) * rod.axis;
    recording_.ball.positions.emplace_back(middle.cast<float>());
    if (recording_.ball.half_length > 0) record_axis(rod.axis.cast<float>());
  }

  void record_axis(const Eigen::Vector3f& axis) { recording_.ball.axes.push_back(axis); }

  reaction::ReactingCharacter& character_;
  const RecordedScene& scene_;
  float dt_s_;
  ResponseRecording recording_;
  bool has_clip_ = false;
  std::size_t begun_ = 0;  ///< reactions, or passages of balls that move nothing
  float begin_s_ = 0;      ///< of the last of them
};

}  // namespace

ResponseRecording record_response(const runtime::Library& library, const RecordedScene& scene,
                                  lookahead::LookAheadWorkspace* look_ahead, int candidates,
                                  float rate_hz) {
  runtime::Workspace workspace;
  if (workspace.reserve_memory(library.selection_bytes()) != database::LoadStatus::ok)
    throw Error("", "there is not enough memory");
  reaction::ReactingCharacter character(library, reaction_data(library, scene.ending));
  check(character.character().place(Eigen::Vector2f::Zero(), 0, scene.stance_time_s, scene.stance));
  character.stop();
  const Choice choice{workspace, look_ahead, {.candidates = candidates}};
  const runtime::Status status = scene.threats.size() == 1
                                     ? answer_one(character.character(), scene, choice)
                                     : answer_all(character.character(), scene, choice);
  const bool is_noticed = status != runtime::Status::unnoticed;
  if (is_noticed) check(status);
  return Recorder(character, scene, rate_hz).play(is_noticed);
}

}  // namespace flinch::program
