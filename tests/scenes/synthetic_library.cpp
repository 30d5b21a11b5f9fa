// SPDX-License-Identifier: MIT
#include "tests/scenes/synthetic_library.h"

#include <cmath>
#include <numbers>
#include <string>

#include "motion/clip.h"
#include "motion/default_character.h"
#include "motion/interpolation.h"
#include "motion/limb_ik.h"
#include "motion/mirror.h"
#include "motion/rotation.h"

namespace flinch::scenes {
namespace {

// Returns a standing pose with the arms down.
motion::Pose standing_pose(const motion::Skeleton& skeleton) {
  constexpr float kDown = 75 * std::numbers::pi_v<float> / 180;
  motion::Pose pose = motion::rest_pose(skeleton);
  const Eigen::Vector3f forward = Eigen::Vector3f::UnitX();
  pose.rotation[motion::Role::left_upper_arm] = Eigen::AngleAxisf(-kDown, forward);
  pose.rotation[motion::Role::right_upper_arm] = Eigen::AngleAxisf(kDown, forward);
  return pose;
}

// Returns the pose with its pelvis moved and its feet where they were.
motion::Pose with_pelvis_moved(const motion::Skeleton& skeleton, const motion::Pose& pose,
                               const Eigen::Vector3f& by) {
  const motion::JointFrames feet = motion::forward_kinematics(skeleton, pose);
  motion::Pose moved = pose;
  moved.root_position += by;
  moved = motion::with_limb_end(skeleton, moved, motion::Limb::left_leg,
                                feet.position[motion::Role::left_foot],
                                feet.orientation[motion::Role::left_foot]);
  return motion::with_limb_end(skeleton, moved, motion::Limb::right_leg,
                               feet.position[motion::Role::right_foot],
                               feet.orientation[motion::Role::right_foot]);
}

// Returns a motion from standing to `peak` in half a second, and back.
motion::Motion there_and_back(const motion::Pose& standing, const motion::Pose& peak) {
  motion::Motion motion;
  for (int k = 0; k <= 60; ++k) {
    const float towards = k <= 30 ? static_cast<float>(k) / 30 : static_cast<float>(60 - k) / 30;
    motion.poses.push_back(motion::blend(standing, peak, motion::ease_in_ease_out(towards)));
  }
  return motion;
}

motion::Clip make_clip(const std::string& name, motion::Target target, float direction_degrees,
                       const motion::Motion& motion) {
  motion::Clip clip;
  clip.name = name;
  clip.kind = name.substr(0, name.find('_'));
  clip.source = "posed by rule";
  clip.annotation = motion::Annotation{target,
                                       direction_degrees * std::numbers::pi_v<float> / 180,
                                       motion::Degree::exaggerated,
                                       0,
                                       0.5F,
                                       1};
  clip.motion = motion;
  return clip;
}

motion::Motion swaying(const motion::Skeleton& skeleton, const motion::Pose& standing) {
  motion::Motion motion;
  for (int k = 0; k <= 120; ++k) {
    const float phase = static_cast<float>(k) / 120 * std::numbers::pi_v<float>;
    motion.poses.push_back(
        with_pelvis_moved(skeleton, standing, {0, 0.02F * std::sin(phase), -0.01F}));
  }
  return motion;
}

}  // namespace

database::ClipLibrary synthetic_library() {
  using motion::Role;
  database::ClipLibrary library;
  library.name = "synthetic";
  library.character = motion::default_character();
  const motion::Skeleton& skeleton = library.character.skeleton;
  const motion::Pose standing = standing_pose(skeleton);
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f left = Eigen::Vector3f::UnitY();

  motion::Clip idle;
  idle.name = "idle";
  idle.purpose = motion::Purpose::idle;
  idle.source = "posed by rule";
  idle.motion = swaying(skeleton, standing);
  library.clips.push_back(idle);

  motion::Pose raised = standing;
  raised.rotation[Role::left_upper_arm] =
      motion::rotation_between<float>(left, Eigen::Vector3f(0.8F, 0.1F, 0.5F));
  raised.rotation[Role::right_upper_arm] =
      motion::rotation_between<float>(-left, Eigen::Vector3f(0.8F, -0.1F, 0.5F));
  library.clips.push_back(
      make_clip("raise_hands", motion::Target::head, 0, there_and_back(standing, raised)));

  motion::Pose ducked = with_pelvis_moved(skeleton, standing, {-0.05F, 0, -0.35F});
  ducked.rotation[Role::abdomen] = Eigen::AngleAxisf(0.7F, left);
  library.clips.push_back(
      make_clip("duck", motion::Target::head, 45, there_and_back(standing, ducked)));

  motion::Pose turned = standing;
  turned.rotation[Role::abdomen] = Eigen::AngleAxisf(-0.6F, up);
  turned.rotation[Role::chest] = Eigen::AngleAxisf(-0.6F, up);
  library.clips.push_back(
      make_clip("turn_shoulder", motion::Target::trunk, 90, there_and_back(standing, turned)));

  motion::Pose aside = standing;
  aside.root_position.y() -= 0.4F;
  library.clips.push_back(
      make_clip("step_aside", motion::Target::pelvis, 90, there_and_back(standing, aside)));

  motion::Pose lifted = standing;
  lifted.rotation[Role::left_thigh] = Eigen::AngleAxisf(-1.3F, left);
  lifted.rotation[Role::left_shin] = Eigen::AngleAxisf(1.3F, left);
  library.clips.push_back(
      make_clip("lift_leg", motion::Target::legs, 45, there_and_back(standing, lifted)));

  const std::size_t posed = library.clips.size();
  for (std::size_t i = 2; i < posed; ++i)
    library.clips.push_back(motion::mirrored(library.clips[i]));
  return library;
}

}  // namespace flinch::scenes
