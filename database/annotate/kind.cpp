// SPDX-License-Identifier: MIT
#include "database/annotate/kind.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "motion/enum_array.h"

namespace flinch::database {
namespace {

using motion::Role;

constexpr motion::EnumArray<MovementKind, std::string_view, 7> kKindNames{
    "block", "duck", "dodge", "step", "lift", "flinch", "push"};

constexpr float kGravity_mps2 = 9.81F;
constexpr double kPush_s = 0.5;                // the longest that a push lasts
constexpr double kAccelerationReach_s = 0.07;  // of each of two means before differences
constexpr float kInAir_m = 0.08F;              // height of the toes' joints
constexpr int kDirections = 16;                // around which the feet are bounded

constexpr float kFloor_m = 0.8F;
constexpr float kFootRise_m = 0.45F;
constexpr float kDuck_m = 0.24F;
constexpr float kHandOverHead_m = 0.05F;
constexpr float kTravel_m = 0.3F;
constexpr float kTravelPerLean = 1.5F;
constexpr float kPushed_m = 0.2F;
constexpr float kExternalShare = 0.25F;  // steps: up to 0.2, pushes 0.2 to 0.5
constexpr float kLean_m = 0.25F;

float horizontal(const Eigen::Vector3f& vector) {
  return vector.head<2>().norm();
}

Eigen::Vector3f hand_from_chest(const JointPositions& joints, Role hand) {
  return joints[hand] - joints[Role::chest];
}

float hand_speed(const TakeSignals& signals, Role hand, std::size_t frame) {
  const std::size_t before = frame > 0 ? frame - 1 : 0;
  const std::size_t after = std::min(frame + 1, signals.relative.size() - 1);
  if (after == before) return 0;
  return (hand_from_chest(signals.relative[after], hand) -
          hand_from_chest(signals.relative[before], hand))
             .norm() *
         signals.world.rate_hz / static_cast<float>(after - before);
}

float centre_speed(const Trajectory& world, const FrameSpan& span) {
  float largest = 0;
  for (std::size_t i = span.first; i < span.last; ++i) {
    largest = std::max(largest, horizontal(world.centre_of_mass[i + 1] - world.centre_of_mass[i]));
  }
  return largest * world.rate_hz;
}

// Smoothed horizontal acceleration of the centre of mass.
std::array<std::vector<float>, 2> acceleration_of(const Trajectory& world) {
  std::array<std::vector<float>, 2> acceleration;
  const std::size_t reach = frames_in(kAccelerationReach_s, world.rate_hz);
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<float> place;
    for (const Eigen::Vector3f& centre : world.centre_of_mass) place.push_back(centre[axis]);
    place = moving_mean(moving_mean(place, reach), reach);
    std::vector<float>& own = acceleration[static_cast<std::size_t>(axis)];
    own.assign(place.size(), 0.0F);
    for (std::size_t i = 1; i + 1 < place.size(); ++i) {
      own[i] = (place[i + 1] - 2 * place[i] + place[i - 1]) * world.rate_hz * world.rate_hz;
    }
  }
  return acceleration;
}

// Distance of a point outside the convex hull of the feet's joints, at most: the largest of its
// distances beyond their bound in each direction.
float outside_feet(const JointPositions& joints, const Eigen::Vector2f& point) {
  float outside = 0;
  for (int k = 0; k < kDirections; ++k) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kDirections;
    const Eigen::Vector2f direction(std::cos(angle), std::sin(angle));
    float bound = -std::numeric_limits<float>::infinity();
    for (Role role : {Role::left_foot, Role::left_toes, Role::right_foot, Role::right_toes}) {
      bound = std::max(bound, direction.dot(joints[role].head<2>()));
    }
    outside = std::max(outside, direction.dot(point) - bound);
  }
  return outside;
}

std::string measured(const char* format, float value) {
  char text[96];
  std::snprintf(text, sizeof text, format, static_cast<double>(value));
  return text;
}

// Asks the questions of kind_of in turn.
class Questions {
 public:
  // Returns whether every value reaches its limit. A yes is as certain as its least certain part, a
  // no as its most certain one.
  bool all(std::initializer_list<float> confidences) {
    const float yes = std::min(confidences);
    confidence_ = std::min(confidence_, yes >= 0.5F ? yes : 1 - yes);
    return yes >= 0.5F;
  }
  float confidence() const { return confidence_; }

 private:
  float confidence_ = 1;
};

}  // namespace

std::string_view name_of(MovementKind kind) {
  return kKindNames[kind];
}

std::vector<float> speed_of_hands(const TakeSignals& signals) {
  std::vector<float> speed;
  for (std::size_t i = 0; i < signals.relative.size(); ++i) {
    speed.push_back(hand_speed(signals, Role::left_hand, i) +
                    hand_speed(signals, Role::right_hand, i));
  }
  return moving_mean(speed, frames_in(0.035, signals.world.rate_hz));
}

