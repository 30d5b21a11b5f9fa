// SPDX-License-Identifier: MIT
#include "runtime/c/c_values.h"

#include <algorithm>

#include "runtime/c/c_struct.h"

namespace flinch::runtime {
namespace {

using database::LoadStatus;
using motion::Role;

std::size_t index_of(Role role) {
  return static_cast<std::size_t>(role);
}

void write(float (&to)[3], const Eigen::Vector3f& from) {
  std::copy_n(from.data(), 3, to);
}

void write(float (&to)[4], const Eigen::Quaternionf& from) {
  to[0] = from.w();
  std::copy_n(from.vec().data(), 3, to + 1);
}

// The values of the C enumerations equal those of the C++ enumerations.
static_assert(FLINCH_JOINT_COUNT == motion::kRoleCount);
static_assert(FLINCH_MOST_CANDIDATES == Character::kMaxCandidates);
static_assert(FLINCH_LEGS == static_cast<int>(motion::Target::legs));
static_assert(FLINCH_RETURNING == static_cast<int>(Phase::returning));
static_assert(FLINCH_FIST == static_cast<int>(features::ThreatShape::fist));
static_assert(FLINCH_ROD == static_cast<int>(features::ThreatShape::rod));
static_assert(FLINCH_WALKING == static_cast<int>(Phase::walking));

}  // namespace

flinch_status status_of(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return FLINCH_OK;
    case Status::misses:
      return FLINCH_MISSES;
    case Status::unnoticed:
      return FLINCH_UNNOTICED;
    case Status::not_loaded:  // a handle's library is loaded, but may have no selector
      return FLINCH_WITHOUT_SELECTOR;
    case Status::other_workspace:
      return FLINCH_OTHER_LIBRARY;
    case Status::bad_clip:
      return FLINCH_BAD_CLIP;
    case Status::bad_threat:
      return FLINCH_BAD_THREAT;
    case Status::bad_time:
      return FLINCH_BAD_TIME;
    case Status::bad_pose:
      return FLINCH_BAD_POSE;
    case Status::no_good_answer:
      return FLINCH_NO_GOOD_ANSWER;
    case Status::without_pushes:
    case Status::without_realism:
      return FLINCH_WITHOUT_PUSHES;
    case Status::bad_push:
      return FLINCH_BAD_PUSH;
    case Status::bad_placement:
      return FLINCH_BAD_PLACEMENT;
  }
  return FLINCH_BAD_HANDLE;
}

flinch_status status_of(reaction::ReactionStatus status) noexcept {
  using reaction::ReactionStatus;
  switch (status) {
    case ReactionStatus::ok:
      return FLINCH_OK;
    case ReactionStatus::bad_time:
      return FLINCH_BAD_TIME;
    case ReactionStatus::bad_pose:
      return FLINCH_BAD_POSE;
    case ReactionStatus::bad_ball:
      return FLINCH_BAD_THREAT;
    case ReactionStatus::bad_push:
      return FLINCH_BAD_PUSH;
    case ReactionStatus::not_begun:  // these two cannot happen through the C interface
    case ReactionStatus::bad_options:
    case ReactionStatus::failed:
      break;
  }
  return FLINCH_SIMULATION_FAILED;
}

flinch_status status_of(LoadStatus status) noexcept {
  switch (status) {
    case LoadStatus::ok:
      return FLINCH_OK;
    case LoadStatus::cannot_open:
      return FLINCH_CANNOT_OPEN;
    case LoadStatus::not_a_file:
      return FLINCH_NOT_A_FILE;
    case LoadStatus::too_large:
      return FLINCH_TOO_LARGE;
    case LoadStatus::not_a_library:
      return FLINCH_NOT_A_SELECTOR;
    case LoadStatus::other_version:
      return FLINCH_OTHER_VERSION;
    case LoadStatus::damaged:
      return FLINCH_DAMAGED;
    case LoadStatus::other_layout:
      return FLINCH_OTHER_LAYOUT;
    case LoadStatus::without_clips:
      return FLINCH_WITHOUT_CLIPS;
    case LoadStatus::other_library:
      return FLINCH_OTHER_CLIPS;
    case LoadStatus::other_content:
      return FLINCH_OTHER_CONTENT;
    case LoadStatus::out_of_memory:
      return FLINCH_OUT_OF_MEMORY;
  }
  return FLINCH_DAMAGED;
}

