// SPDX-License-Identifier: MIT
#include "features/impact_prediction.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "features/ball.h"
#include "motion/collision_shape.h"
#include "motion/rotation.h"
#include "tests/features/moving_figure.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/not_finite.h"
#include "tests/scenes/sample_count.h"

namespace flinch::features {
namespace {

using motion::Body;
using motion::Target;
using tests::kInfinity;
using tests::kNan;
using tests::samples;
using tests::uniform;

constexpr double kContactTolerance_m = 1e-3;

const tests::SwayingFigure& figure() {
  static const tests::SwayingFigure figure;
  return figure;
}

PredictedImpact predicted(const Threat& threat, const CharacterState& state = {},
                          const PredictionOptions& options = {}) {
  return predict_impact(threat, figure().collision_figure, figure().idle, figure().motion_bounds,
                        state, options);
}

double gap_at(const Threat& threat, const motion::Pose& pose, double time_s, float gravity_mps2) {
  const Ball ball = ball_of(threat, static_cast<double>(gravity_mps2));
  return figure().gap(pose, ball.position_at(time_s), ball.radius);
}

/// Returns the first time at which a threat is within kContactTolerance_m / 2 of the figure, by
/// dense sampling: every 2 mm of the ball's path while it may be near. Infinite if it bounces
/// first.
template <class PoseAt>
double sampled_touch_s(const Threat& threat, const PoseAt& pose_at,
                       const PredictionOptions& options) {
  const double gravity_mps2 = static_cast<double>(options.gravity_mps2);
  const double radius = static_cast<double>(threat.radius);
  const Eigen::Vector3d start = threat.position.cast<double>();
  const Eigen::Vector3d velocity = threat.velocity.cast<double>();
  const double horizon_s = static_cast<double>(options.horizon_s);
  const double step_s = 0.002 / std::max(velocity.norm() + gravity_mps2 * horizon_s, 1.0);
  for (double t = 0; t <= horizon_s; t += step_s) {
    const Eigen::Vector3d ball =
        start + t * velocity - 0.5 * gravity_mps2 * t * t * Eigen::Vector3d::UnitZ();
    const bool falls = velocity.z() - gravity_mps2 * t < 0;
    if (ball.z() < radius && falls) break;
    const motion::Pose pose = pose_at(static_cast<float>(t));
    if ((ball - pose.root_position.cast<double>()).norm() > 1.6 + radius) continue;
    if (figure().gap(pose, ball, radius) <= 0.5 * kContactTolerance_m) return t;
  }
  return tests::kInfinityDouble;
}

/// Checks that the prediction agrees with the samples. Counts impacts.
template <class PoseAt>
void expect_as_sampled(const Threat& threat, const PredictedImpact& impact, const PoseAt& pose_at,
                       const PredictionOptions& options, int& impacts, int& misses) {
  ASSERT_NE(impact.outcome, Outcome::unusable);
  const double sampled_s = sampled_touch_s(threat, pose_at, options);
  if (impact.outcome == Outcome::miss) {
    ++misses;
    EXPECT_TRUE(std::isinf(sampled_s)) << "missed a touch at " << sampled_s;
    return;
  }
  ++impacts;
  const double touch_s = static_cast<double>(impact.touch_s);
  EXPECT_LE(touch_s, std::min(sampled_s, static_cast<double>(options.horizon_s)) + 1e-6);
  // At the predicted time the ball touches the figure, at the named body. The time is a float.
  const double rounding_m =
      1e-6 + 1e-7 * touch_s * static_cast<double>(threat.velocity.norm() + 30);
  const motion::Pose pose = pose_at(impact.touch_s);
  EXPECT_LE(gap_at(threat, pose, touch_s, options.gravity_mps2), kContactTolerance_m + rounding_m);
  EXPECT_LE(figure().gap_of(impact.body, pose, impact.point.cast<double>(), 0), 1e-5);
  EXPECT_EQ(impact.struck, motion::target_of(impact.body));
  EXPECT_NEAR(impact.normal.norm(), 1, 1e-5F);
  EXPECT_GE(impact.time_to_impact_s, impact.touch_s);
}

/// A ball whose centre passes a random point on or in the figure at the distance `aside`, at
/// `speed_mps`, after `time_s`.
Threat thrown_near(std::mt19937& random, const motion::Pose& pose, float speed_mps, float time_s,
                   const Eigen::Vector3f& from, float aside) {
  const auto body = static_cast<Body>(random() % motion::kBodyCount);
  const Eigen::Vector3f centre = figure().outlines(pose)[body].centre.cast<float>();
  const Eigen::Vector3f across = from.cross(tests::random_direction(random)).normalized();
  Threat threat;
  threat.radius = uniform(random, 0.02F, 0.2F);
  threat.velocity = -speed_mps * from + Eigen::Vector3f(0, 0, kGravity * time_s);
  const Eigen::Vector3f goal = centre + aside * across;
  threat.position =
      goal - time_s * threat.velocity + Eigen::Vector3f(0, 0, 0.5F * kGravity * time_s * time_s);
  return threat;
}

/// Threats that are difficult cases for the sweep.
Threat hard_threat(std::mt19937& random, const motion::Pose& pose) {
  const Eigen::Vector3f anywhere = tests::random_direction(random);
  const float speed = uniform(random, 3, 30);
  const float time_s = uniform(random, 0.1F, 1.2F);
  switch (random() % 8) {
    case 0:  // close to a surface, on either side
      return thrown_near(random, pose, speed, time_s, anywhere, uniform(random, 0.05F, 0.5F));
    case 1:  // from behind
      return thrown_near(random, pose, speed, time_s, {-1, 0, 0}, uniform(random, 0, 0.2F));
    case 2: {  // from straight above, at rest or dropped
      Threat threat = thrown_near(random, pose, 0.001F, 0, {0, 0, 1}, uniform(random, 0, 0.3F));
      threat.position.z() = uniform(random, 1.9F, 6);
      return threat;
    }
    case 3:  // very fast
      return thrown_near(random, pose, 300, 0.05F, anywhere, uniform(random, 0, 0.3F));
    case 4:  // almost at rest
      return thrown_near(random, pose, uniform(random, 0, 1), uniform(random, 0, 0.3F), anywhere,
                         uniform(random, 0, 0.3F));
    case 5: {  // thrown up, falls back onto it
      Threat threat = thrown_near(random, pose, 1, 0, {0, 0, 1}, uniform(random, 0, 0.2F));
      threat.position.z() = uniform(random, 2, 3);
      threat.velocity = {uniform(random, -0.2F, 0.2F), 0, uniform(random, 0, 8)};
      return threat;
    }
    case 6:  // flying away
      return thrown_near(random, pose, speed, -0.3F, anywhere, uniform(random, 0, 0.3F));
    default:
      return thrown_near(random, pose, speed, time_s, anywhere, uniform(random, 0, 0.1F));
  }
}

TEST(PredictImpact, MatchesDenseSamplingForAnIdlingFigure) {
  std::mt19937 random(1);
  const PredictionOptions options{.horizon_s = 1.5F};
  int impacts = 0;
  int misses = 0;
  for (int i = 0; i < samples(400); ++i) {
    const CharacterState state{.idle_time_s = uniform(random, 0, 9),
                               .position = tests::random_vector(random, 3).head<2>(),
                               .facing = uniform(random, -3, 3)};
    const auto pose_at = [&](float time_s) { return idle_pose(figure().idle, state, time_s); };
    const Threat threat = hard_threat(random, pose_at(0.5F));
    SCOPED_TRACE(i);
    expect_as_sampled(threat, predicted(threat, state, options), pose_at, options, impacts, misses);
  }
  EXPECT_GT(impacts, samples(100));
  EXPECT_GT(misses, samples(80));
}

TEST(PredictImpact, MatchesDenseSamplingForAHeldPose) {
  std::mt19937 random(2);
  int impacts = 0;
  int misses = 0;
  for (int i = 0; i < samples(400); ++i) {
    motion::Pose pose = tests::random_pose(random, 0.8F);
    pose.root_position = {uniform(random, -1, 1), uniform(random, -1, 1), 1};
    const PredictionOptions options{.horizon_s = 1.5F, .gravity_mps2 = i % 3 == 0 ? 0 : kGravity};
    const Threat threat = hard_threat(random, pose);
    SCOPED_TRACE(i);
    expect_as_sampled(
        threat, predict_impact(threat, figure().collision_figure, pose, options),
        [&](float) { return pose; }, options, impacts, misses);
  }
  EXPECT_GT(impacts, samples(100));
  EXPECT_GT(misses, samples(80));
}

// A horizontal throw at the middle of the head, without gravity: the head is an upright capsule.
TEST(PredictImpact, TimesMatchAThrowAtTheHead) {
  const motion::Pose& pose = figure().standing;
  const motion::JointFrames frames = forward_kinematics(figure().character.skeleton, pose);
  const Eigen::Vector3f middle = target_centre(figure().model, frames, Target::head);
  const motion::CollisionShape head = figure().outlines(pose)[Body::head];
  Threat threat;
  threat.position = middle + Eigen::Vector3f(10, 0, 0);
  threat.velocity = {-20, 0, 0};
  ASSERT_LT(std::abs(middle.z() - static_cast<float>(head.centre.z())),
            static_cast<float>(head.half_length));
  const PredictedImpact impact =
      predict_impact(threat, figure().collision_figure, pose, {.gravity_mps2 = 0});
  const double surface = head.centre.x() + head.radius;
  ASSERT_EQ(impact.outcome, Outcome::impact);
  EXPECT_NEAR(impact.touch_s, (static_cast<double>(threat.position.x()) - 0.105 - surface) / 20,
              kContactTolerance_m / 20);
  EXPECT_NEAR(impact.time_to_impact_s, 0.5, 1e-6);
  EXPECT_EQ(impact.body, Body::head);
  EXPECT_EQ(impact.struck, Target::head);
  EXPECT_EQ(impact.aimed_at, Target::head);
  EXPECT_LT(
      (impact.point - Eigen::Vector3f(static_cast<float>(surface), middle.y(), middle.z())).norm(),
      1e-5F);
  EXPECT_LT((impact.normal - Eigen::Vector3f::UnitX()).norm(), 1e-5F);
}

// A fall onto the crown takes sqrt(2 h / g).
TEST(PredictImpact, DroppedBallHitsTheHeadAfterItsFallTime) {
  const motion::CollisionShape head = figure().outlines(figure().standing)[Body::head];
  const float crown = static_cast<float>(head.centre.z() + head.half_length + head.radius);
  Threat threat;
  threat.position = head.centre.cast<float>();
  threat.position.z() = crown + threat.radius + 0.5F;
  const PredictedImpact impact =
      predict_impact(threat, figure().collision_figure, figure().standing);
  ASSERT_EQ(impact.outcome, Outcome::impact);
  EXPECT_EQ(impact.body, Body::head);
  EXPECT_NEAR(impact.touch_s, std::sqrt(1 / kGravity), 1e-3F);
  // Without gravity, or beside the figure, it misses.
  EXPECT_EQ(
      predict_impact(threat, figure().collision_figure, figure().standing, {.gravity_mps2 = 0})
          .outcome,
      Outcome::miss);
  threat.position.x() += 2;
  EXPECT_EQ(predict_impact(threat, figure().collision_figure, figure().standing).outcome,
            Outcome::miss);
}

// Down at 45 degrees in front of the toes: it would reach them only by continuing below the ground.
TEST(PredictImpact, ABallThatBouncesFirstMisses) {
  const motion::CollisionShape foot = figure().outlines(figure().standing)[Body::left_foot];
  Threat threat;
  threat.velocity = {-10, 0, -10};
  Eigen::Vector3f bounce = foot.centre.cast<float>();
  bounce.z() = threat.radius;
  while (figure().gap(figure().standing, bounce.cast<double>(), 0.105) < 0.02) bounce.x() += 0.001F;
  const auto outcome = [&] {
    return predict_impact(threat, figure().collision_figure, figure().standing, {.gravity_mps2 = 0})
        .outcome;
  };
  threat.position = bounce - 0.1F * threat.velocity;
  EXPECT_EQ(outcome(), Outcome::miss);
  threat.position.x() -= 0.03F;
  EXPECT_EQ(outcome(), Outcome::impact);
}

TEST(PredictImpact, RollingBallIsPredictedWithZeroGravity) {
  Threat threat;
  threat.position = {3,
                     figure().outlines(figure().standing)[Body::left_foot].centre.cast<float>().y(),
                     threat.radius};
  threat.velocity = {-3, 0, 0};
  EXPECT_EQ(predict_impact(threat, figure().collision_figure, figure().standing).outcome,
            Outcome::miss);
  const PredictedImpact impact =
      predict_impact(threat, figure().collision_figure, figure().standing, {.gravity_mps2 = 0});
  ASSERT_EQ(impact.outcome, Outcome::impact);
  EXPECT_EQ(impact.struck, Target::legs);
  EXPECT_EQ(impact.aimed_at, Target::legs);
}

TEST(PredictImpact, ImpactAfterTheHorizonIsAMiss) {
  Threat threat;
  threat.position = {20, 0, 1.2F};
  threat.velocity = {-20, 0, kGravity / 2};
  const PredictedImpact impact =
      predict_impact(threat, figure().collision_figure, figure().standing);
  ASSERT_EQ(impact.outcome, Outcome::impact);
  const PredictionOptions shorter{.horizon_s = impact.touch_s - 0.001F};
  EXPECT_EQ(predict_impact(threat, figure().collision_figure, figure().standing, shorter).outcome,
            Outcome::miss);
}

// A ball on the same line tells when a fist touches, if its stroke is not over by then.
TEST(PredictImpact, AFistTouchesWithinItsStrokeOnly) {
  const motion::Pose pose = idle_pose(figure().idle, {}, 0);
  const Eigen::Vector3f head = figure().outlines(pose)[Body::head].centre.cast<float>();
  Threat fist;
  fist.radius = 0.04F;
  fist.falls = false;
  fist.velocity = {-8, 0, 0};
  fist.position = head + Eigen::Vector3f(0.6F, 0, 0);
  const PredictedImpact straight = predict_impact(fist, figure().collision_figure, pose);
  ASSERT_EQ(straight.outcome, Outcome::impact);
  for (const float starts_in_s : {0.0F, 0.3F}) {
    fist.stroke = {starts_in_s, straight.touch_s + 0.01F};
    const PredictedImpact impact = predict_impact(fist, figure().collision_figure, pose);
    ASSERT_EQ(impact.outcome, Outcome::impact);
    EXPECT_NEAR(impact.touch_s, starts_in_s + straight.touch_s, 1e-3F);
    EXPECT_EQ(impact.body, Body::head);
    EXPECT_LE(impact.time_to_impact_s, starts_in_s + fist.stroke->lasts_s + 1e-6F);
    fist.stroke->lasts_s = straight.touch_s - 0.01F;
    EXPECT_EQ(predict_impact(fist, figure().collision_figure, pose).outcome, Outcome::miss);
  }
}

TEST(PredictImpact, BallInsideABodyIsTouching) {
  for (const motion::CollisionShape& outline : figure().outlines(figure().standing)) {
    Threat threat;
    threat.position = outline.centre.cast<float>();
    threat.velocity = {0, 0, 3};
    const PredictedImpact impact =
        predict_impact(threat, figure().collision_figure, figure().standing);
    EXPECT_EQ(impact.outcome, Outcome::touching);
    EXPECT_EQ(impact.touch_s, 0);
    EXPECT_GE(impact.time_to_impact_s, 0);
  }
}

/// The smallest distance of a ball from a point up to the horizon, by steps of 1 ms.
double sampled_distance(const Ball& ball, const Eigen::Vector3d& centre, float horizon_s) {
  double min = tests::kInfinityDouble;
  const int horizon_ms = static_cast<int>(1000 * horizon_s);
  for (int ms = 0; ms <= horizon_ms; ++ms) {
    min = std::min(min, (ball.position_at(0.001 * ms) - centre).norm());
  }
  return min;
}

/// A ball that touches the figure, at a speed of up to `max_speed_mps`.
Threat touching_ball(std::mt19937& random, float max_speed_mps) {
  const auto body = static_cast<Body>(random() % motion::kBodyCount);
  Threat threat;
  threat.position = figure().outlines(figure().standing)[body].centre.cast<float>() +
                    uniform(random, 0, 0.12F) * tests::random_direction(random);
  threat.velocity = uniform(random, 0, 1) * max_speed_mps * tests::random_direction(random);
  return threat;
}

// Gravity alone brings such a ball to where it is nearest.
TEST(PredictImpact, ABallAtRestOnTheBodyHitsWhenItsFallBringsItNearest) {
  std::mt19937 random(6);
  const motion::JointFrames frames =
      forward_kinematics(figure().character.skeleton, figure().standing);
  constexpr float kHorizon_s = 0.5F;
  int touching = 0;
  int falling = 0;
  for (int i = 0; i < samples(4000); ++i) {
    const float speed_mps = std::pow(10.0F, uniform(random, -44, -3));
    const Threat threat = touching_ball(random, i % 10 == 0 ? 0 : speed_mps);
    const PredictedImpact impact = predict_impact(threat, figure().collision_figure,
                                                  figure().standing, {.horizon_s = kHorizon_s});
    if (impact.outcome != Outcome::touching) continue;
    ++touching;
    const Ball ball = ball_of(threat);
    const Eigen::Vector3d centre =
        target_centre(figure().model, frames, impact.aimed_at).cast<double>();
    const Eigen::Vector3d then =
        ball.position_at(static_cast<double>(impact.time_to_impact_s)) - centre;
    EXPECT_LE(then.norm(), sampled_distance(ball, centre, kHorizon_s) + 1e-6)
        << threat.position.transpose();
    falling += impact.time_to_impact_s > 0.01F ? 1 : 0;
  }
  EXPECT_GT(touching, samples(2000));
  EXPECT_GT(falling, samples(400));
}

TEST(PredictImpact, TimesOfTouchingBallsStayWithinTheHorizon) {
  std::mt19937 random(7);
  int touching = 0;
  for (int i = 0; i < samples(1000000); ++i) {
    const Threat threat = touching_ball(random, 1e-3F);
    const PredictedImpact impact =
        predict_impact(threat, figure().collision_figure, figure().standing);
    if (impact.outcome != Outcome::touching) continue;
    ++touching;
    ASSERT_TRUE(impact.time_to_impact_s >= 0 && impact.time_to_impact_s <= 2)
        << impact.time_to_impact_s << " s for a ball at " << threat.position.transpose()
        << " that moves at " << threat.velocity.transpose();
  }
  EXPECT_GT(touching, samples(500000));
}

TEST(PredictImpact, IsInvariantToRigidMotionOfTheWorld) {
  std::mt19937 random(3);
  int impacts = 0;
  for (int i = 0; i < samples(300); ++i) {
    const CharacterState state{.idle_time_s = uniform(random, 0, 9)};
    const Threat threat = hard_threat(random, figure().standing);
    CharacterState moved = state;
    moved.position = {3, -2};
    moved.facing = uniform(random, -3, 3);
    const Eigen::Quaternionf turn = motion::rotation_about(Eigen::Vector3f::UnitZ(), moved.facing);
    Threat turned = threat;
    turned.position = turn * threat.position + Eigen::Vector3f(3, -2, 0);
    turned.velocity = turn * threat.velocity;
    const PredictedImpact here = predicted(threat, state);
    const PredictedImpact there = predicted(turned, moved);
    if (here.outcome != Outcome::impact || there.outcome != Outcome::impact) {
      continue;  // a grazing pass may count either way
    }
    ++impacts;
    EXPECT_NEAR(here.touch_s, there.touch_s, 2e-3F / threat.velocity.norm() + 1e-4F);
    EXPECT_EQ(here.aimed_at, there.aimed_at);
    EXPECT_NEAR(here.time_to_impact_s, there.time_to_impact_s, 1e-3F);
  }
  EXPECT_GT(impacts, samples(80));
}

TEST(PredictImpact, HeldPoseEqualsASinglePoseIdleClip) {
  std::mt19937 random(4);
  motion::Motion still;
  still.poses.push_back(figure().standing);
  const MotionBounds motion_bounds =
      motion_bounds_of(figure().character.skeleton, figure().model, still);
  for (int i = 0; i < samples(200); ++i) {
    const Threat threat = hard_threat(random, figure().standing);
    const PredictedImpact held =
        predict_impact(threat, figure().collision_figure, figure().standing);
    const PredictedImpact idle =
        predict_impact(threat, figure().collision_figure, still, motion_bounds, {});
    EXPECT_EQ(held.outcome, idle.outcome);
    EXPECT_EQ(held.body, idle.body);
    EXPECT_NEAR(held.touch_s, idle.touch_s, 1e-5F);
    EXPECT_NEAR(held.time_to_impact_s, idle.time_to_impact_s, 1e-5F);
  }
}

TEST(PredictImpact, TakesPosesFromAnyFunctionOfTime) {
  // The character walks into a ball at rest 1 m in front of its chest.
  const motion::CollisionShape chest = figure().outlines(figure().standing)[Body::chest];
  Threat threat;
  threat.position = chest.centre.cast<float>() + Eigen::Vector3f(1, 0, 0);
  const auto walks = [&](float time_s) {
    motion::Pose pose = figure().standing;
    pose.root_position.x() += 1.5F * time_s;
    return pose;
  };
  const MotionBounds motion_bounds{
      .pelvis_centre = walks(0.5F).root_position, .radius = 1, .max_speed_mps = 1.5F};
  const PredictedImpact impact =
      predict_impact(threat, figure().collision_figure, PredictedMotion(walks, motion_bounds),
                     {.horizon_s = 1, .gravity_mps2 = 0});
  ASSERT_EQ(impact.outcome, Outcome::impact);
  EXPECT_EQ(impact.body, Body::chest);
  EXPECT_NEAR(static_cast<double>(impact.touch_s), (1 - 0.105 - chest.half_extents.x()) / 1.5,
              kContactTolerance_m / 1.5 + 1e-6);
}

TEST(PredictImpact, InvalidInputIsUnusable) {
  Threat threat;
  threat.position = {5, 0, 1.2F};
  threat.velocity = {-15, 0, 1};
  ASSERT_EQ(predicted(threat).outcome, Outcome::impact);
  for (float bad : {kNan, kInfinity, -kInfinity, 2e6F}) {
    for (int i = 0; i < 3; ++i) {
      Threat wrong = threat;
      wrong.position[i] = bad;
      EXPECT_EQ(predicted(wrong).outcome, Outcome::unusable);
      wrong = threat;
      wrong.velocity[i] = bad;
      EXPECT_EQ(predicted(wrong).outcome, Outcome::unusable);
    }
    EXPECT_EQ(predicted(threat, {}, {.horizon_s = bad}).outcome, Outcome::unusable);
    EXPECT_EQ(predicted(threat, {}, {.gravity_mps2 = bad}).outcome, Outcome::unusable);
    EXPECT_EQ(predicted(threat, {.position = {bad, 0}}).outcome, Outcome::unusable);
  }
  for (float bad : {kNan, kInfinity}) {
    EXPECT_EQ(predicted(threat, {.facing = bad}).outcome, Outcome::unusable);
    EXPECT_EQ(predicted(threat, {.idle_time_s = bad}).outcome, Outcome::unusable);
    motion::Pose pose = figure().standing;
    pose.rotation[motion::Role::chest].x() = bad;
    EXPECT_EQ(predict_impact(threat, figure().collision_figure, pose).outcome, Outcome::unusable);
    pose = figure().standing;
    pose.root_position.y() = bad;
    EXPECT_EQ(predict_impact(threat, figure().collision_figure, pose).outcome, Outcome::unusable);
  }
  for (float bad : {kNan, kInfinity, -1.0F, 2e6F}) {
    Threat wrong = threat;
    wrong.radius = bad;
    EXPECT_EQ(predicted(wrong).outcome, Outcome::unusable);
    wrong = threat;
    wrong.mass_kg = bad;
    EXPECT_EQ(predicted(wrong).outcome, Outcome::unusable);
  }
  EXPECT_EQ(predict_impact(threat, {}, figure().standing).outcome, Outcome::unusable);
  EXPECT_EQ(predict_impact(threat, figure().collision_figure, motion::Motion{}, MotionBounds{}, {})
                .outcome,
            Outcome::unusable);
}

/// Returns an arbitrary float, or one of ordinary magnitude.
float any_float(std::mt19937& random) {
  if (random() % 4 == 0) return std::bit_cast<float>(static_cast<std::uint32_t>(random()));
  if (random() % 4 == 0) return 0;
  const float size = std::pow(10.0F, uniform(random, -4, 6));
  return uniform(random, -size, size);
}

TEST(PredictImpact, TerminatesWithFiniteResultsForAnyInput) {
  std::mt19937 random(5);
  int usable = 0;
  int impacts = 0;
  for (int i = 0; i < samples(20000); ++i) {
    Threat threat;
    for (int k = 0; k < 3; ++k) {
      threat.position[k] = any_float(random);
      threat.velocity[k] = any_float(random);
    }
    if (random() % 2 == 0) threat.radius = any_float(random);
    PredictionOptions options;
    if (random() % 2 == 0) options.horizon_s = any_float(random);
    if (random() % 2 == 0) options.gravity_mps2 = any_float(random);
    const PredictedImpact impact =
        random() % 2 == 0
            ? predicted(threat, {}, options)
            : predict_impact(threat, figure().collision_figure, figure().standing, options);
    if (impact.outcome != Outcome::unusable) ++usable;
    if (impact.outcome == Outcome::impact || impact.outcome == Outcome::touching) ++impacts;
    EXPECT_TRUE(std::isfinite(impact.touch_s) && std::isfinite(impact.time_to_impact_s) &&
                impact.point.allFinite() && impact.normal.allFinite());
    EXPECT_LE(0, impact.touch_s);
    EXPECT_LE(impact.touch_s, impact.time_to_impact_s);
    if (impact.outcome != Outcome::unusable) {
      EXPECT_LE(impact.time_to_impact_s, options.horizon_s);
    }
  }
  EXPECT_GT(usable, samples(2000));
  EXPECT_GT(impacts, samples(200));
}

}  // namespace
}  // namespace flinch::features
