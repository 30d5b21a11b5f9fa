// SPDX-License-Identifier: MIT
#include "models/baseline.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <vector>

namespace flinch::models {
namespace {

using motion::Target;

constexpr float kDegree = std::numbers::pi_v<float> / 180;

ClipSummary clip_against(Target target, float direction_degrees) {
  return {"", motion::Annotation{.target = target, .direction = direction_degrees * kDegree}};
}

const std::vector<ClipSummary> kClips{
    {"idle", {}},                      // 0
    clip_against(Target::head, 0),     // 1
    clip_against(Target::head, 90),    // 2
    clip_against(Target::head, 180),   // 3
    clip_against(Target::head, -135),  // 4
    clip_against(Target::trunk, 45),   // 5
    clip_against(Target::legs, -90),   // 6
    clip_against(Target::legs, -90),   // 7
    {"unannotated", {}},               // 8
};

int nearest_at(Target target, float azimuth_degrees) {
  return nearest_annotation(kClips, 0, target, azimuth_degrees * kDegree);
}

TEST(NearestAnnotation, TakesTheNearestDirection) {
  EXPECT_EQ(nearest_at(Target::head, 10), 1);
  EXPECT_EQ(nearest_at(Target::head, 50), 2);
  EXPECT_EQ(nearest_at(Target::head, -60), 1);
  EXPECT_EQ(nearest_at(Target::head, -70), 4);
}

TEST(NearestAnnotation, WrapsAnglesAtTheBack) {
  EXPECT_EQ(nearest_at(Target::head, 179), 3);
  EXPECT_EQ(nearest_at(Target::head, -179), 3);
  EXPECT_EQ(nearest_at(Target::head, -160), 3);  // 20 from the back, 25 from -135
  EXPECT_EQ(nearest_at(Target::head, -155), 4);
  EXPECT_EQ(nearest_at(Target::head, 360 + 85), 2);
  EXPECT_EQ(nearest_at(Target::head, 225), 4);
}

TEST(NearestAnnotation, PrefersTheTargetToTheDirection) {
  EXPECT_EQ(nearest_at(Target::trunk, -90), 5);
  EXPECT_EQ(nearest_at(Target::head, 45.5F), 2);  // the trunk's clip is nearer in angle
}

TEST(NearestAnnotation, FallsBackToTheNeighbourThenToIdle) {
  EXPECT_EQ(nearest_at(Target::pelvis, -90), 6);
  EXPECT_EQ(nearest_at(Target::pelvis, 40), 5);
  const std::vector<ClipSummary> heads{clip_against(Target::head, 0), {"idle", {}}};
  EXPECT_EQ(nearest_annotation(heads, 1, Target::legs, 0), 1);
}

TEST(NearestAnnotation, TiesGoToTheLowerIndex) {
  EXPECT_EQ(nearest_at(Target::legs, -90), 6);
  EXPECT_EQ(nearest_at(Target::legs, 90), 6);
}

// With 5 degrees of freedom, chi-square exceeds 20.5 once in a thousand uniform samples.
TEST(RandomAllowed, IsUniformOverAllowedClips) {
  std::mt19937_64 random(1);
  std::vector<int> count(kClips.size());
  constexpr int kDraws = 60000;
  for (int i = 0; i < kDraws; ++i) {
    ++count[static_cast<std::size_t>(random_allowed(kClips, 0, Target::head, random()))];
  }
  double chi_square = 0;
  for (std::size_t clip = 0; clip < kClips.size(); ++clip) {
    if (clip <= 5) {
      const double expected = kDraws / 6.0;
      chi_square += (count[clip] - expected) * (count[clip] - expected) / expected;
    } else {
      EXPECT_EQ(count[clip], 0) << "clip " << clip << " is not allowed";
    }
  }
  EXPECT_LT(chi_square, 20.5);
}

}  // namespace
}  // namespace flinch::models