features::Threat threat_of(const flinch_threat& threat, const models::Selector& selector) {
  flinch_threat defaults{};
  defaults.radius = features::Threat{}.radius;
  defaults.mass_kg = features::Threat{}.mass_kg;
  const flinch_threat from = read_struct(threat, defaults);
  features::Threat result{.position = Eigen::Vector3f(from.position),
                          .velocity = Eigen::Vector3f(from.velocity),
                          .radius = from.radius,
                          .mass_kg = from.mass_kg,
                          .kind = -1};
  const auto index = static_cast<std::size_t>(from.kind);
  if (from.kind < 0 || index >= selector.kinds.size()) return result;
  const features::KnownKind& kind = selector.kinds[index];
  result.kind = from.kind;
  result.bounce = kind.bounce;
  result.falls = kind.falls;
  if (kind.is_driven()) result.stroke = {from.starts_in_s, from.lasts_s};
  if (kind.shape == features::ThreatShape::rod)
    result.rod = rod_of_kind(kind, Eigen::Vector3f(from.axis),
                             Eigen::Vector3f(from.angular_velocity), from.to_butt_m, from.to_tip_m);
  return result;
}

flinch_threat to_c(const features::Threat& threat) {
  flinch_threat result{};
  result.size = sizeof result;
  write(result.position, threat.position);
  write(result.velocity, threat.velocity);
  result.radius = threat.radius;
  result.mass_kg = threat.mass_kg;
  result.kind = threat.kind;
  if (threat.stroke) {
    result.starts_in_s = threat.stroke->starts_in_s;
    result.lasts_s = threat.stroke->lasts_s;
  }
  if (threat.rod) {
    write(result.axis, threat.rod->axis);
    write(result.angular_velocity, threat.rod->angular_velocity);
    result.to_butt_m = threat.rod->to_butt_m;
    result.to_tip_m = threat.rod->to_tip_m;
  }
  return result;
}

PerceptionLimits limits_of(const flinch_perception_limits& limits) {
  const flinch_perception_limits from = read_struct(limits);
  return {.reaction_delay_s = from.reaction_delay_s,
          .bearing_noise = from.bearing_noise,
          .distance_noise = from.distance_noise,
          .heading_noise = from.heading_noise,
          .speed_noise = from.speed_noise,
          .chance_to_fail = from.chance_to_fail};
}

Mask mask_of(const flinch_mask& mask) {
  const flinch_mask from = read_struct(mask);
  Mask result;
  result.weight = from.weight;
  std::copy_n(from.joint, FLINCH_JOINT_COUNT, result.joint.begin());
  return result;
}

lookahead::LookAhead look_ahead_of(const flinch_look_ahead_options& options) {
  const flinch_look_ahead_options from = read_struct(options);
  return {.candidates = from.candidates,
          .budget = {.us = double{from.budget_us}, .now_us = from.now_us, .clock = from.clock}};
}

flinch_look_ahead_status to_c(const lookahead::LookAheadStatus& status) {
  flinch_look_ahead_status result{};
  result.candidate_count = static_cast<std::int32_t>(status.count);
  result.tried = static_cast<std::int32_t>(status.tried);
  result.encounters = static_cast<std::int32_t>(status.encounters);
  result.chosen = static_cast<std::int32_t>(status.chosen);
  result.threats = static_cast<std::int32_t>(status.threats);
  result.ignored = static_cast<std::int32_t>(status.ignored);
  result.is_complete = status.is_complete ? 1 : 0;
  for (std::size_t i = 0; i < status.count; ++i) {
    const lookahead::ForeseenCandidate& from = status.candidates[i];
    result.candidate[i] = {from.candidate.clip, static_cast<std::int32_t>(from.foreseen),
                           from.work_j,         from.damage_ns,
                           from.cost_ns,        from.contact_s};
  }
  return result;
}

bool is_valid(const Mask& mask) {
  const auto is_share = [](float weight) { return weight >= 0 && weight <= 1; };
  return is_share(mask.weight) && std::ranges::all_of(mask.joint, is_share);
}

motion::Pose pose_of(const flinch_pose& pose) {
  const flinch_pose from = read_struct(pose);
  motion::Pose result;
  result.root_position = Eigen::Vector3f(from.root_position);
  for (const Role role : motion::kRoles) {
    const float(&q)[4] = from.rotation[index_of(role)];
    result.rotation[role] = Eigen::Quaternionf(q[0], q[1], q[2], q[3]);
  }
  return result;
}

