// SPDX-License-Identifier: MIT
#include "sim/tree/tree_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <new>

#include "sim/ode/ode_scene.h"
#include "tests/sim/tree/random_step.h"

namespace flinch::sim {
namespace {

using motion::Body;

class TreeSceneTest : public testing::Test {
 protected:
  FigureModel figure_model_{motion::default_character()};

  /// Steps random figures with and without ODE.
  void expect_free_figures_match(const FigureModel& figure_model);

  /// Largest difference of a velocity after the step, divided by the largest velocity.
  double difference(const OdeScene& ode, const TreeScene& tree) {
    double most = 0;
    double greatest = 1;
    const motion::PerBody<BodyState> by_ode = ode.bodies();
    for (Body body : motion::kBodies) {
      const BodyState& expected = by_ode[body];
      const BodyState& found = tree.bodies()[body];
      most = std::max({most, (expected.velocity - found.velocity).norm(),
                       (expected.angular_velocity - found.angular_velocity).norm(),
                       (expected.position - found.position).norm(),
                       (expected.orientation.coeffs() - found.orientation.coeffs()).norm()});
      greatest = std::max({greatest, expected.velocity.norm(), expected.angular_velocity.norm()});
    }
    if (ode.flight()) {
      const Eigen::Vector3d expected = ode.flight()->velocity;
      most = std::max(most, (expected - tree.flight()->velocity).norm());
    }
    return most / greatest;
  }
};

void TreeSceneTest::expect_free_figures_match(const FigureModel& figure_model) {
  RandomStep random(figure_model, 1);
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
                              start.body[body].orientation * joint_offset(figure_model, body) -
                              parent_state.position);
      }
    }
    OdeScene ode(figure_model, start, nullptr, features::kGravity_mps2);
    TreeScene tree(figure_model, start.body, nullptr, features::kGravity_mps2);
    ode.step(target, step_s);
    tree.step(target, step_s);
    EXPECT_LT(difference(ode, tree), 1e-9) << "step " << i << " of " << step_s;
  }
}

TEST_F(TreeSceneTest, FreeFiguresMatchOde) {
  expect_free_figures_match(figure_model_);
}

TEST_F(TreeSceneTest, LimpAndWaistUpFiguresMatchOde) {
  const BodySet limp = set_of(Body::left_upper_arm) | set_of(Body::right_forearm);
  const motion::Physique character = motion::default_character();
  expect_free_figures_match(FigureModel(character, {.limp_joints = limp}));
  expect_free_figures_match(FigureModel(character, {.figure = FigureKind::waist_up}));
  expect_free_figures_match(
      FigureModel(character, {.figure = FigureKind::waist_up, .limp_joints = limp}));
}

/// The drives of a struck, a waiting and a falling figure, with weaker joints.
Drive random_drive(RandomStep& random, int number, const ReferenceState& from) {
  Drive drive;
  const double share = random.uniform(0.05, 1);
  drive.strength = {share, number % 5 ? share : 1e-4, random.uniform(10, 2000)};
  drive.is_falling = number % 3 == 0;
  if (!drive.is_falling) {
    drive.feedforward_from = &from;
    drive.foot_hold = number % 5 ? 1 : 1e-4;
  }
  return drive;
}

/// The reference with its feet at rest on the ground, or one of them.
ReferenceState standing(ReferenceState state, const ReferenceState& at_rest, bool on_both) {
  for (const Body foot : {Body::left_foot, Body::right_foot}) {
    if (on_both || foot == Body::left_foot) state.body[foot] = at_rest.body[foot];
  }
  return state;
}

TEST_F(TreeSceneTest, DrivenFiguresMatchOde) {
  RandomStep random(figure_model_, 3);
  const ReferenceState at_rest = state_at_rest(figure_model_.skeleton, figure_model_.model,
                                               scenes::standing(figure_model_.skeleton));
  int held = 0;
  for (int i = 0; i < 200; ++i) {
    const ReferenceState start = random.state(0.4);
    const ReferenceState from = random.state(0.4);
    const ReferenceState target = standing(random.state(0.4), at_rest, i % 2 == 0);
    const double step_s = i % 4 ? random.uniform(1e-4, 1.0 / 120) : 1.0 / 120;
    const Drive drive = random_drive(random, i, from);
    for (const bool foot : held_feet(figure_model_, target, drive)) held += foot ? 1 : 0;
    OdeScene ode(figure_model_, start, nullptr, features::kGravity_mps2);
    TreeScene tree(figure_model_, start, nullptr, features::kGravity_mps2);
    ode.step(target, step_s, drive);
    tree.step(target, step_s, drive);
    EXPECT_LT(difference(ode, tree), 1e-9) << "step " << i << " of " << step_s;
  }
  EXPECT_GT(held, 150);
}

