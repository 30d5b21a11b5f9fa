// SPDX-License-Identifier: MIT
#include "tests/runtime/push/push_scene.h"

#include <cmath>
#include <numbers>
#include <random>

#include "motion/interpolation.h"
#include "motion/limb_ik.h"
#include "motion/mirror.h"
#include "motion/push_measurement.h"
#include "motion/rotation.h"
#include "runtime/push/body_configuration.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/synthetic_library.h"

namespace flinch::tests {
namespace {

using motion::Role;

constexpr float kContact_s = 0.4F;

/// How far along a minimum-jerk movement from `begin_s` to `end_s` is at `time_s`.
float progress(float time_s, float begin_s, float end_s) {
  return motion::minimum_jerk((time_s - begin_s) / (end_s - begin_s));
}

motion::Pose recovering(const motion::Skeleton& skeleton, const motion::Pose& standing,
                        const Eigen::Vector3f& way, float time_s) {
  const motion::JointFrames feet = motion::forward_kinematics(skeleton, standing);
  motion::Pose pose = standing;
  const float moved = progress(time_s, kContact_s, kContact_s + 0.6F);
  const float bent = std::sin(std::numbers::pi_v<float> * progress(time_s, kContact_s, 1.6F));
  pose.root_position += moved * way + Eigen::Vector3f(0, 0, -0.05F - 0.02F * bent);
  const Eigen::Vector3f axis = Eigen::Vector3f::UnitZ().cross(way).normalized();
  pose.rotation[Role::abdomen] = motion::rotation_about(axis, 0.2F * bent);
  const auto step = [&](motion::Limb limb, Role foot, float begin_s) {
    const float gone = progress(time_s, begin_s, begin_s + 0.35F);
    const float lift = 0.1F * std::sin(std::numbers::pi_v<float> * gone);
    const Eigen::Vector3f ankle = feet.position[foot] + gone * way + Eigen::Vector3f(0, 0, lift);
    pose = motion::with_limb_end(skeleton, pose, limb, ankle, feet.orientation[foot]);
  };
  step(motion::Limb::left_leg, Role::left_foot, kContact_s + 0.2F);
  step(motion::Limb::right_leg, Role::right_foot, kContact_s + 0.6F);
  return pose;
}

motion::Clip pushed_clip(const database::ClipLibrary& library, const std::string& name,
                         const Eigen::Vector3f& way) {
  const motion::Skeleton& skeleton = library.character.skeleton;
  motion::Clip clip;
  clip.name = name;
  clip.purpose = motion::Purpose::push;
  clip.kind = "push";
  clip.source = "posed by rule";
  motion::Pose standing = library.idle_clip().motion.poses.front();
  for (int k = 0; k <= 120; ++k)
    clip.motion.poses.push_back(
        recovering(skeleton, standing, way, static_cast<float>(k) / clip.motion.rate_hz));
  clip.push = motion::measure_push(skeleton, clip.motion, {});
  return clip;
}

}  // namespace

database::ClipLibrary library_with_pushes() {
  database::ClipLibrary library = scenes::synthetic_library();
  for (const auto& [name, way] : {std::pair{"from_front", Eigen::Vector3f(-0.35F, 0, 0)},
                                  std::pair{"from_behind", Eigen::Vector3f(0.35F, 0, 0)},
                                  std::pair{"from_left", Eigen::Vector3f(0, -0.3F, 0)}}) {
    library.clips.push_back(pushed_clip(library, name, way));
    library.clips.push_back(motion::mirrored(library.clips.back()));
  }
  return library;
}

database::ClipLibrary library_with_walks() {
  database::ClipLibrary library = library_with_pushes();
  for (const auto& [name, way] : {std::pair{"go_back", Eigen::Vector3f(-0.35F, 0, 0)},
                                  std::pair{"go_aside", Eigen::Vector3f(0, -0.3F, 0)}}) {
    motion::Clip clip = pushed_clip(library, name, way);
    clip.purpose = motion::Purpose::anticipation;
    clip.kind = "walk";
    clip.push.reset();
    library.clips.push_back(clip);
  }
  return library;
}

models::RealismModel random_realism(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  models::RealismModel model = constant_realism(0);
  model.points.clear();
  model.quality.clear();
  for (float& number : model.basis) number = uniform(random, -0.3F, 0.3F);
  for (float& weight : model.weight) weight = uniform(random, 0.2F, 2);
  for (std::size_t i = 0; i < models::kRealismFeatureCount * count; ++i)
    model.points.push_back(uniform(random, -2, 2));
  for (std::size_t i = 0; i < count; ++i) model.quality.push_back(uniform(random, 0, 1));
  model.max_distance = 5;
  return model;
}

models::RealismModel constant_realism(float quality) {
  models::RealismModel model;
  model.judge = "made up";
  const std::size_t size = runtime::BodyConfiguration::RowsAtCompileTime;
  model.mean.assign(size, 0);
  model.basis.assign(models::kConfigurationComponents * size, 0);
  model.quality.assign(models::kRealismNeighbours, quality);
  model.points.assign(models::kRealismFeatureCount * models::kRealismNeighbours, 0);
  model.max_distance = 1;
  return model;
}

}  // namespace flinch::tests
