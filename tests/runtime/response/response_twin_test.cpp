// SPDX-License-Identifier: MIT
// What responses work out once, or only as far as needed, against the slow and obvious way.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "motion/interpolation.h"
#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response_pose.h"
#include "tests/motion/random_motion.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;
using motion::Side;

// Without the guard, which answers nothing.
const database::ClipLibrary& clips_as_authored() {
  static const database::ClipLibrary library = [] {
    database::ClipLibrary authored = database::authored_library(motion::default_character());
    authored.clips.pop_back();
    return authored;
  }();
  return library;
}

// The same motions with signs of rotations drawn at random.
const database::ClipLibrary& with_any_signs() {
  static const database::ClipLibrary library = [] {
    std::mt19937 random(1);
    database::ClipLibrary changed = clips_as_authored();
    for (motion::Clip& clip : changed.clips) {
      for (Pose& pose : clip.motion.poses) {
        for (Eigen::Quaternionf& rotation : pose.rotation) {
          if (random() % 2 == 0) rotation.coeffs() *= -1;
        }
      }
    }
    return changed;
  }();
  return library;
}

features::CharacterState random_state(std::mt19937& random) {
  return {tests::uniform(random, 0, 3),
          {tests::uniform(random, -2, 2), tests::uniform(random, -2, 2)},
          tests::uniform(random, -3, 3)};
}

// From idle, and every other one from a moment of another response.
Response random_response(const PreparedLibrary& library, std::mt19937& random, bool interrupts) {
  constexpr float kStep_s = 1.0F / 240;
  const auto draw = [&](const features::CharacterState& state, const Inertialization& origin) {
    const auto clip = static_cast<int>(1 + random() % (library.library->clips.size() - 1));
    return make_response(library, state, clip, tests::uniform(random, 0.1F, 1.2F), origin);
  };
  const Response first = draw(random_state(random), {});
  if (!interrupts) return first;
  const float at_s = tests::uniform(random, 2 * kStep_s, duration_s(first));
  const Pose before = pose_at(first, at_s - kStep_s);
  const Pose now = pose_at(first, at_s);
  const features::CharacterState state = rest_state_at(library, now, 0);
  return draw(state, make_inertialization(library, state, before, now, kStep_s));
}

Pose twin_into_clip(const Response& r, float t) {
  return motion::blend_along_initial_arc(source_pose_at(r, t), clip_pose_at(r, t),
                                         motion::minimum_jerk((t - r.begin_s) / r.blend_duration_s),
                                         source_pose_at(r, r.begin_s), clip_pose_at(r, r.begin_s));
}

Pose twin_back_to_idle(const Response& r, float t) {
  return motion::blend_along_initial_arc(clip_pose_at(r, t), return_pose_at(r, t),
                                         motion::minimum_jerk((t - r.end_s) / r.return_duration_s),
                                         clip_pose_at(r, r.end_s), return_pose_at(r, r.end_s));
}

bool is_of_leg(Role role) {
  return (role >= Role::left_thigh && role <= Role::left_foot) ||
         (role >= Role::right_thigh && role <= Role::right_foot);
}

void expect_same_above_the_legs(const Pose& pose, const Pose& twin) {
  for (Role role : motion::kRoles) {
    if (is_of_leg(role)) continue;
    ASSERT_EQ(pose.rotation[role].coeffs(), twin.rotation[role].coeffs()) << name_of(role);
  }
}

TEST(ResponseTwin, BlendsFromPosesAtTheStartWhateverTheSigns) {
  std::mt19937 random(2);
  for (const database::ClipLibrary* clips : {&clips_as_authored(), &with_any_signs()}) {
    const PreparedLibrary library = prepare(*clips);
    for (int i = 0; i < 400; ++i) {
      const Response r = random_response(library, random, i % 2 == 1);
      const float into_s = r.begin_s + tests::uniform(random, 0.01F, 0.99F) * r.blend_duration_s;
      expect_same_above_the_legs(pose_at(r, into_s), twin_into_clip(r, into_s));
      const float back_s = r.end_s + tests::uniform(random, 0.01F, 0.99F) * r.return_duration_s;
      expect_same_above_the_legs(pose_at(r, back_s), twin_back_to_idle(r, back_s));
    }
  }
}

