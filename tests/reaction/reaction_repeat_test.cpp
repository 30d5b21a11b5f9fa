// SPDX-License-Identifier: MIT
#include "reaction/reaction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>

#include "tests/reaction/reaction_player.h"
#include "tests/scenes/not_finite.h"

namespace flinch::reaction {
namespace {

using motion::Role;
using scenes::advance;
using scenes::cases;
using scenes::distance;
using scenes::figure_model;
using scenes::kFrame_s;
using scenes::play;
using scenes::pose_at;
using scenes::ReactionCase;
using scenes::same_bits;

TEST(Reaction, IsDeterministicOnConcurrentThreads) {
  const auto run = [&](std::vector<std::vector<motion::Pose>>& results) {
    Reaction reaction(figure_model());  // reused for all cases: earlier reactions must not matter
    for (std::size_t i = 0; i < 12; ++i) results.push_back(play(reaction, cases()[i], 0.5));
  };
  std::vector<std::vector<motion::Pose>> alone;
  run(alone);
  std::array<std::vector<std::vector<motion::Pose>>, 3> together;
  std::vector<std::thread> threads;
  for (auto& results : together) threads.emplace_back([&] { run(results); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& results : together) {
    for (std::size_t i = 0; i < alone.size(); ++i) {
      EXPECT_TRUE(same_bits(alone[i], results[i])) << i;
      EXPECT_TRUE(
          same_bits(alone[i], play(*std::make_unique<Reaction>(figure_model()), cases()[i], 0.5)));
    }
  }
}

TEST(Reaction, CanMoveToAnotherThread) {
  const ReactionCase& reaction_case = cases().front();
  Reaction here(figure_model());
  const auto poses = play(here, reaction_case, 0.4);
  Reaction there(figure_model());
  ASSERT_EQ(scenes::begin(there, reaction_case), ReactionStatus::ok);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    std::thread([&] {
      advance(there, reaction_case, static_cast<double>(k) * kFrame_s, kFrame_s);
    }).join();
    EXPECT_TRUE(same_bits(there.pose(), poses[k])) << k;
  }
}

TEST(Reaction, MotionDoesNotDependOnFrameTimes) {
  std::mt19937 generator(7);
  std::vector<double> worst_m;
  for (const ReactionCase& reaction_case : cases()) {
    Reaction even(figure_model());
    const auto poses = play(even, reaction_case, 0.8);
    Reaction uneven(figure_model());
    scenes::begin(uneven, reaction_case);
    double since_s = 0;
    double worst = 0;
    for (std::size_t tenth = 1; tenth <= 8; ++tenth) {
      const double until_s = 0.1 * static_cast<double>(tenth);
      while (since_s < until_s - 1e-9) {
        double dt_s = std::uniform_real_distribution<double>(0.001, 0.05)(generator);
        if (since_s + dt_s > until_s - 1e-3) dt_s = until_s - since_s;
        since_s += dt_s;
        EXPECT_EQ(advance(uneven, reaction_case, since_s, dt_s), ReactionStatus::ok);
      }
      worst = std::max(worst, distance(uneven.pose(), poses[6 * tenth]));
    }
    worst_m.push_back(worst);
  }
  std::sort(worst_m.begin(), worst_m.end());
  EXPECT_LT(worst_m[worst_m.size() / 2], 0.001);
  EXPECT_LT(worst_m.back(), 0.02);
}

TEST(Reaction, RejectsBadInputAndStaysUsable) {
  const ReactionCase& reaction_case = cases().front();
  const motion::Pose good = pose_at(*reaction_case.motion, reaction_case.begin_s);
  motion::Pose no_place = good;
  no_place.root_position.x() = tests::kNan;
  motion::Pose no_turn = good;
  no_turn.rotation[Role::head].w() = tests::kNan;
  motion::Pose not_unit = good;
  not_unit.rotation[Role::head].coeffs() *= 2;
  std::vector<features::Ball> bad_balls(6, reaction_case.ball);
  bad_balls[0].position.x() = tests::kNanDouble;
  bad_balls[1].velocity.z() = tests::kInfinityDouble;
  bad_balls[2].radius = 0;
  bad_balls[3].mass_kg = -1;
  bad_balls[4].mass_kg = tests::kNanDouble;
  bad_balls[5].velocity.x() = 1e9;

  Reaction reaction(figure_model());
  EXPECT_EQ(reaction.advance(kFrame_s, good, good), ReactionStatus::not_begun);
  const auto try_all = [&] {
    for (double dt_s : {0.0, -1.0, 0.2, tests::kNanDouble}) {
      EXPECT_EQ(reaction.begin(good, good, dt_s, &reaction_case.ball), ReactionStatus::bad_time);
    }
    for (const motion::Pose& bad : {no_place, no_turn, not_unit}) {
      EXPECT_EQ(reaction.begin(bad, good, kFrame_s, &reaction_case.ball), ReactionStatus::bad_pose);
      EXPECT_EQ(reaction.begin(good, bad, kFrame_s, &reaction_case.ball), ReactionStatus::bad_pose);
    }
    for (const features::Ball& bad : bad_balls) {
      EXPECT_EQ(reaction.begin(good, good, kFrame_s, &bad), ReactionStatus::bad_ball);
    }
  };
  try_all();
  EXPECT_EQ(reaction.phase(), ReactionPhase::none);

  Reaction untroubled(figure_model());
  const auto poses = play(untroubled, reaction_case, 0.3);
  ASSERT_EQ(scenes::begin(reaction, reaction_case), ReactionStatus::ok);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    try_all();
    for (double dt_s : {0.0, -1.0, 0.2, tests::kNanDouble}) {
      EXPECT_EQ(reaction.advance(dt_s, good, good), ReactionStatus::bad_time);
    }
    for (const motion::Pose& bad : {no_place, no_turn, not_unit}) {
      EXPECT_EQ(reaction.advance(kFrame_s, bad, good), ReactionStatus::bad_pose);
      EXPECT_EQ(reaction.advance(kFrame_s, good, bad), ReactionStatus::bad_pose);
    }
    advance(reaction, reaction_case, static_cast<double>(k) * kFrame_s, kFrame_s);
    EXPECT_TRUE(same_bits(reaction.pose(), poses[k]));
  }
  EXPECT_EQ(Reaction(nullptr).begin(good, good, kFrame_s, nullptr), ReactionStatus::bad_options);
  for (const ReactionOptions& bad :
       {ReactionOptions{.schedule = {.simulation_only_s = 0}, .stiffness = 0.1},
        ReactionOptions{.schedule = {.simulation_only_s = tests::kNanDouble}, .stiffness = 0.1},
        ReactionOptions{.schedule = {}, .stiffness = 0}}) {
    EXPECT_EQ(Reaction(figure_model(), bad).begin(good, good, kFrame_s, nullptr),
              ReactionStatus::bad_options);
  }
}

}  // namespace
}  // namespace flinch::reaction
