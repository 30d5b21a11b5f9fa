// SPDX-License-Identifier: MIT
#include "reaction/reaction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <thread>

#include "tests/reaction/reaction_player.h"

namespace flinch::reaction {
namespace {

using motion::Role;
using scenes::advance;
using scenes::Blow;
using scenes::blows;
using scenes::distance;
using scenes::kFrame_s;
using scenes::plan;
using scenes::play;
using scenes::pose_at;
using scenes::same_bits;

TEST(Reaction, RepeatsBitForBitAlsoOnThreadsAtOnce) {
  const auto run = [&](std::vector<std::vector<motion::Pose>>& results) {
    Reaction reaction(plan());  // one for all: what it did before does not count
    for (std::size_t i = 0; i < 12; ++i) results.push_back(play(reaction, blows()[i], 0.5));
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
      EXPECT_TRUE(same_bits(alone[i], play(*std::make_unique<Reaction>(plan()), blows()[i], 0.5)));
    }
  }
}

TEST(Reaction, GoesOnOnAnotherThread) {
  const Blow& blow = blows().front();
  Reaction here(plan());
  const auto poses = play(here, blow, 0.4);
  Reaction there(plan());
  ASSERT_EQ(scenes::begin(there, blow), ReactionStatus::ok);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    std::thread([&] { advance(there, blow, static_cast<double>(k) * kFrame_s, kFrame_s); }).join();
    EXPECT_TRUE(same_bits(there.pose(), poses[k])) << k;
  }
}

TEST(Reaction, UnevenFramesGiveTheSameMotion) {
  std::mt19937 generator(7);
  std::vector<double> worst_m;
  for (const Blow& blow : blows()) {
    Reaction even(plan());
    const auto poses = play(even, blow, 0.8);
    Reaction uneven(plan());
    scenes::begin(uneven, blow);
    double since_s = 0;
    double worst = 0;
    for (std::size_t tenth = 1; tenth <= 8; ++tenth) {
      const double until_s = 0.1 * static_cast<double>(tenth);
      while (since_s < until_s - 1e-9) {
        double dt_s = std::uniform_real_distribution<double>(0.001, 0.05)(generator);
        if (since_s + dt_s > until_s - 1e-3) dt_s = until_s - since_s;
        since_s += dt_s;
        EXPECT_EQ(advance(uneven, blow, since_s, dt_s), ReactionStatus::ok);
      }
      worst = std::max(worst, distance(uneven.pose(), poses[6 * tenth]));
    }
    worst_m.push_back(worst);
  }
  std::sort(worst_m.begin(), worst_m.end());
  EXPECT_LT(worst_m[worst_m.size() / 2], 0.001);
  EXPECT_LT(worst_m.back(), 0.02);
}

TEST(Reaction, RefusesBadInputAndStaysUsable) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Blow& blow = blows().front();
  const motion::Pose good = pose_at(*blow.motion, blow.begin_s);
  motion::Pose no_place = good;
  no_place.root_position.x() = nan;
  motion::Pose no_turn = good;
  no_turn.rotation[Role::head].w() = nan;
  motion::Pose not_unit = good;
  not_unit.rotation[Role::head].coeffs() *= 2;
  std::vector<sim::Ball> bad_balls(6, blow.ball);
  bad_balls[0].position.x() = static_cast<double>(nan);
  bad_balls[1].velocity.z() = std::numeric_limits<double>::infinity();
  bad_balls[2].radius = 0;
  bad_balls[3].mass_kg = -1;
  bad_balls[4].mass_kg = static_cast<double>(nan);
  bad_balls[5].velocity.x() = 1e9;

  Reaction reaction(plan());
  EXPECT_EQ(reaction.advance(kFrame_s, good, good), ReactionStatus::not_begun);
  const auto try_all = [&] {
    for (double dt_s : {0.0, -1.0, 0.2, static_cast<double>(nan)}) {
      EXPECT_EQ(reaction.begin(good, good, dt_s, &blow.ball), ReactionStatus::bad_time);
    }
    for (const motion::Pose& bad : {no_place, no_turn, not_unit}) {
      EXPECT_EQ(reaction.begin(bad, good, kFrame_s, &blow.ball), ReactionStatus::bad_pose);
      EXPECT_EQ(reaction.begin(good, bad, kFrame_s, &blow.ball), ReactionStatus::bad_pose);
    }
    for (const sim::Ball& bad : bad_balls) {
      EXPECT_EQ(reaction.begin(good, good, kFrame_s, &bad), ReactionStatus::bad_ball);
    }
  };
  try_all();
  EXPECT_EQ(reaction.phase(), ReactionPhase::none);

  Reaction untroubled(plan());
  const auto poses = play(untroubled, blow, 0.3);
  ASSERT_EQ(scenes::begin(reaction, blow), ReactionStatus::ok);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    try_all();
    for (double dt_s : {0.0, -1.0, 0.2, static_cast<double>(nan)}) {
      EXPECT_EQ(reaction.advance(dt_s, good, good), ReactionStatus::bad_time);
    }
    for (const motion::Pose& bad : {no_place, no_turn, not_unit}) {
      EXPECT_EQ(reaction.advance(kFrame_s, bad, good), ReactionStatus::bad_pose);
      EXPECT_EQ(reaction.advance(kFrame_s, good, bad), ReactionStatus::bad_pose);
    }
    advance(reaction, blow, static_cast<double>(k) * kFrame_s, kFrame_s);
    EXPECT_TRUE(same_bits(reaction.pose(), poses[k]));
  }
  EXPECT_EQ(Reaction(nullptr).begin(good, good, kFrame_s, nullptr), ReactionStatus::bad_options);
  for (const ReactionOptions& bad :
       {ReactionOptions{.schedule = {.alone_s = 0}, .stiffness = 0.1},
        ReactionOptions{.schedule = {.alone_s = static_cast<double>(nan)}, .stiffness = 0.1},
        ReactionOptions{.schedule = {}, .stiffness = 0}}) {
    EXPECT_EQ(Reaction(plan(), bad).begin(good, good, kFrame_s, nullptr),
              ReactionStatus::bad_options);
  }
}

}  // namespace
}  // namespace flinch::reaction
