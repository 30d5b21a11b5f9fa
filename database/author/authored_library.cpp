// SPDX-License-Identifier: MIT
#include "database/author/authored_library.h"

#include <cmath>
#include <string>

#include "database/author/character_toml.h"
#include "database/author/evasion.h"
#include "database/author/protective_motion.h"
#include "database/author/stance.h"
#include "database/author/static_balance.h"
#include "database/files/pose_packer.h"
#include "database/files/provenance.h"
#include "motion/error.h"
#include "motion/mirror.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using motion::Clip;
using motion::Degree;
using motion::degrees;
using motion::JointFrames;
using motion::Pose;
using motion::radians;
using motion::Target;

// Front, back and the left side; mirroring gives the right side.
constexpr std::array<float, 5> kDirections{0, 45, 90, 135, 180};
constexpr std::array<std::string_view, 5> kDirectionNames{"front", "front_left", "left",
                                                          "back_left", "back"};

// Clips are played so that their peak coincides with the impact, so all need the pace of an urgent
// threat: equation 4.1 with this speed gives 0.33 to 0.46 s.
constexpr float kUrgency = 0.9F;
constexpr float kDistance = 5;  // m, initial distance of the authored threats

struct AuthoringContext {
  motion::Figure figure;
  Pose start;
  JointFrames frames;
  motion::Motion idle;
  bool with_startle;
  float rate_hz;
};

// Returns a threat from a direction, slightly from above, aimed at the centre of a target.
AimedThreat threat_from(const AuthoringContext& context, Target target, float azimuth) {
  constexpr float kElevation = radians(12);
  constexpr float kSpeed_mps = 25;
  AimedThreat aimed;
  aimed.target_point = motion::target_centre(context.figure.bodies, context.frames, target);
  const Eigen::Vector3f from(std::cos(kElevation) * std::cos(azimuth),
                             std::cos(kElevation) * std::sin(azimuth), std::sin(kElevation));
  aimed.threat.position = aimed.target_point + kDistance * from;
  aimed.threat.velocity = -kSpeed_mps * from;
  return aimed;
}

RuleControls controls_of(Degree degree) {
  if (degree == Degree::mild) return {0.35F, 0.3F, 0.35F, {0.55F, 0.55F}, {0.5F, 0.5F}};
  return {0.75F, 0.7F, 0.9F, {0.85F, 0.85F}, {0.8F, 0.8F}};
}

Clip make_clip(const AuthoringContext& context, std::string_view kind, Target target,
               std::size_t direction, Degree degree, const Pose& sustained, float pace,
               const std::optional<Pose>& startled = std::nullopt) {
  const float azimuth = radians(kDirections[direction]);
  ProtectiveTiming timing;
  timing.protect_s = pace * time_to_contact_s(kUrgency, std::cos(azimuth));
  Clip clip;
  clip.name = std::string(kind) + "_" + std::string(motion::name_of(target)) + "_" +
              std::string(kDirectionNames[direction]) + "_" + std::string(motion::name_of(degree));
  clip.kind = kind;
  clip.source = "authored by rule";
  clip.motion = protective_motion(context.figure, context.start, startled, sustained, timing,
                                  context.rate_hz);
  motion::Annotation annotation;
  annotation.target = target;
  annotation.direction = azimuth;
  annotation.degree = degree;
  annotation.onset_s = 0;
  annotation.peak_s = timing.protect_s + timing.settle_s;
  annotation.end_s = clip.motion.duration_s();
  clip.annotation = annotation;
  return clip;
}

// For a threat from the side, a chest that turns away has the threat behind it, and the hands would
// cover the head. That is right for the head only; for trunk and pelvis the arms reach across, and
// the chest keeps facing the threat a little.
Clip block_clip(const AuthoringContext& context, Target target, std::size_t direction,
                Degree degree) {
  constexpr float kBeforeTheShoulders = 75;  // degrees
  const bool across = target != Target::head && kDirections[direction] == 90;
  const float azimuth = across ? kBeforeTheShoulders : kDirections[direction];
  RuleControls controls = controls_of(degree);
  if (across) controls.turn = 0;
  const ProtectivePoses poses = protective_poses(context.figure, context.idle, 0,
                                                 threat_from(context, target, radians(azimuth)),
                                                 controls, context.with_startle);
  return make_clip(context, "block", target, direction, degree, poses.sustained.pose, 1,
                   poses.startled);
}

