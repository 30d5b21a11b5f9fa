// SPDX-License-Identifier: MIT
#include "train/simulate/shared_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "tests/scenes/synthetic_library.h"
#include "tests/scenes/walk.h"
#include "train/simulate/trial.h"

namespace flinch::train {
namespace {

/// The default library, and its SharedResponses.
class SharedResponse : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    library_ = new database::ClipLibrary(database::authored_library(motion::default_character()));
    prepared_ = new runtime::PreparedLibrary(runtime::prepare(*library_));
    shared_ = new SharedResponses(*prepared_, kDistribution);
  }
  static void TearDownTestSuite() {
    delete shared_;
    delete prepared_;
    delete library_;
  }

  static runtime::Response response(int clip, GridCell cell) {
    return runtime::make_response(*prepared_,
                                  character_state_at(kDistribution, stance_loops(*library_), cell),
                                  clip, time_to_impact_s(kDistribution, cell.time));
  }

  /// Largest distance of a joint between the two, both relative to the impact, from when the first
  /// starts until the second has long ended, m.
  static float apart(const runtime::Response& early, float early_s, const runtime::Response& late,
                     float late_s) {
    float most = 0;
    for (float t = -std::min(early_s, late_s); t < 1.5F; t += 0.037F) {
      const auto a =
          motion::forward_kinematics(prepared_->skeleton(), runtime::pose_at(early, early_s + t));
      const auto b =
          motion::forward_kinematics(prepared_->skeleton(), runtime::pose_at(late, late_s + t));
      for (const motion::Role role : motion::kRoles)
        most = std::max(most, (a.position[role] - b.position[role]).norm());
    }
    return most;
  }

  static inline const ScenarioDistribution kDistribution;
  static inline const database::ClipLibrary* library_ = nullptr;
  static inline const runtime::PreparedLibrary* prepared_ = nullptr;
  static inline const SharedResponses* shared_ = nullptr;
};

TEST_F(SharedResponse, IsTheSameMotionSeenFromTheImpact) {
  int compared = 0;
  for (int clip = 0; clip < static_cast<int>(library_->clips.size()); ++clip) {
    for (int time = 0; time < time_to_impact_count(kDistribution); ++time) {
      const GridCell cell{(clip + time) % 4, time};  // each state for each clip, not for each time
      const runtime::Response own = response(clip, cell);
      if (!runtime::is_valid(own)) continue;
      const ResponseKey key = shared_->key_of(clip, cell);
      ASSERT_LE(key.cell.time, time);
      if (key.cell.time == time) continue;
      EXPECT_LT(apart(response(clip, key.cell), time_to_impact_s(kDistribution, key.cell.time), own,
                      time_to_impact_s(kDistribution, time)),
                2e-4F)
          << library_->clip(clip).name << ", time " << time;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(SharedResponseOfWalkers, IsTheSameMotionSeenFromTheImpact) {
  const database::ClipLibrary library =
      tests::with_walk(database::authored_library(motion::default_character()));
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  ScenarioDistribution distribution;
  distribution.stances = {{2, "walk", 1}};
  const SharedResponses shared(prepared, distribution);
  const std::vector<motion::Loop> loops = stance_loops(library);
  const auto response = [&](int clip, GridCell cell) {
    return runtime::make_response(prepared, character_state_at(distribution, loops, cell), clip,
                                  time_to_impact_s(distribution, cell.time));
  };
  int compared = 0;
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    for (const int time : {9, 14, 19}) {
      const GridCell cell{(clip + time) % state_count(distribution), time};
      const runtime::Response own = response(clip, cell);
      if (!runtime::is_valid(own)) continue;
      const ResponseKey key = shared.key_of(clip, cell);
      if (key.cell.time == time) continue;
      const runtime::Response early = response(clip, key.cell);
      const float early_s = time_to_impact_s(distribution, key.cell.time);
      const float late_s = time_to_impact_s(distribution, time);
      for (float t = -early_s; t < 1.5F; t += 0.07F) {
        const motion::JointFrames a =
            motion::forward_kinematics(prepared.skeleton(), runtime::pose_at(early, early_s + t));
        const motion::JointFrames b =
            motion::forward_kinematics(prepared.skeleton(), runtime::pose_at(own, late_s + t));
        for (const motion::Role role : motion::kRoles)
          ASSERT_LT((a.position[role] - b.position[role]).norm(), 2e-3F)
              << library.clip(clip).name << ", time " << time << ", at " << t;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST_F(SharedResponse, IsNoLongerSharedWhereThereIsLessTime) {
  int rushed = 0;
  for (int clip = 0; clip < static_cast<int>(library_->clips.size()); ++clip) {
    const int last = time_to_impact_count(kDistribution) - 1;
    const ResponseKey key = shared_->key_of(clip, {0, last});
    if (key.cell.time < 1) continue;
    const GridCell sooner{0, key.cell.time - 1};
    EXPECT_GT(apart(response(clip, sooner), time_to_impact_s(kDistribution, sooner.time),
                    response(clip, key.cell), time_to_impact_s(kDistribution, key.cell.time)),
              2e-4F)
        << library_->clip(clip).name;
    ++rushed;
  }
  EXPECT_GT(rushed, 50);
}

TEST_F(SharedResponse, OfTheIdleClipIsOneForAllTimes) {
  for (int time = 0; time < time_to_impact_count(kDistribution); ++time)
    EXPECT_EQ(shared_->key_of(library_->idle, {2, time}), (ResponseKey{library_->idle, {2, 0}}));
}

TEST_F(SharedResponse, ThereAreFarFewerThanGridCells) {
  const std::size_t places =
      library_->clips.size() * 4 * static_cast<std::size_t>(time_to_impact_count(kDistribution));
  EXPECT_LT(shared_->count(), places / 2);
  EXPECT_GT(shared_->count(), 4 * library_->clips.size());
  RecordProperty("responses", static_cast<int>(shared_->count()));
}

}  // namespace
}  // namespace flinch::train
