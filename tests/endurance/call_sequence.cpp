// SPDX-License-Identifier: MIT
#include "tests/endurance/call_sequence.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "database/library/content_hash.h"
#include "motion/joint_limits.h"
#include "runtime/c/c_values.h"
#include "tests/scenes/not_finite.h"

namespace flinch::tests {
namespace {

constexpr float kMaxUnitError = 1e-5F;
constexpr float kMaxExcess = 0.05F;  // radians
constexpr float kTurn = 2 * std::numbers::pi_v<float>;

template <class Struct>
Struct sized() {
  Struct value{};
  value.size = sizeof(Struct);
  return value;
}

// What flinch.h allows; false for what is not a number.
bool is_extent(float x) {
  return std::abs(x) <= 1e6F;
}
bool is_place(float x) {
  return std::abs(x) <= 1e5F;
}
bool is_amount(float x) {
  return x >= 0 && x <= 1e6F;
}
bool is_share(float x) {
  return x >= 0 && x <= 1;
}
bool is_time_to_impact(float time_s) {
  return time_s > 0 && time_s <= 100;
}
bool is_time_step(float time_s) {
  return time_s > 0 && time_s <= 1e6F;
}
bool is_threat(const flinch_threat& threat) {
  return std::ranges::all_of(threat.position, is_extent) &&
         std::ranges::all_of(threat.velocity, is_extent) && is_amount(threat.radius) &&
         is_amount(threat.mass_kg);
}

/// How far the length of a rotation is from 1; huge for what is not a number.
float unit_error(const float (&rotation)[4]) {
  double sum = 0;
  for (const float x : rotation) sum += static_cast<double>(x) * static_cast<double>(x);
  const double error = std::abs(std::sqrt(sum) - 1);
  return error < 1e30 ? static_cast<float>(error) : std::numeric_limits<float>::max();
}

float unit_error(const flinch_pose& pose) {
  float max = 0;
  for (const auto& rotation : pose.rotation) max = std::max(max, unit_error(rotation));
  return max;
}

template <class Value>
bool has_same_bits(const Value& one, const Value& other) {
  return std::memcmp(&one, &other, sizeof one) == 0;
}

template <class Value>
std::span<const std::byte> bytes_of(const Value& value) {
  return std::as_bytes(std::span(&value, 1));
}

/// By how much the pose exceeds a limit, radians.
float excess_of(const motion::Pose& pose, const motion::JointLimits& limits) {
  Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();
  for (motion::Role role = limits.to; role != limits.from; role = *motion::parent_of(role)) {
    rotation = pose.rotation[role] * rotation;
  }
  return limit_excess(limits, rotation);
}

}  // namespace

CallSequence::CallSequence(flinch_library* library, Draw draw)
    : library_(library), draw_(std::move(draw)) {
  info_.size = sizeof info_;
  flinch_library_describe(library, &info_);
  flinch_workspace_create(library, &workspace_);
  for (Actor& actor : actors_) flinch_character_create(library, &actor.character);
}

CallSequence::~CallSequence() {
  for (const Actor& actor : actors_) flinch_character_free(actor.character);
  flinch_workspace_free(workspace_);
}

bool CallSequence::call() {
  using Call = Outcome (CallSequence::*)(Actor&);
  struct Kind {
    std::string_view name;
    Call call;
    std::uint32_t weight;  ///< of 256
  };
  constexpr std::array kKinds{Kind{"update", &CallSequence::update, 190},
                              Kind{"perceive", &CallSequence::perceive, 14},
                              Kind{"notice, rank, plan and answer", &CallSequence::step_by_step, 4},
                              Kind{"respond", &CallSequence::respond, 2},
                              Kind{"place", &CallSequence::place, 8},
                              Kind{"set_pose", &CallSequence::set_pose, 8},
                              Kind{"settle", &CallSequence::settle, 2},
                              Kind{"pose_over", &CallSequence::pose_over, 8},
                              Kind{"joint_frames", &CallSequence::joint_frames, 8},
                              Kind{"limit_perception", &CallSequence::limit_perception, 4},
                              Kind{"clip_pose", &CallSequence::clip_pose, 3},
                              Kind{"copy", &CallSequence::copy, 3},
                              Kind{"a new character", &CallSequence::make_anew, 2}};
  Actor& actor = actors_[below(actors_.size())];
  is_odd_ = below(4) == 0;
  std::uint32_t chosen = below(256);
  std::size_t kind = 0;
  while (chosen >= kKinds[kind].weight) chosen -= kKinds[kind++].weight;
  call_name_ = kKinds[kind].name;

  const Seen before = seen_of(actor);
  const Outcome outcome = (this->*kKinds[kind].call)(actor);
  const Seen now = seen_of(actor);
  ++statuses_[outcome.status];
  if (outcome.expected == Expected::answer && outcome.status < 0)
    fail("was refused, with status", static_cast<float>(outcome.status));
  if (outcome.expected == Expected::refusal && outcome.status >= 0)
    fail("was not refused, but gave status", static_cast<float>(outcome.status));
  if (outcome.status < 0 && !has_same_bits(before, now))
    fail("has changed the character although it was refused, with status",
         static_cast<float>(outcome.status));
  check(actor, now);
  if (fault_.empty()) return true;
  fault_ += "; the character is at " + std::to_string(now.state.position[0]) + ", " +
            std::to_string(now.state.position[1]) + " in phase " +
            flinch_phase_name(now.state.phase);
  return false;
}

float CallSequence::number(float min, float max) {
  constexpr std::array<float, 16> kOdd{0,    -0.0F, 1e-45F,    1e-20F,    1e-5F, -1,
                                       100,  101,   1e5F,      1.1e6F,    1e30F, -3e38F,
                                       1e6F, kNan,  kInfinity, -kInfinity};
  const std::uint32_t kind = is_odd_ ? below(8) : 7;
  if (kind == 0) return kOdd[below(kOdd.size())];
  if (kind == 1) return std::bit_cast<float>(draw_());
  if (kind == 2) return (share() - 0.5F) * 2e6F;
  return min + share() * (max - min);
}

float CallSequence::share() {
  constexpr std::uint32_t kSteps = 1U << 24U;  // as a float can hold
  return static_cast<float>(below(kSteps)) / static_cast<float>(kSteps);
}

// A ball that flies at a body somewhere between shin and head, from any side.
flinch_threat CallSequence::threat_at(const flinch_character_state& state) {
  const float azimuth = number(0, kTurn);
  const float time_s = number(0.05F, 1.2F);
  const float speed_mps = number(0, 30);
  const float goal[3] = {state.position[0], state.position[1], number(0.2F, 1.8F)};
  const float velocity[3] = {-speed_mps * std::cos(azimuth), -speed_mps * std::sin(azimuth),
                             number(-4, 8)};
  auto threat = sized<flinch_threat>();
  for (std::size_t i = 0; i < 3; ++i) {
    threat.velocity[i] = number(velocity[i], velocity[i]);
    threat.position[i] =
        number(goal[i] - time_s * velocity[i], goal[i] - time_s * velocity[i] + 0.1F);
  }
  threat.radius = number(0.02F, 0.2F);
  threat.mass_kg = number(0.05F, 1);
  return threat;
}

CallSequence::Outcome CallSequence::perceive(Actor& actor) {
  const flinch_threat threat = threat_at(seen_of(actor).state);
  if (below(4) > 0) {
    // A game may have moved a body so fast that where it will be is beyond all ranges.
    const Expected usable = actor.is_bent ? Expected::either : Expected::answer;
    return {flinch_character_perceive(actor.character, &threat, workspace_),
            is_threat(threat) ? usable : Expected::refusal};
  }
  const auto target = static_cast<std::int32_t>(below(is_odd_ ? 6 : 4)) - (is_odd_ ? 1 : 0);
  const float time_s = number(0.001F, 1.5F);
  const bool is_good =
      is_threat(threat) && is_time_to_impact(time_s) && target >= 0 && target <= FLINCH_LEGS;
  return {flinch_character_perceive_known(actor.character, &threat, target, time_s, workspace_),
          is_good ? Expected::answer : Expected::refusal};
}

// Puts any number in the place of one.
void CallSequence::forge(flinch_perception& perception) {
  const std::array numbers{&perception.time_to_impact_s, &perception.delay_s,
                           &perception.position[0],      &perception.position[1],
                           &perception.facing,           &perception.stance_time_s,
                           &perception.threat.radius,    &perception.threat.velocity[2]};
  float& forged = *numbers[below(numbers.size())];
  forged = number(forged, forged);
  if (below(8) == 0) perception.target = static_cast<std::int32_t>(draw_());
  if (below(8) == 0) perception.stance = static_cast<std::int32_t>(draw_());
}

// What is noticed, or forged, is answered with any clip of those that are ranked, or any at all.
CallSequence::Outcome CallSequence::step_by_step(Actor& actor) {
  const flinch_threat threat = threat_at(seen_of(actor).state);
  auto perception = sized<flinch_perception>();
  const flinch_status noticed = flinch_character_notice(actor.character, &threat, &perception);
  if (noticed != FLINCH_OK)
    return {noticed, is_threat(threat) ? Expected::either : Expected::refusal};
  if (is_odd_) forge(perception);
  std::array<flinch_candidate, FLINCH_MOST_CANDIDATES> best{};
  std::int32_t count = 0;
  const flinch_status ranked = flinch_character_rank(actor.character, &perception, workspace_,
                                                     best.data(), FLINCH_MOST_CANDIDATES, &count);
  if (ranked < 0) return {ranked, is_odd_ || actor.is_bent ? Expected::either : Expected::answer};
  std::int32_t clip = best[below(static_cast<std::uint32_t>(count))].clip;
  if (is_odd_ && below(4) == 0) clip = static_cast<std::int32_t>(draw_());
  auto planned = sized<flinch_pose>();
  const float time_s = number(0, 2);
  if (flinch_character_planned_pose(actor.character, &perception, clip, time_s, &planned) ==
      FLINCH_OK)
    check_numbers(planned);
  return {flinch_character_answer(actor.character, &perception, clip, best.data(), count),
          is_odd_ || actor.is_bent ? Expected::either : Expected::answer};
}

CallSequence::Outcome CallSequence::respond(Actor& actor) {
  const auto clips = static_cast<std::uint32_t>(info_.clip_count);
  const auto clip = static_cast<std::int32_t>(below(clips + 2)) - 1;
  const float time_s = number(0.01F, 1.5F);
  auto what = sized<flinch_clip>();
  const bool is_clip = flinch_library_clip(library_, clip, &what) == FLINCH_OK &&
                       (what.is_annotated != 0 || clip == info_.idle_clip);
  return {flinch_character_respond(actor.character, clip, time_s),
          is_clip && is_time_to_impact(time_s) ? Expected::answer : Expected::refusal};
}

CallSequence::Outcome CallSequence::place(Actor& actor) {
  const float x = number(-10, 10);
  const float y = number(-10, 10);
  const float facing = number(-kTurn, kTurn);
  const float idle_time_s = number(0, 100);
  const bool is_good = is_place(x) && is_place(y) && is_extent(facing) && is_extent(idle_time_s);
  if (is_good) actor.is_bent = false;
  return {flinch_character_place(actor.character, x, y, facing, idle_time_s),
          is_good ? Expected::answer : Expected::refusal};
}

// The game moves the character a little, or bends it as no body bends.
CallSequence::Outcome CallSequence::set_pose(Actor& actor) {
  const flinch_pose before = seen_of(actor).pose;
  flinch_pose now = before;
  for (float& x : now.root_position) x = number(x - 0.01F, x + 0.01F);
  const float dt_s = number(1.0F / 240, 1.0F / 30);
  if (is_odd_) {
    for (float& x : now.rotation[below(FLINCH_JOINT_COUNT)]) x = number(x, x);
  }
  // A rotation whose length is off by about 1 % may be refused or not.
  const float error = unit_error(now);
  const bool is_good = std::ranges::all_of(before.root_position, is_place) &&
                       std::ranges::all_of(now.root_position, is_place) && error < 1.2e-2F &&
                       is_time_step(dt_s) && dt_s >= 1e-4F;
  const flinch_status status = flinch_character_set_pose(actor.character, &before, &now, dt_s);
  if (status == FLINCH_OK) actor.is_bent = true;
  if (!is_good) return {status, Expected::refusal};
  return {status, error > 0.8e-2F ? Expected::either : Expected::answer};
}

CallSequence::Outcome CallSequence::settle(Actor& actor) {
  return {flinch_character_settle(actor.character), Expected::answer};
}

CallSequence::Outcome CallSequence::pose_over(Actor& actor) {
  flinch_pose game = seen_of(actors_[below(actors_.size())]).pose;
  auto mask = sized<flinch_mask>();
  mask.weight = number(0, 1);
  for (float& weight : mask.joint) weight = number(0, 1);
  const bool is_good = std::ranges::all_of(game.root_position, is_place) && is_share(mask.weight) &&
                       std::ranges::all_of(mask.joint, is_share);
  const flinch_status status = flinch_character_pose_over(actor.character, &game, &mask, &game);
  check_numbers(game);
  return {status, is_good ? Expected::answer : Expected::refusal};
}

CallSequence::Outcome CallSequence::joint_frames(Actor& actor) {
  const flinch_pose pose = seen_of(actor).pose;
  auto frames = sized<flinch_joint_frames>();
  const flinch_status status = flinch_library_joint_frames(library_, &pose, &frames);
  if (!std::ranges::all_of(pose.root_position, is_place)) return {status, Expected::refusal};
  for (const auto& position : frames.position) {
    for (const float x : position) {
      if (!std::isfinite(x)) fail("gave a joint's position of", x);
    }
  }
  for (const auto& orientation : frames.orientation) {
    // Of up to eight rotations, one after the other.
    if (!(unit_error(orientation) <= 8 * kMaxUnitError))
      fail("gave a joint's orientation with a length off by", unit_error(orientation));
  }
  return {status, Expected::answer};
}

CallSequence::Outcome CallSequence::clip_pose(Actor&) {
  const auto clips = static_cast<std::uint32_t>(info_.clip_count);
  const auto clip = static_cast<std::int32_t>(below(clips + 2)) - 1;
  const float time_s = number(-1, 3);
  auto pose = sized<flinch_pose>();
  const flinch_status status = flinch_library_clip_pose(library_, clip, time_s, &pose);
  if (status == FLINCH_OK) check_numbers(pose);
  const bool is_good = clip >= 0 && clip < info_.clip_count && is_extent(time_s);
  return {status, is_good ? Expected::answer : Expected::refusal};
}

// From then on it is what the other is, seen bit by bit.
CallSequence::Outcome CallSequence::copy(Actor& actor) {
  const Actor& saved = actors_[below(actors_.size())];
  const flinch_status status = flinch_character_copy(actor.character, saved.character);
  actor.is_bent = saved.is_bent;
  if (!has_same_bits(seen_of(actor), seen_of(saved))) fail("gave another state than", 0);
  return {status, Expected::answer};
}

CallSequence::Outcome CallSequence::limit_perception(Actor& actor) {
  auto limits = sized<flinch_perception_limits>();
  if (below(2) == 0) {
    flinch_human_limits(static_cast<std::int32_t>(draw_()), &limits);
  } else {
    limits.reaction_delay_s = number(0, 0.3F);
    limits.bearing_noise = number(0, 0.1F);
    limits.distance_noise = number(0, 0.1F);
    limits.heading_noise = number(0, 0.1F);
    limits.speed_noise = number(0, 0.1F);
    limits.chance_to_fail = number(0, 0.1F);
  }
  const auto is_limit = [](float x) { return x >= 0 && std::isfinite(x); };
  const bool is_good = is_limit(limits.reaction_delay_s) && is_limit(limits.bearing_noise) &&
                       is_limit(limits.distance_noise) && is_limit(limits.heading_noise) &&
                       is_limit(limits.speed_noise) && is_share(limits.chance_to_fail);
  return {flinch_character_limit_perception(actor.character, &limits, draw_()),
          is_good ? Expected::answer : Expected::refusal};
}

CallSequence::Outcome CallSequence::update(Actor& actor) {
  const float dt_s = number(1.0F / 240, 1.0F / 24);
  return {flinch_character_update(actor.character, dt_s),
          is_time_step(dt_s) ? Expected::answer : Expected::refusal};
}

CallSequence::Outcome CallSequence::make_anew(Actor& actor) {
  flinch_character_free(actor.character);
  actor = {};
  return {flinch_character_create(library_, &actor.character), Expected::answer};
}

CallSequence::Seen CallSequence::seen_of(const Actor& actor) {
  Seen seen;
  seen.pose.size = sizeof seen.pose;
  seen.state.size = sizeof seen.state;
  flinch_character_pose(actor.character, &seen.pose);
  flinch_character_describe(actor.character, &seen.state);
  flinch_character_candidates(actor.character, seen.candidates.data(), FLINCH_MOST_CANDIDATES,
                              &seen.candidate_count);
  return seen;
}

void CallSequence::check(const Actor& actor, const Seen& now) {
  check_numbers(now.pose);
  const std::array hashed{pose_hash_, database::content_hash(bytes_of(now.pose))};
  pose_hash_ = database::content_hash(std::as_bytes(std::span(hashed)));
  const flinch_character_state& state = now.state;
  if (state.phase < FLINCH_IDLE || state.phase > FLINCH_RETURNING)
    fail("led to phase", static_cast<float>(state.phase));
  if (!std::isfinite(state.position[0]) || !std::isfinite(state.position[1]) ||
      !std::isfinite(state.facing) || std::isnan(state.time_to_impact_s))
    fail("led to a state that is not finite; its time to impact is", state.time_to_impact_s);
  if (state.time_to_impact_s > 100 && std::isfinite(state.time_to_impact_s))
    fail("led to a time to impact of", state.time_to_impact_s);
  if (actor.is_bent || !fault_.empty()) return;
  const motion::Pose pose = runtime::pose_of(now.pose);
  for (const motion::JointLimits& limits : motion::human_joint_limits()) {
    const float excess = excess_of(pose, limits);
    max_excess_ = std::max(max_excess_, excess);
    if (!(excess <= kMaxExcess))
      fail("bends " + std::string(limits.name) + " beyond its limit by, radians,", excess);
  }
}

void CallSequence::check_numbers(const flinch_pose& pose) {
  for (const float x : pose.root_position) {
    if (!std::isfinite(x)) fail("led to a position of", x);
  }
  const float error = unit_error(pose);
  max_unit_error_ = std::max(max_unit_error_, error);
  if (!(error <= kMaxUnitError)) fail("led to a rotation with a length off by", error);
}

void CallSequence::fail(const std::string& what, float number) {
  if (fault_.empty()) fault_ = std::string(call_name_) + " " + what + " " + std::to_string(number);
}

}  // namespace flinch::tests
