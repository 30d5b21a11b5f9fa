// SPDX-License-Identifier: MIT
#include "reaction/live_reference.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/reaction/reaction_scenes.h"

namespace flinch::reaction {
namespace {

using motion::Body;

constexpr double kStep_s = 1.0 / 120;

TEST(LiveReference, NeverJumpsAndHasTheVelocityOfItsPathWhateverTheFrames) {
  const sim::FigurePlan plan(motion::default_character());
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uneven(0.001, 0.03);
  for (const auto& [name, motion] : scenes::motions_by_rule(plan.skeleton)) {
    double frame_s = 0.1;  // of the motion; the reference's own time begins there
    const double begin_s = frame_s;
    LiveReference reference(plan, scenes::pose_at(motion, frame_s - 0.01),
                            scenes::pose_at(motion, frame_s), 0.01);
    double reached_s = 0;
    sim::ReferenceState last = reference.at(reached_s);
    while (frame_s < 0.6) {
      const double dt_s = uneven(generator);
      frame_s += dt_s;
      reference.add(scenes::pose_at(motion, frame_s), dt_s, reached_s);
      const sim::ReferenceState same = reference.at(reached_s);
      for (Body body : motion::kBodies) {
        EXPECT_LT((same.body[body].position - last.body[body].position).norm(), 1e-9) << name;
        EXPECT_LT(same.body[body].orientation.angularDistance(last.body[body].orientation), 1e-7);
        EXPECT_LT((same.socket[body] - last.socket[body]).norm(), 1e-9);
      }
      while (reached_s < frame_s - begin_s) {
        const sim::ReferenceState next = reference.at(reached_s + kStep_s);
        for (Body body : motion::kBodies) {
          const Eigen::Vector3d moved = next.body[body].position - last.body[body].position;
          EXPECT_LT((moved - kStep_s * next.body[body].velocity).norm(), 1e-9) << name;
        }
        reached_s += kStep_s;
        last = next;
      }
      const auto wanted = sim::state_at_rest(plan.skeleton, plan.model,
                                             scenes::pose_at(motion, begin_s + reached_s));
      for (Body body : motion::kBodies) {
        EXPECT_LT((last.body[body].position - wanted.body[body].position).norm(), 0.03) << name;
      }
    }
  }
}

}  // namespace
}  // namespace flinch::reaction
