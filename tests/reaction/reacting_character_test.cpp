// SPDX-License-Identifier: MIT
#include "reaction/reacting_character.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/interpolation.h"
#include "motion/rotation.h"
#include "tests/reaction/reaction_player.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/runtime/push/push_scene.h"
#include "tests/scenes/not_finite.h"

namespace flinch::reaction {
namespace {

using motion::Role;
using scenes::same_bits;
using tests::kNan;

constexpr float kFrame_s = 1.0F / 60;
constexpr float kImpact_s = 0.6F;

constexpr int kClip = 1;

runtime::Library loaded(const database::ClipLibrary& clips, float realism) {
  tests::MadeUpSelector made = tests::made_up_selector(clips, 60, tests::ModelKind::knn);
  made.selector.realism = tests::constant_realism(realism);
  const std::string file = made.file();
  runtime::Library library;
  EXPECT_EQ(library.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  return library;
}

const runtime::Library& plain() {
  static const runtime::Library library = loaded(tests::made_up_library(5, 120), 0.9F);
  return library;
}
/// Any response to a push counts as good.
const runtime::Library& with_pushes() {
  static const runtime::Library library = loaded(tests::library_with_pushes(), 0.9F);
  return library;
}
/// None does.
const runtime::Library& with_bad_pushes() {
  static const runtime::Library library = loaded(tests::library_with_pushes(), 0.4F);
  return library;
}

constexpr double kHeavy_kg =
    2;  // a ball whose blow moves the body at about half a metre per second

/// A ball that hits the middle of the displayed chest in 0.05 s.
features::Ball ball_at_chest(const runtime::Library& library, const motion::Pose& pose,
                             double mass_kg) {
  const motion::Skeleton& skeleton = library.clip_library().character.skeleton;
  const Eigen::Vector3f chest = forward_kinematics(skeleton, pose).position[Role::chest];
  features::Ball ball = scenes::aimed_ball(chest.cast<double>(), {-14, 2, 0}, 0.05);
  ball.mass_kg = mass_kg;
  return ball;
}

struct Played {
  std::vector<motion::Pose> poses;
  std::vector<PoseSource> pose_sources;
};

/// Plays `duration_s` of a response that is hit at its peak.
Played play(ReactingCharacter& character, const runtime::Library& library, float duration_s,
            double mass_kg = 0.27) {
  EXPECT_EQ(character.character().respond(kClip, kImpact_s), runtime::Status::ok);
  Played played;
  bool met = false;
  for (float time_s = 0; time_s < duration_s; time_s += kFrame_s) {
    if (!met && time_s > kImpact_s) {
      EXPECT_EQ(character.react_to(ball_at_chest(library, character.pose(), mass_kg)),
                ReactionStatus::ok);
      met = true;
    }
    EXPECT_EQ(character.update(kFrame_s), ReactionStatus::ok);
    played.poses.push_back(character.pose());
    played.pose_sources.push_back(character.pose_source());
  }
  return played;
}

TEST(ReactingCharacter, MatchesTheRunTimeBeforeAndAfterTheReaction) {
  ReactingCharacter hit(plain(), make_reaction_data(plain()));
  const Played played = play(hit, plain(), 5);
  runtime::Character twin(plain());
  twin.respond(kClip, kImpact_s);
  int alike = 0;
  int physical = 0;
  for (std::size_t k = 0; k < played.poses.size(); ++k) {
    twin.update(kFrame_s);
    if (played.pose_sources[k] == PoseSource::character) {
      EXPECT_TRUE(same_bits(played.poses[k], twin.pose())) << "frame " << k;
      ++alike;
    } else {
      ++physical;
    }
  }
  EXPECT_TRUE(std::isfinite(hit.reaction().contact_s()));
  EXPECT_EQ(hit.reaction().phase(), ReactionPhase::over);
  EXPECT_GT(alike, 200);
  EXPECT_GT(physical, 40);
  EXPECT_EQ(hit.pose_source(), PoseSource::character);
  EXPECT_EQ(hit.character().phase(), runtime::Phase::idle);
}

TEST(ReactingCharacter, ContinuesWithAResponseAndThenIdles) {
  ReactingCharacter hit(with_pushes(), make_reaction_data(with_pushes()));
  const Played played = play(hit, with_pushes(), 7, kHeavy_kg);
  const auto first = std::ranges::find(played.pose_sources, PoseSource::reaction_clip);
  ASSERT_NE(first, played.pose_sources.end());
  EXPECT_EQ(*(first - 1), PoseSource::physics);
  const auto last = std::find_if(first, played.pose_sources.end(), [](PoseSource mover) {
    return mover != PoseSource::reaction_clip;
  });
  ASSERT_NE(last, played.pose_sources.end());
  EXPECT_EQ(*last, PoseSource::character);
  EXPECT_FALSE(hit.reaction_clip());
  EXPECT_EQ(hit.character().phase(), runtime::Phase::idle);
}

/// The velocity that the ball has given to the whole body.
Eigen::Vector3f blow_of(const ReactingCharacter& hit, const runtime::Library& library) {
  const double mass_kg = static_cast<double>(library.clip_library().character.mass_kg);
  const Eigen::Vector3d velocity = hit.reaction().ball_momentum() / mass_kg;
  return {static_cast<float>(velocity.x()), static_cast<float>(velocity.y()), 0};
}

TEST(ReactingCharacter, AnswersABlowAsAPushOfTheSamePlaceAndVelocityIsAnswered) {
  const runtime::Library& library = with_pushes();
  runtime::Workspace workspace;
  workspace.reserve_memory(library.selection_bytes());
  ReactingCharacter hit(library, make_reaction_data(library));
  hit.character().respond(kClip, kImpact_s);
  for (float time_s = 0; time_s < kImpact_s; time_s += kFrame_s) hit.update(kFrame_s);
  ASSERT_EQ(hit.react_to(ball_at_chest(library, hit.pose(), kHeavy_kg)), ReactionStatus::ok);
  motion::Pose before = hit.pose();
  while (hit.reaction().phase() != ReactionPhase::recovering) {
    before = hit.pose();
    ASSERT_EQ(hit.update(kFrame_s), ReactionStatus::ok);
  }
  runtime::Character twin = hit.character();
  ASSERT_EQ(twin.move_to(before, hit.pose(), kFrame_s), runtime::Status::ok);
  ASSERT_EQ(twin.push(Role::chest, blow_of(hit, library), workspace), runtime::Status::ok);
  EXPECT_EQ(hit.reaction_clip(), twin.clip());
  int alike = 0;
  for (int frame = 0; frame < 240; ++frame) {
    hit.update(kFrame_s);
    twin.update(kFrame_s);
    if (hit.pose_source() == PoseSource::physics) continue;
    EXPECT_TRUE(same_bits(hit.pose(), twin.pose())) << "frame " << frame;
    ++alike;
  }
  EXPECT_GT(alike, 180);
}

TEST(ReactingCharacter, NoResponseContinuesABlowIfNoneWouldLookReal) {
  ReactingCharacter hit(with_bad_pushes(), make_reaction_data(with_bad_pushes()));
  const Played played = play(hit, with_bad_pushes(), 3, kHeavy_kg);
  EXPECT_TRUE(std::isfinite(hit.reaction().contact_s()));
  EXPECT_EQ(std::ranges::count(played.pose_sources, PoseSource::reaction_clip), 0);
  EXPECT_EQ(hit.reaction().phase(), ReactionPhase::over);
}

TEST(ReactingCharacter, NoResponseContinuesABlowWhereTheCallerWantsNone) {
  auto data = *make_reaction_data(with_pushes());
  data.continues_by_clips = false;
  ReactingCharacter hit(with_pushes(), std::make_shared<const ReactionData>(data));
  const Played played = play(hit, with_pushes(), 3, kHeavy_kg);
  EXPECT_EQ(std::ranges::count(played.pose_sources, PoseSource::reaction_clip), 0);
}

// The body moves as in the first of these tests, where a response continues it; but the ball passes
// 2 m away.
TEST(ReactingCharacter, NoResponseContinuesAMotionThatNothingHit) {
  ReactingCharacter missed(with_pushes(), make_reaction_data(with_pushes()));
  ASSERT_EQ(missed.character().respond(kClip, kImpact_s), runtime::Status::ok);
  bool met = false;
  for (float time_s = 0; time_s < 3; time_s += kFrame_s) {
    if (!met && time_s > kImpact_s) {
      features::Ball ball = ball_at_chest(with_pushes(), missed.pose(), kHeavy_kg);
      ball.position.y() += 2;
      ASSERT_EQ(missed.react_to(ball), ReactionStatus::ok);
      met = true;
    }
    ASSERT_EQ(missed.update(kFrame_s), ReactionStatus::ok);
    ASSERT_FALSE(missed.reaction_clip());
  }
  EXPECT_EQ(missed.reaction().phase(), ReactionPhase::over);
  EXPECT_EQ(missed.reaction().contact_s(), tests::kInfinityDouble);
  EXPECT_EQ(missed.pose_source(), PoseSource::character);
}

TEST(ReactingCharacter, ABlowPushesAtItsBodyOrNextToItButNotByTheLegs) {
  using motion::Body;
  for (const Body body : motion::kBodies) {
    const auto place = push_place_of(body);
    const bool is_leg = motion::target_of(body) == motion::Target::legs;
    EXPECT_EQ(place.has_value(), !is_leg) << static_cast<int>(body);
    if (place) {
      EXPECT_TRUE(motion::is_push_place(*place));
    }
  }
  EXPECT_EQ(push_place_of(Body::left_hand), Role::left_upper_arm);
  EXPECT_EQ(push_place_of(Body::right_forearm), Role::right_upper_arm);
  EXPECT_EQ(push_place_of(Body::head), Role::head);
  EXPECT_EQ(push_place_of(Body::abdomen), Role::chest);
}

/// Largest change of a joint's velocity between frames, rad/s.
float velocity_step(const std::vector<motion::Pose>& poses, std::size_t k) {
  const auto way = [&](std::size_t from, Role role) {
    return motion::rotation_vector<float>(poses[from + 1].rotation[role] *
                                          poses[from].rotation[role].conjugate());
  };
  float most = 0;
  for (Role role : motion::kRoles) {
    most = std::max(most, (way(k, role) - way(k - 1, role)).norm() / kFrame_s);
  }
  return most;
}

TEST(ReactingCharacter, PoseIsContinuousWhenItsSourceChanges) {
  for (const runtime::Library* library : {&plain(), &with_pushes()}) {
    ReactingCharacter hit(*library, make_reaction_data(*library));
    const Played played = play(hit, *library, 7, library == &plain() ? 0.27 : kHeavy_kg);
    int changes = 0;
    for (std::size_t k = 2; k + 1 < played.poses.size(); ++k) {
      if (played.pose_sources[k] == played.pose_sources[k - 1]) continue;
      ++changes;
      // When a spring of 10 1/s releases a joint that is a radian off, the joint's velocity changes
      // by 1.7 rad/s in a frame; a jump of 3 degrees in one frame would change it by 3.
      for (std::size_t frame : {k - 1, k}) {
        EXPECT_LT(velocity_step(played.poses, frame), 2.5F) << "frame " << frame;
      }
    }
    EXPECT_EQ(changes, library == &plain() ? 2 : 3);
  }
}

TEST(ReactingCharacter, StaysSimulatedAfterBeingKnockedOverUntilStopped) {
  ReactingCharacter hit(plain(), make_reaction_data(plain()));
  play(hit, plain(), 3, 40);
  ASSERT_EQ(hit.reaction().phase(), ReactionPhase::knocked_over);
  EXPECT_EQ(hit.pose_source(), PoseSource::physics);
  hit.character().place({2, 1}, 0.5F, 0);
  hit.stop();
  EXPECT_EQ(hit.pose_source(), PoseSource::character);
  EXPECT_TRUE(same_bits(hit.pose(), hit.character().pose()));
  EXPECT_EQ(hit.update(kFrame_s), ReactionStatus::ok);
}

TEST(ReactingCharacter, RejectsBadInputAndStaysUsable) {
  ReactingCharacter hit(plain(), make_reaction_data(plain()));
  ReactingCharacter untroubled(plain(), make_reaction_data(plain()));
  const Played played = play(untroubled, plain(), 2);
  ASSERT_EQ(hit.character().respond(kClip, kImpact_s), runtime::Status::ok);
  bool met = false;
  std::size_t k = 0;
  for (float time_s = 0; time_s < 2; time_s += kFrame_s) {
    for (float dt_s : {0.0F, -1.0F, kNan}) EXPECT_EQ(hit.update(dt_s), ReactionStatus::bad_time);
    features::Ball bad = ball_at_chest(plain(), hit.pose(), 0.27);
    bad.velocity.x() = tests::kNanDouble;
    EXPECT_EQ(hit.react_to(bad), ReactionStatus::bad_ball);
    if (hit.pose_source() == PoseSource::physics) {
      EXPECT_EQ(hit.update(0.2F), ReactionStatus::bad_time);
    }
    if (!met && time_s > kImpact_s) {
      hit.react_to(ball_at_chest(plain(), hit.pose(), 0.27));
      met = true;
    }
    EXPECT_EQ(hit.update(kFrame_s), ReactionStatus::ok);
    EXPECT_TRUE(same_bits(hit.pose(), played.poses[k++]));
  }
  ReactingCharacter bare(plain(), nullptr);
  EXPECT_EQ(bare.react_to(ball_at_chest(plain(), bare.pose(), 0.27)), ReactionStatus::bad_options);
  EXPECT_EQ(bare.update(kFrame_s), ReactionStatus::ok);
  EXPECT_EQ(make_reaction_data(runtime::Library()), nullptr);
}

}  // namespace
}  // namespace flinch::reaction
