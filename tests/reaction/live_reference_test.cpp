// SPDX-License-Identifier: MIT
#include "reaction/live_reference.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/reaction/reaction_scenes.h"

namespace flinch::reaction {
namespace {

using motion::Body;

constexpr double kStep_s = 1.0 / 120;

TEST(LiveReference, IsContinuousAndItsVelocityMatchesItsPathAtAnyFrameRate) {
  const sim::FigureModel figure_model(motion::default_character());
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uneven(0.001, 0.03);
  for (const auto& [name, motion] : scenes::motions_by_rule(figure_model.skeleton)) {
    double frame_s = 0.1;  // of the motion; the reference's own time starts there
    const double begin_s = frame_s;
    LiveReference reference(figure_model, scenes::pose_at(motion, frame_s - 0.01),
                            scenes::pose_at(motion, frame_s), 0.01);
    double simulated_until_s = 0;
    sim::ReferenceState last = reference.at(simulated_until_s);
    while (frame_s < 0.6) {
      const double dt_s = uneven(generator);
      frame_s += dt_s;
      reference.add(scenes::pose_at(motion, frame_s), dt_s, simulated_until_s);
      const sim::ReferenceState same = reference.at(simulated_until_s);
      for (Body body : motion::kBodies) {
        EXPECT_LT((same.body[body].position - last.body[body].position).norm(), 1e-9) << name;
        EXPECT_LT(same.body[body].orientation.angularDistance(last.body[body].orientation), 1e-7);
        EXPECT_LT((same.socket[body] - last.socket[body]).norm(), 1e-9);
      }
      while (simulated_until_s < frame_s - begin_s) {
        const sim::ReferenceState next = reference.at(simulated_until_s + kStep_s);
        for (Body body : motion::kBodies) {
          const Eigen::Vector3d moved = next.body[body].position - last.body[body].position;
          EXPECT_LT((moved - kStep_s * next.body[body].velocity).norm(), 1e-9) << name;
        }
        simulated_until_s += kStep_s;
        last = next;
      }
      const auto wanted = sim::state_at_rest(figure_model.skeleton, figure_model.model,
                                             scenes::pose_at(motion, begin_s + simulated_until_s));
      for (Body body : motion::kBodies) {
        EXPECT_LT((last.body[body].position - wanted.body[body].position).norm(), 0.03) << name;
      }
    }
  }
}

}  // namespace
}  // namespace flinch::reaction