float external_speed(const TakeSignals& signals, const FrameSpan& span) {
  const Trajectory& world = signals.world;
  const auto acceleration = acceleration_of(world);
  std::vector<float> gained;
  for (std::size_t i = span.first; i <= span.last; ++i) {
    const JointPositions& joints = world.joints[i];
    gained.push_back(0);
    if (std::min(joints[Role::left_toes].z(), joints[Role::right_toes].z()) > kInAir_m) continue;
    const Eigen::Vector3f& centre = world.centre_of_mass[i];
    const Eigen::Vector2f zero_moment_point =
        centre.head<2>() -
        Eigen::Vector2f(acceleration[0][i], acceleration[1][i]) * centre.z() / kGravity_mps2;
    gained.back() =
        outside_feet(joints, zero_moment_point) * kGravity_mps2 / centre.z() / world.rate_hz;
  }
  const std::size_t window = frames_in(kPush_s, world.rate_hz);
  float sum = 0, largest = 0;
  for (std::size_t i = 0; i < gained.size(); ++i) {
    sum += gained[i] - (i >= window ? gained[i - window] : 0.0F);
    largest = std::max(largest, sum);
  }
  return largest;
}

MovementMeasures measures_of(const TakeSignals& signals, const Movement& movement) {
  MovementMeasures measures;
  const JointPositions& first = signals.world.joints[movement.span.first];
  const auto raise = [](float& largest, float value) { largest = std::max(largest, value); };
  measures.hand_over_head_m = -std::numeric_limits<float>::infinity();
  for (std::size_t i = movement.span.first; i <= movement.span.last; ++i) {
    const JointPositions& joints = signals.world.joints[i];
    const auto moved = [&](Role role) -> Eigen::Vector3f { return joints[role] - first[role]; };
    raise(measures.head_drop_m, -moved(Role::head).z());
    raise(measures.head_shift_m, horizontal(moved(Role::head)));
    raise(measures.lean_m, horizontal(moved(Role::head) - moved(Role::pelvis)));
    raise(measures.travel_m, horizontal(moved(Role::pelvis)));
    const float left_rise = moved(Role::left_foot).z();
    const float right_rise = moved(Role::right_foot).z();
    raise(measures.foot_rise_m, std::max(left_rise, right_rise));
    raise(measures.both_feet_rise_m, std::min(left_rise, right_rise));
    for (Role hand : {Role::left_hand, Role::right_hand}) {
      raise(measures.hand_over_head_m, joints[hand].z() - joints[Role::head].z());
      raise(measures.hand_rise_m, moved(hand).z() - moved(Role::head).z());
      raise(measures.hand_speed_mps, hand_speed(signals, hand, i));
    }
  }
  measures.centre_speed_mps = centre_speed(signals.world, movement.span);
  measures.external_speed_mps = external_speed(signals, movement.span);
  return measures;
}

Guess<MovementKind> kind_of(const MovementMeasures& measures) {
  const MovementMeasures& m = measures;
  Questions ask;
  const auto answer = [&](MovementKind kind, std::string reason) {
    return Guess<MovementKind>{kind, ask.confidence(), std::move(reason)};
  };
  if (ask.all({confidence_above(m.head_drop_m, kFloor_m)})) {
    return answer(MovementKind::dodge, measured("the head sinks by %.2f m", m.head_drop_m));
  }
  if (ask.all({std::max(confidence_above(m.foot_rise_m, kFootRise_m),
                        confidence_above(m.both_feet_rise_m, kJumpRise_m))})) {
    return answer(MovementKind::lift, m.both_feet_rise_m >= kJumpRise_m
                                          ? measured("both feet rise by %.2f m", m.both_feet_rise_m)
                                          : measured("a foot rises by %.2f m", m.foot_rise_m));
  }
  const float hand_over_head = std::min(confidence_above(m.hand_over_head_m, kHandOverHead_m),
                                        confidence_above(m.hand_rise_m, kHandOverHead_m));
  if (ask.all({confidence_above(m.head_drop_m, kDuck_m), 1 - hand_over_head})) {
    return answer(MovementKind::duck, measured("the head sinks by %.2f m", m.head_drop_m));
  }
  if (ask.all({std::max(hand_over_head, confidence_above(m.hand_speed_mps, kThrownHand_mps))})) {
    return answer(MovementKind::block,
                  hand_over_head >= 0.5F
                      ? measured("a wrist comes %.2f m above the head joint", m.hand_over_head_m)
                      : measured("a hand is thrown at %.1f m/s", m.hand_speed_mps));
  }
  const float carried = confidence_above(m.travel_m, kTravelPerLean * m.lean_m + 1e-3F);
  const float pushed =
      confidence_above(m.external_speed_mps, kExternalShare * m.centre_speed_mps + 1e-3F);
  if (ask.all({confidence_above(m.travel_m, kPushed_m), carried, pushed})) {
    return answer(MovementKind::push,
                  measured("%.2f m/s did not come from the feet", m.external_speed_mps));
  }
  if (ask.all({confidence_above(m.travel_m, kTravel_m), carried})) {
    return answer(MovementKind::step, measured("the pelvis travels %.2f m", m.travel_m));
  }
  return {MovementKind::flinch, std::min(ask.confidence(), confidence_above(m.lean_m, kLean_m)),
          measured("the head leans away by %.2f m", m.lean_m)};
}

}  // namespace flinch::database