TEST(ResponseTwin, IsTheSameMotionWhateverTheSigns) {
  std::mt19937 random(3);
  const PreparedLibrary library = prepare(clips_as_authored());
  const PreparedLibrary other = prepare(with_any_signs());
  for (int i = 0; i < 200; ++i) {
    const features::CharacterState state = random_state(random);
    const auto clip = static_cast<int>(random() % clips_as_authored().clips.size());
    const float impact_s = tests::uniform(random, 0.1F, 1.2F);
    const Response r = make_response(library, state, clip, impact_s);
    const Response same = make_response(other, state, clip, impact_s);
    for (int k = 0; k < 20; ++k) {
      const float t = tests::uniform(random, 0, duration_s(r) + 0.1F);
      EXPECT_LT(tests::distance(pose_at(r, t), pose_at(same, t)), 1e-5F);
    }
  }
}

TEST(ResponseTwin, RemembersByWhatFeetDifferWhenTheClipBegins) {
  std::mt19937 random(4);
  const PreparedLibrary library = prepare(clips_as_authored());
  for (int i = 0; i < 200; ++i) {
    const Response r = random_response(library, random, i % 2 == 1);
    for (Side side : motion::kSides) {
      const motion::FootPose from = source_foot_at(r, side, r.begin_s);
      const motion::FootPose clip = clip_foot_at(r, side, r.begin_s);
      const FootPlan& plan = r.feet[side];
      EXPECT_EQ(plan.rise, from.ankle - clip.ankle);
      EXPECT_EQ(plan.tilt.coeffs(), (from.orientation * clip.orientation.conjugate()).coeffs());
    }
  }
}

// Of whole poses, all joints and all ends that the blend may have.
float velocity_step_at(const Response& r, float time_s) {
  constexpr float kFrame_s = 1.0F / 60;
  const Pose before = pose_at(r, time_s - kFrame_s);
  const Pose at = pose_at(r, time_s);
  const Pose after = pose_at(r, time_s + kFrame_s);
  float most = 0;
  for (Role role : motion::kRoles) {
    const auto way = [role](const Pose& from, const Pose& to) {
      return motion::rotation_vector<float>(to.rotation[role] * from.rotation[role].conjugate());
    };
    most = std::max(most, (way(at, after) - way(before, at)).norm() / kFrame_s);
  }
  return most;
}

// The end is chosen with the shift of weight as it was before: responses without one show it.
TEST(ResponseTwin, EndsItsBlendWhereTheMotionIsCalmest) {
  std::mt19937 random(5);
  const PreparedLibrary library = prepare(clips_as_authored());
  std::array<int, 5> chosen{};
  for (int i = 0; i < 1000; ++i) {
    const Response r = random_response(library, random, i % 2 == 1);
    const bool has_time =
        r.peak_s - r.begin_s >= kMinBlend_s && r.end_s - r.begin_s > kMinBlend_s + 0.1F;
    if (!r.shifts[0].pelvis.isZero(0) || !has_time) continue;
    float least = std::numeric_limits<float>::infinity();
    Response calmest = r;
    std::size_t choice = 0;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      Response tried = r;
      tried.blend_duration_s = kMinBlend_s + static_cast<float>(k) * 0.02F;
      if (tried.blend_duration_s > r.peak_s - r.begin_s) break;
      const float step = velocity_step_at(tried, tried.begin_s + tried.blend_duration_s);
      if (step < least) {
        least = step;
        calmest = tried;
        choice = k;
      }
    }
    ++chosen[choice];
    EXPECT_EQ(r.blend_duration_s, calmest.blend_duration_s) << library.clip(r.clip).name;
  }
  EXPECT_GT(*std::ranges::min_element(chosen), 10);
}

}  // namespace
}  // namespace flinch::runtime
