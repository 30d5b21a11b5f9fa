// SPDX-License-Identifier: MIT
#include "lookahead/first_hit.h"

#include <gtest/gtest.h>

#include "tests/lookahead/trained_library.h"

namespace flinch::lookahead {
namespace {

using motion::Body;
using tests::trained;

constexpr float kTime_s = 0.5F;

/// An idling character, and balls that fly straight at a point of it.
class FirstHitTest : public testing::Test {
 protected:
  FirstHitTest() {
    features::CharacterState state;
    reference_.follow(
        runtime::make_response(trained().library.prepared(), state, trained().clips.idle, kTime_s),
        trained().clips.rate_hz);
  }

  std::size_t frame_at(double time_s) { return static_cast<std::size_t>(time_s * rate_hz_); }

  /// A ball along -X that would be at this point of the head's centre of mass at kTime_s.
  features::Ball ball_at_head(double left_m, double speed_mps) {
    const sim::BodyState head = reference_.places_at_frame(frame_at(kTime_s))[Body::head];
    features::Ball ball;
    ball.gravity_mps2 = 0;
    ball.velocity = {-speed_mps, 0, 0};
    ball.position = head.position + Eigen::Vector3d(0, left_m, 0) - kTime_s * ball.velocity;
    return ball;
  }

  FirstHit hit_of(const features::Ball& ball) {
    return least_first_hit(reference_, *trained().data->figure, ball, frame_at(kTime_s - 0.05),
                           ones_);
  }

  double rate_hz_ = double{trained().clips.rate_hz};
  motion::PerBody<double> ones_ = [] {
    motion::PerBody<double> ones;
    for (double& one : ones) one = 1;
    return ones;
  }();
  ResponseReference reference_{*trained().data->figure};
};

TEST_F(FirstHitTest, AHeadOnHitGivesNearlyTheImpulseOfTwoFreeBodies) {
  const features::Ball ball = ball_at_head(0, 20);
  const FirstHit hit = hit_of(ball);
  const double head_kg = static_cast<double>(trained().data->figure->model[Body::head].mass_kg);
  const double impulse_ns = (1 + ball.bounce.restitution) * 20 / (1 / ball.mass_kg + 1 / head_kg);
  EXPECT_LT(hit.damage_ns, impulse_ns);  // off the centre of mass, and a centimetre beside
  EXPECT_GT(hit.damage_ns, 0.85 * impulse_ns);
  EXPECT_GT(hit.contact_s, kTime_s - 0.02);
  EXPECT_LT(hit.contact_s, kTime_s);
}

TEST_F(FirstHitTest, ItIsProportionalToTheSpeed) {
  const double slow_ns = hit_of(ball_at_head(0, 10)).damage_ns;
  EXPECT_NEAR(hit_of(ball_at_head(0, 20)).damage_ns, 2 * slow_ns, 0.02 * slow_ns);
}

TEST_F(FirstHitTest, NothingIsCertainWhereACentimetreDecides) {
  double touching_m = 0;
  for (; std::isfinite(hit_of(ball_at_head(touching_m, 20)).contact_s); touching_m += 0.002) {
  }
  ASSERT_GT(touching_m, 0.1);
  EXPECT_EQ(hit_of(ball_at_head(touching_m - 0.004, 20)).damage_ns, 0);
  EXPECT_GT(hit_of(ball_at_head(touching_m - 0.03, 20)).damage_ns, 0);
}

TEST_F(FirstHitTest, OfPartsThatAreHitAtTheSameTimeTheLeastVulnerableCounts) {
  const features::Ball ball = ball_at_head(0, 20);
  const double whole_ns = hit_of(ball).damage_ns;
  ones_[Body::head] = 3;
  EXPECT_DOUBLE_EQ(hit_of(ball).damage_ns, 3 * whole_ns);
  features::Ball lower = ball;
  lower.position.z() -= 0.1;  // between head and neck
  ones_[Body::neck] = 0;
  ones_[Body::chest] = 0;
  EXPECT_EQ(hit_of(lower).damage_ns, 0);
}

TEST_F(FirstHitTest, NothingIsKnownOfHitsAfterABounce) {
  features::Ball ball = ball_at_head(0, 12);
  ball.position = {0.6, 0.1, 0.115};
  ball.velocity = {-12, 0, -3};
  const auto hit = [&] {
    return least_first_hit(reference_, *trained().data->figure, ball, 0, ones_);
  };
  EXPECT_EQ(hit().damage_ns, 0);
  ball.velocity.z() = 0;  // at the foot
  EXPECT_GT(hit().damage_ns, 0);
}

}  // namespace
}  // namespace flinch::lookahead
