// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <random>

#include "database/library/library.h"
#include "motion/default_character.h"
#include "tests/motion/random_motion.h"

namespace flinch::tests {

inline motion::Clip random_clip(std::mt19937& random, const std::string& name, int poses) {
  motion::Clip clip;
  clip.name = name;
  clip.kind = "block";
  clip.source = "take \xC3\xA9" + name + ".bvh";
  for (int i = 0; i < poses; ++i) clip.motion.poses.push_back(random_pose(random));
  return clip;
}

/// A valid library at 60 Hz: an idle clip of one pose, an annotated clip, its mirror image in name
/// only, and a clip with a push (of more than two poses), of `poses` poses each.
inline database::ClipLibrary random_library(unsigned seed, int poses) {
  std::mt19937 random(seed);
  database::ClipLibrary library;
  library.name = "random";
  library.character = motion::default_character();
  library.character.skeleton = with_crooked_bones(library.character.skeleton, random);
  library.character.sex = motion::Sex::female;
  library.character.mass_kg = 61.375F;
  for (const char* name : {"block", "idle", "block_mirrored", "walk"}) {
    library.clips.push_back(random_clip(random, name, poses));
  }
  library.idle = 1;
  library.clips[1].motion.poses.resize(1);
  library.clips[1].purpose = motion::Purpose::idle;
  library.clips[0].annotation = {.target = motion::Target::legs,
                                 .direction = -std::numbers::pi_v<float> / 4,
                                 .degree = motion::Degree::exaggerated,
                                 .onset_s = 0,
                                 .peak_s = 1 / 60.0F,
                                 .end_s = library.clips[0].motion.duration_s()};
  library.clips[2].annotation = library.clips[0].annotation;
  library.clips[2].annotation->direction = std::numbers::pi_v<float>;
  library.clips[2].mirrored_from = "block";
  library.clips[3].purpose = motion::Purpose::push;
  if (poses > 2) {
    library.clips[3].push = {.contact_s = 0.005F,
                             .peak_s = 0.025F,
                             .place = motion::Role::left_upper_arm,
                             .direction = -0.75F,
                             .velocity = {-1, 0.5F, 0.125F}};
  }
  return library;
}

}  // namespace flinch::tests