flinch_perception_limits to_c(const PerceptionLimits& limits) {
  return {.size = 0,
          .reaction_delay_s = limits.reaction_delay_s,
          .bearing_noise = limits.bearing_noise,
          .distance_noise = limits.distance_noise,
          .heading_noise = limits.heading_noise,
          .speed_noise = limits.speed_noise,
          .chance_to_fail = limits.chance_to_fail};
}

flinch_pose to_c(const motion::Pose& pose) {
  flinch_pose result{};
  write(result.root_position, pose.root_position);
  for (const Role role : motion::kRoles) {
    write(result.rotation[index_of(role)], pose.rotation[role]);
  }
  return result;
}

flinch_joint_frames to_c(const motion::JointFrames& frames) {
  flinch_joint_frames result{};
  for (const Role role : motion::kRoles) {
    write(result.position[index_of(role)], frames.position[role]);
    write(result.orientation[index_of(role)], frames.orientation[role]);
  }
  return result;
}

flinch_skeleton to_c(const motion::Skeleton& skeleton) {
  flinch_skeleton result{};
  for (const Role role : motion::kRoles) {
    write(result.offset[index_of(role)], skeleton.offset[role]);
    write(result.tip[index_of(role)], skeleton.tip[role]);
  }
  return result;
}

flinch_outline to_c(motion::Body body, const motion::BodyProperties& properties) {
  flinch_outline result{};
  const motion::Shape& shape = properties.shape;
  result.joint = static_cast<std::int32_t>(index_of(role_of(body)));
  result.is_box = shape.kind == motion::Shape::Kind::box ? 1 : 0;
  write(result.centre, shape.centre);
  write(result.orientation, shape.orientation);
  result.radius = shape.radius;
  result.half_length = shape.half_length;
  write(result.half_extents, shape.half_extents);
  result.mass_kg = properties.mass_kg;
  write(result.centre_of_mass, properties.centre_of_mass);
  return result;
}

flinch_reaction to_c(const reaction::ReactingCharacter& character) {
  const reaction::Reaction& reaction = character.reaction();
  flinch_reaction result{};
  result.phase = static_cast<std::int32_t>(reaction.phase());
  result.moved_by = static_cast<std::int32_t>(character.pose_source());
  result.clip = character.reaction_clip().value_or(-1);
  result.contact_s = static_cast<float>(reaction.contact_s());
  const features::Ball ball = reaction.ball();
  const features::RodShape& rod = ball.rod;
  const Eigen::Vector3d middle = ball.position + 0.5 * (rod.to_tip_m - rod.to_butt_m) * rod.axis;
  write(result.ball_position, middle.cast<float>());
  if (ball.is_rod()) write(result.ball_axis, rod.axis.cast<float>());
  write(result.ball_velocity, ball.velocity.cast<float>());
  const motion::PerBody<double> impulse = reaction.impulse();
  std::ranges::transform(impulse, result.impulse_ns,
                         [](double part_ns) { return static_cast<float>(part_ns); });
  write(result.ball_momentum, reaction.ball_momentum().cast<float>());
  return result;
}

flinch_kind to_c(const features::KnownKind& kind) {
  const auto write_range = [](float(&to)[2], const features::ValueRange& range) {
    to[0] = static_cast<float>(range.min);
    to[1] = static_cast<float>(range.max);
  };
  flinch_kind result{};
  result.shape = static_cast<std::int32_t>(kind.shape);
  result.name = kind.name.c_str();
  write_range(result.radius, kind.radius_m);
  write_range(result.mass_kg, kind.mass_kg);
  write_range(result.speed_mps, kind.speed_mps);
  write_range(result.elevation, kind.elevation);
  write_range(result.time_to_impact_s, kind.time_to_impact_s);
  write_range(result.reach_m, kind.reach_m);
  result.restitution = static_cast<float>(kind.bounce.restitution);
  result.friction = static_cast<float>(kind.bounce.friction);
  result.is_straight = kind.falls ? 0 : 1;
  write_range(result.length_m, kind.rod.length_m);
  return result;
}

flinch_clip to_c(const motion::Clip& clip) {
  flinch_clip result{};
  result.name = clip.name.c_str();
  result.kind = clip.kind.c_str();
  result.duration_s = clip.motion.duration_s();
  if (const auto& annotation = clip.annotation) {
    result.is_annotated = 1;
    result.target = static_cast<std::int32_t>(annotation->target);
    result.direction = annotation->direction;
    result.degree = static_cast<std::int32_t>(annotation->degree);
    result.onset_s = annotation->onset_s;
    result.peak_s = annotation->peak_s;
    result.end_s = annotation->end_s;
  }
  return result;
}

}  // namespace flinch::runtime