Clip evasive_clip(const AuthoringContext& context, std::string_view kind, Target target,
                  std::size_t direction, Degree degree, const Evasion& evasion, float pace) {
  return make_clip(context, kind, target, direction, degree,
                   evasive_pose(context.figure, context.start, evasion), pace);
}

Clip idle_clip(const AuthoringContext& context) {
  Clip clip;
  clip.name = "idle";
  clip.purpose = motion::Purpose::idle;
  clip.kind = "idle";
  clip.source = "authored by rule";
  clip.motion = context.idle;
  return clip;
}

Clip guard_clip(const AuthoringContext& context) {
  Clip clip;
  clip.name = "guard";
  clip.purpose = motion::Purpose::stance;
  clip.kind = "guard";
  clip.source = "authored by rule";
  clip.motion = guard_motion(context.figure, context.rate_hz);
  return clip;
}

// Returns the clips against threats from one direction. Hands do not reach behind the back, so a
// pelvis is blocked only from the front half. Mild ducks, dodges and leg lifts are left out where
// the exaggerated ones, or those of a neighbouring target, do the same.
std::vector<Clip> clips_from(const AuthoringContext& context, std::size_t direction) {
  const float azimuth = radians(kDirections[direction]);
  const bool from_behind = kDirections[direction] > 90;
  constexpr Degree kMild = Degree::mild;
  constexpr Degree kExaggerated = Degree::exaggerated;
  std::vector<Clip> clips;
  for (Target target : {Target::head, Target::trunk, Target::pelvis}) {
    if (target == Target::pelvis && from_behind) continue;
    clips.push_back(block_clip(context, target, direction, kMild));
    clips.push_back(block_clip(context, target, direction, kExaggerated));
  }
  const auto evade = [&](std::string_view kind, Target target, Degree degree,
                         const Evasion& evasion, float pace) {
    clips.push_back(evasive_clip(context, kind, target, direction, degree, evasion, pace));
  };
  if (!from_behind) evade("duck", Target::head, kMild, duck(azimuth, 0.6F), 1);
  evade("duck", Target::head, kExaggerated, duck(azimuth, 0.95F), 1.1F);
  evade("dodge", Target::head, kExaggerated, dodge(azimuth, -1, 1), 1);
  evade("sidestep", Target::trunk, kExaggerated, sidestep(azimuth, -1, 1), 1.2F);
  evade("sidestep", Target::pelvis, kExaggerated, sidestep(azimuth, 1, 1), 1.2F);
  evade("sidestep", Target::legs, kMild, sidestep(azimuth, -1, 0.7F), 1.1F);
  if (!from_behind) {
    evade("lift", Target::legs, kMild, lift_leg(azimuth, 0.5F), 1);
    evade("lift", Target::legs, kExaggerated, lift_leg(azimuth, 1), 1.1F);
  }
  evade("sidestep", Target::legs, kExaggerated, sidestep(azimuth, -1, 0.9F), 1.2F);
  return clips;
}

}  // namespace

ClipLibrary authored_library(const motion::Physique& character, bool with_startle, float rate_hz) {
  ClipLibrary library = authored_library_off_grid(character, with_startle, rate_hz);
  snap(library);
  return library;
}

ClipLibrary authored_library_off_grid(const motion::Physique& character, bool with_startle,
                                      float rate_hz) {
  AuthoringContext context{motion::make_figure(character), {}, {}, {}, with_startle, rate_hz};
  context.start = standing_pose(context.figure);
  context.idle = idle_motion(context.figure, rate_hz);
  context.frames = motion::forward_kinematics(character.skeleton, context.start);
  ClipLibrary library;
  library.name = "authored";
  library.character = character;
  library.rate_hz = rate_hz;
  library.clips.push_back(idle_clip(context));
  for (std::size_t direction = 0; direction < kDirections.size(); ++direction) {
    for (Clip& clip : clips_from(context, direction)) {
      Clip mirror = motion::mirrored(clip);
      library.clips.push_back(std::move(clip));
      library.clips.push_back(std::move(mirror));
    }
  }
  library.clips.push_back(guard_clip(context));
  return library;
}

std::string authored_provenance(const std::optional<std::string>& character, bool with_startle) {
  Provenance made{.command = "author"};
  const bool is_file = character && *character != kWaistUpMan;
  if (!is_file) add_option("character", character, made);
  add_option("startle", with_startle, false, made);
  if (is_file) made.inputs.push_back(input_of("character", *character));
  return provenance_text(made);
}

}  // namespace flinch::database
