// SPDX-License-Identifier: MIT
#include "motion/push_measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/default_character.h"
#include "motion/mirror.h"
#include "motion/rotation.h"

namespace flinch::motion {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kRate_hz = 60;

/// A character that faces `facing` stands for 0.5 s; is then moved for 0.6 s along `direction`
/// (world) with the velocity peak sin^2(pi t / 0.6 s), which is highest after 0.3 s; stands again.
Motion shoved(const Skeleton& skeleton, float facing, float direction, float peak_mps) {
  Motion motion;
  motion.rate_hz = kRate_hz;
  for (int k = 0; k < 120; ++k) {
    const float t = std::clamp(static_cast<float>(k) / kRate_hz - 0.5F, 0.0F, 0.6F);
    // The integral of sin^2(a t) is t / 2 - sin(2 a t) / (4 a).
    const float a = kPi / 0.6F;
    const float way = peak_mps * (t / 2 - std::sin(2 * a * t) / (4 * a));
    motion.poses.push_back(placed(rest_pose(skeleton), facing,
                                  {way * std::cos(direction), way * std::sin(direction), 0}));
  }
  return motion;
}

const Skeleton& skeleton() {
  static const Skeleton one = default_character().skeleton;
  return one;
}

TEST(MeasurePush, FindsTimeDirectionAndStrength) {
  // Faces left (+Y) and is moved along +X, to its right: it was pushed from its left.
  const auto push = measure_push(skeleton(), shoved(skeleton(), kPi / 2, 0, 1.2F), {});
  ASSERT_TRUE(push);
  // sin^2 is 10 % of its peak after 0.3 s * 0.205; the differences over 1/15 s widen that.
  EXPECT_NEAR(push->contact_s, 0.5F + 0.06F, 0.035F);
  EXPECT_NEAR(push->peak_s, 0.8F, 0.02F);
  EXPECT_NEAR(push->direction, kPi / 2, 1e-3F);
  EXPECT_NEAR(push->velocity.y(), -1.2F, 0.02F);
  EXPECT_NEAR(push->velocity.x(), 0, 1e-3F);
  EXPECT_EQ(push->place, Role::chest);
}

TEST(MeasurePush, KeepsWhatIsKnown) {
  const Motion motion = shoved(skeleton(), 0, 0.3F, 1);
  const auto push = measure_push(
      skeleton(), motion, {.contact_s = 0.55F, .direction = kPi, .place = Role::left_upper_arm});
  ASSERT_TRUE(push);
  EXPECT_NEAR(push->contact_s, 0.55F, 1e-6F);
  EXPECT_EQ(push->direction, kPi);
  EXPECT_EQ(push->place, Role::left_upper_arm);
  EXPECT_NEAR(std::atan2(push->velocity.y(), push->velocity.x()), 0.3F, 1e-3F);
}

TEST(MeasurePush, FindsNoneWhereNothingMoves) {
  EXPECT_FALSE(measure_push(skeleton(), shoved(skeleton(), 0, 0, 0.05F), {}));
  EXPECT_FALSE(measure_push(skeleton(), {.rate_hz = 60, .poses = {rest_pose(skeleton())}}, {}));
  EXPECT_FALSE(
      measure_push(skeleton(), shoved(skeleton(), 0, 0, 1), {.contact_s = 99.0F, .direction = {}}));
}

TEST(Mirrored, PushComesFromTheOtherSideAtTheOtherShoulder) {
  Clip clip;
  clip.motion = shoved(skeleton(), 0, -kPi / 3, 1);
  clip.push = measure_push(skeleton(), clip.motion,
                           {.contact_s = {}, .direction = {}, .place = Role::left_upper_arm});
  ASSERT_TRUE(clip.push);
  const Clip mirror = mirrored(clip);
  const auto measured =
      measure_push(skeleton(), mirror.motion,
                   {.contact_s = {}, .direction = {}, .place = Role::right_upper_arm});
  ASSERT_TRUE(measured && mirror.push);
  EXPECT_EQ(mirror.push->place, Role::right_upper_arm);
  EXPECT_NEAR(mirror.push->direction, measured->direction, 1e-5F);
  EXPECT_LT((mirror.push->velocity - measured->velocity).norm(), 1e-5F);
  EXPECT_EQ(mirror.push->contact_s, measured->contact_s);
  clip.push->direction = kPi;
  EXPECT_EQ(mirrored(clip).push->direction, kPi);
}

TEST(PushPlace, NamesAreRead) {
  for (const Role place : kPushPlaces) EXPECT_EQ(push_place_named(push_place_name(place)), place);
  EXPECT_FALSE(push_place_named("left_foot"));
  EXPECT_TRUE(push_place_name(Role::left_foot).empty());
}

}  // namespace
}  // namespace flinch::motion
