// SPDX-License-Identifier: MIT
#include "sim/tree/tree_scene.h"

#include <gtest/gtest.h>

#include <random>

#include "motion/rotation.h"
#include "sim/figure/reference.h"
#include "sim/ode/ode_scene.h"
#include "tests/sim/figure_motions.h"

namespace flinch::sim {
namespace {

using motion::Body;

/// Steps of anything to anywhere: what the two scenes are compared by.
class RandomStep {
 public:
  explicit RandomStep(const FigureModel& figure_model, unsigned seed)
      : figure_model_(figure_model), generator_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  Eigen::Vector3d vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  /// A pose with all joints bent by up to `turn` radians, often beyond their limits.
  ReferenceState state(double turn) {
    motion::Pose pose = scenes::standing(figure_model_.skeleton);
    for (motion::Role role : motion::kRoles) {
      pose.rotation[role] =
          pose.rotation[role] * motion::rotation_from_vector<float>(vector(turn).cast<float>());
    }
    ReferenceState result = state_at_rest(figure_model_.skeleton, figure_model_.model, pose);
    for (BodyState& body : result.body) {
      body.velocity = vector(3);
      body.angular_velocity = vector(8);
    }
    return result;
  }
  /// Displaced from the motion, with the joints pulled apart a little.
  ReferenceState disturbed(const ReferenceState& from) {
    ReferenceState result = from;
    for (BodyState& body : result.body) {
      body.position += vector(0.01);
      body.orientation = motion::rotation_from_vector<double>(vector(0.3)) * body.orientation;
      body.velocity += vector(1);
    }
    return result;
  }

 private:
  const FigureModel& figure_model_;
  std::mt19937 generator_;
};

class TreeSceneTest : public testing::Test {
 protected:
  FigureModel figure_model_{motion::default_character()};

  /// Largest difference of a velocity after the step, divided by the largest velocity.
  double difference(const OdeScene& ode, const TreeScene& tree) {
    double most = 0;
    double greatest = 1;
    for (Body body : motion::kBodies) {
      const BodyState expected = state_of(ode.figure().body(body));
      const BodyState& found = tree.bodies()[body];
      most = std::max({most, (expected.velocity - found.velocity).norm(),
                       (expected.angular_velocity - found.angular_velocity).norm(),
                       (expected.position - found.position).norm(),
                       (expected.orientation.coeffs() - found.orientation.coeffs()).norm()});
      greatest = std::max({greatest, expected.velocity.norm(), expected.angular_velocity.norm()});
    }
    if (ode.ball()) {
      const Eigen::Vector3d expected = ode.ball()->flight().velocity;
      most = std::max(most, (expected - tree.flight()->velocity).norm());
    }
    return most / greatest;
  }
};

TEST_F(TreeSceneTest, FreeFiguresMatchOde) {
  RandomStep random(figure_model_, 1);
  for (int i = 0; i < 200; ++i) {
    ReferenceState start = random.disturbed(random.state(i % 2 ? 0.3 : 1.2));
    const ReferenceState target = random.state(i % 2 ? 0.3 : 1.2);
    const double step_s = i % 3 ? random.uniform(1e-5, 1.0 / 60) : 1.0 / 60;
    // ODE takes the joints' positions on the children from the starting state, which must not be
    // displaced.
    for (Body body : motion::kBodies) {
      if (const auto parent = parent_of(body)) {
        const BodyState& parent_state = start.body[*parent];
        start.socket[body] = parent_state.orientation.conjugate() *
                             (start.body[body].position +
                              start.body[body].orientation * joint_offset(figure_model_, body) -
                              parent_state.position);
      }
    }
    OdeScene ode(figure_model_, start, nullptr, features::kGravity_mps2);
    TreeScene tree(figure_model_, start.body, nullptr, features::kGravity_mps2);
    ode.figure().set_motors(target, step_s);
    ode.step(target, step_s);
    tree.step(target, step_s);
    EXPECT_LT(difference(ode, tree), 1e-9) << "step " << i << " of " << step_s;
  }
}

TEST_F(TreeSceneTest, FiguresInContactMatchOde) {
  RandomStep random(figure_model_, 2);
  int rubbed = 0;
  for (int i = 0; i < 300; ++i) {
    ReferenceState start = random.state(0.4);
    const ReferenceState target = random.state(0.4);
    const double step_s = i % 3 ? 1.0 / 2000 : 1.0 / 60;
    features::Ball thrown;
    thrown.position = {0.3, 0, 1};
    thrown.velocity = random.vector(20);
    OdeScene ode(figure_model_, start, &thrown, features::kGravity_mps2);
    TreeScene tree(figure_model_, start.body, &thrown, features::kGravity_mps2);
    ode.figure().set_motors(target, step_s);
    const auto both = [&](auto&& add) {
      add(ode);
      add(tree);
    };
    const auto body = [&] {
      return motion::kBodies[static_cast<std::size_t>(random.uniform(0, 16.999))];
    };
    both([&](auto& scene) { scene.add_supports(target, step_s); });
    for (int k = 0; k < i % 4; ++k) {
      const Body hit = body();
      const Eigen::Vector3d normal = random.vector(1).normalized();
      const motion::Clearance near{0, thrown.position - thrown.radius * normal, normal};
      both([&](auto& scene) { scene.add_hit(hit, near, 0.7); });
      ++rubbed;
    }
    if (i % 7 == 0) both([&](auto& scene) { scene.add_bounce(0.7); });
    for (int k = 0; k < i % 5; ++k) {
      const Body first = body();
      const Body second = body();
      if (first == second) continue;
      const motion::Clearance near{0, start.body[first].position + random.vector(0.1),
                                   random.vector(1).normalized()};
      const double closing = random.uniform(0, 1);
      both([&](auto& scene) { scene.add_body_contact(first, second, near, closing, true); });
    }
    ode.step(target, step_s);
    tree.step(target, step_s);
    EXPECT_LT(difference(ode, tree), 1e-6) << "step " << i;
    const auto expected = ode.impulses(step_s);
    const auto found = tree.impulses(step_s);
    ASSERT_EQ(expected.size(), found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(expected[k].first, found[k].first);
      EXPECT_EQ(expected[k].second, found[k].second);
      EXPECT_NEAR(expected[k].impulse_ns, found[k].impulse_ns, 1e-6 * (1 + expected[k].impulse_ns));
    }
    EXPECT_EQ(tree.solver_messages(), 0);
  }
  EXPECT_GT(rubbed, 300);
}

}  // namespace
}  // namespace flinch::sim
