// SPDX-License-Identifier: MIT
// Whatever passes the checks at load can be played.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "database/library/library_bounds.h"
#include "database/library/library_file.h"
#include "runtime/character.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/sample_count.h"

namespace flinch::runtime {
namespace {

using tests::uniform;

/// One of the bounds or a number between them, whose logarithm is uniform.
float extreme(std::mt19937& random, float min, float max) {
  switch (random() % 4) {
    case 0:
      return min;
    case 1:
      return max;
    default:
      return min * std::pow(max / min, uniform(random, 0, 1));
  }
}

void scale_bones(std::mt19937& random, motion::Skeleton& skeleton) {
  const float whole = extreme(random, 0.1F, 10);
  for (const motion::Role role : motion::kRoles) {
    const motion::Role first = std::min(role, motion::mirrored(role));
    const float own = first != role ? 1 : random() % 3 == 0 ? extreme(random, 1e-3F, 5) : 1;
    for (auto* bones : {&skeleton.offset, &skeleton.tip}) {
      (*bones)[role] *= whole * own;
      if (first != role) {  // left and right stay mirror images
        const Eigen::Vector3f& left = (*bones)[first];
        (*bones)[role] = {left.x(), -left.y(), left.z()};
      }
    }
  }
}

void change_motion(std::mt19937& random, motion::Clip& clip) {
  std::vector<motion::Pose>& poses = clip.motion.poses;
  if (random() % 3 == 0) poses.resize(1 + random() % poses.size());
  for (int change = 0; change < 5; ++change) {
    motion::Pose& pose = poses[random() % poses.size()];
    switch (random() % 4) {
      case 0:
        for (float& x : pose.root_position) x = uniform(random, -1, 1) < 0 ? -1000.0F : 1000.0F;
        break;
      case 1:
        pose.root_position = tests::random_vector(random, extreme(random, 1e-30F, 1000));
        break;
      case 2:
        pose = tests::random_pose(random);
        break;
      default:
        for (Eigen::Quaternionf& rotation : pose.rotation) {
          rotation.coeffs() *= uniform(random, 0.9992F, 1.0008F);
          if (random() % 2 == 0) rotation.coeffs() *= -1;
        }
    }
  }
}

void change_times(std::mt19937& random, float rate_hz, motion::Clip& clip) {
  clip.motion.rate_hz = rate_hz;
  if (!clip.annotation) return;
  const float duration_s = clip.motion.duration_s();
  motion::Annotation& annotation = *clip.annotation;
  annotation.onset_s = random() % 2 == 0 ? 0 : uniform(random, 0, duration_s);
  annotation.peak_s = random() % 2 == 0 ? annotation.onset_s + 1.001e-3F
                                        : uniform(random, annotation.onset_s, duration_s);
  annotation.end_s = random() % 2 == 0 ? duration_s : annotation.peak_s;
}

/// A library at the edges of what is accepted.
database::ClipLibrary extreme_library(std::mt19937& random) {
  while (true) {
    database::ClipLibrary library = scenes::synthetic_library();
    library.rate_hz = extreme(random, database::kMinRate_hz, database::kMaxRate_hz);
    library.character.mass_kg = extreme(random, database::kMinMass_kg, database::kMaxMass_kg);
    scale_bones(random, library.character.skeleton);
    for (motion::Clip& clip : library.clips) {
      change_motion(random, clip);
      change_times(random, library.rate_hz, clip);
      if (clip.annotation && database::fault_of(*clip.annotation, clip.motion.duration_s())) {
        clip.annotation.reset();
      }
    }
    if (!database::fault_of(library)) return library;
  }
}

features::Threat extreme_threat(std::mt19937& random) {
  features::Threat threat;
  threat.position = tests::random_vector(random, extreme(random, 1e-3F, 1e6F));
  threat.velocity = tests::random_vector(random, extreme(random, 1e-3F, 1e6F));
  if (random() % 2 == 0) {  // towards the character
    threat.position = tests::random_vector(random, 20);
    threat.velocity = uniform(random, 0.5F, 3) * (Eigen::Vector3f(0, 0, 1) - threat.position);
  }
  threat.radius = extreme(random, 1e-3F, 1e6F);
  threat.mass_kg = extreme(random, 1e-3F, 1e6F);
  return threat;
}

void call(std::mt19937& random, Character& character, Workspace& workspace, int clip_count) {
  switch (random() % 8) {
    case 0:
      character.perceive(extreme_threat(random), workspace);
      break;
    case 1:
      character.perceive(extreme_threat(random), static_cast<motion::Target>(random() % 4),
                         extreme(random, 1e-3F, 100), workspace);
      break;
    case 2:
      character.respond(static_cast<int>(random() % static_cast<unsigned>(clip_count)),
                        extreme(random, 1e-3F, 100));
      break;
    case 3:
      character.place(Eigen::Vector2f(uniform(random, -1e3F, 1e3F), uniform(random, -1e3F, 1e3F)),
                      uniform(random, -4, 4), extreme(random, 1e-3F, 1e6F));
      break;
    default:
      character.update(random() % 8 == 0 ? extreme(random, 1e-6F, 1e6F)
                                         : extreme(random, 1e-3F, 0.3F));
  }
}

TEST(AcceptedFile, GivesFinitePosesWhateverIsCalled) {
  constexpr int kCallsPerFile = 250;
  const int files = tests::soak_samples(80, 4'000);  // a million calls in the soak
  for (int file = 0; file < files; ++file) {
    std::mt19937 random(static_cast<unsigned>(file));
    const database::ClipLibrary clips = extreme_library(random);
    const std::string bytes = tests::made_up_selector(clips, 30, tests::ModelKind::knn).file();
    Library library;
    ASSERT_EQ(library.load(std::as_bytes(std::span(bytes))), database::LoadStatus::ok);
    Workspace workspace;
    ASSERT_EQ(workspace.reserve_memory(library.selection_bytes()), database::LoadStatus::ok);
    Character character(library);
    for (int i = 0; i < kCallsPerFile; ++i) {
      call(random, character, workspace, static_cast<int>(clips.clips.size()));
      ASSERT_TRUE(is_sound(character.pose())) << "file " << file << ", call " << i;
    }
  }
}

}  // namespace
}  // namespace flinch::runtime