// Falling figures lie in the ground with many parts.
TEST_F(TreeSceneTest, DrivenFiguresInContactMatchOde) {
  RandomStep random(figure_model_, 4);
  std::size_t most_supports = 0;
  for (int i = 0; i < 200; ++i) {
    ReferenceState start = random.state(0.4);
    const double depth_m = i % 3 ? 0.005 : random.uniform(0.6, 1.2);
    for (BodyState& body : start.body) body.position.z() -= depth_m;
    const ReferenceState from = random.state(0.4);
    const ReferenceState target = random.state(0.4);
    features::Ball thrown;
    thrown.position = {0.3, 0, 0.5};
    thrown.velocity = random.vector(20);
    thrown.mass_kg = random.uniform(0.05, 20);
    const Drive drive = random_drive(random, i, from);
    const double step_s = i % 2 ? 1.0 / 1000 : 1.0 / 120;
    OdeScene ode(figure_model_, start, &thrown, features::kGravity_mps2);
    TreeScene tree(figure_model_, start, &thrown, features::kGravity_mps2);
    std::size_t supports = 0;
    for_each_body(supported_bodies(drive), [&](Body body) {
      supports += support_of(figure_model_, body, start.body[body], target.body[body], drive,
                             held_feet(figure_model_, target, drive))
                      .count;
    });
    most_supports = std::max(most_supports, supports);
    const Eigen::Vector3d normal = random.vector(1).normalized();
    const motion::Clearance near{0, thrown.position - thrown.radius * normal, normal};
    const auto run = [&](auto& scene) {
      scene.add_hit(Body::right_thigh, near);
      scene.add_supports(target, step_s, drive);
      scene.step(target, step_s, drive);
    };
    run(ode);
    run(tree);
    EXPECT_LT(difference(ode, tree), 1e-6) << "step " << i;
  }
  EXPECT_GT(most_supports, 12U);
}

TEST_F(TreeSceneTest, ABallAloneMatchesOde) {
  RandomStep random(figure_model_, 5);
  const ReferenceState start = random.state(0.4);
  features::Ball thrown;
  thrown.position = {0.3, 0, thrown.radius};
  thrown.velocity = {6, 2, -4};
  OdeScene ode(figure_model_, start, &thrown, features::kGravity_mps2);
  TreeScene tree(figure_model_, start, &thrown, features::kGravity_mps2);
  for (int i = 0; i < 3; ++i) {
    const auto run = [&](auto& scene) {
      scene.clear_contacts();
      if (i == 0) scene.add_bounce();
      scene.step_ball(1.0 / 120);
    };
    run(ode);
    run(tree);
    EXPECT_LT((ode.flight()->position - tree.flight()->position).norm(), 1e-9);
    EXPECT_LT((ode.flight()->velocity - tree.flight()->velocity).norm(), 1e-9);
    EXPECT_EQ(tree.bodies()[Body::head].position, start.body[Body::head].position);
  }
  EXPECT_GT(tree.flight()->velocity.z(), 2);
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
      both([&](auto& scene) { scene.add_hit(hit, near); });
      ++rubbed;
    }
    if (i % 7 == 0) both([&](auto& scene) { scene.add_bounce(); });
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

// The joints have no inertia before the first step, so nothing may be multiplied by it.
TEST_F(TreeSceneTest, ABallAloneBouncesBeforeTheFirstStepWhateverWasInMemory) {
  alignas(TreeScene) std::array<std::byte, sizeof(TreeScene)> memory;
  memory.fill(std::byte{0xff});  // not-a-numbers
  features::Ball ball;
  ball.position = {2, 0, ball.radius};
  ball.velocity = {0, 0, -4};
  const ReferenceState start = state_at_rest(figure_model_.skeleton, figure_model_.model,
                                             scenes::standing(figure_model_.skeleton));
  auto* scene = new (memory.data()) TreeScene(figure_model_, start, &ball, 9.81);
  scene->clear_contacts();
  scene->add_bounce();
  scene->step_ball(0.001);
  EXPECT_NEAR(scene->flight()->velocity.z(), 0.7 * 4, 0.02);
  std::destroy_at(scene);
}

}  // namespace
}  // namespace flinch::sim
