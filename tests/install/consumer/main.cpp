// SPDX-License-Identifier: MIT
// Plays a clip against a threat, then shows that a file that is not there gives a status.
#include <cmath>
#include <iostream>
#include <numbers>

#include "motion/default_character.h"
#include "runtime/response.h"
#include "runtime/selector_file.h"

namespace {

using flinch::motion::Role;

// Half a second down and half a second up: the head goes down with the pelvis.
flinch::motion::Motion crouch(const flinch::motion::Pose& standing) {
  flinch::motion::Motion motion;
  for (int frame = 0; frame <= 60; ++frame) {
    const float part = static_cast<float>(frame) / 60;
    flinch::motion::Pose pose = standing;
    pose.root_position.z() -= 0.3F * std::sin(std::numbers::pi_v<float> * part);
    motion.poses.push_back(pose);
  }
  return motion;
}

flinch::database::Library crouching_library() {
  flinch::database::Library library;
  library.character = flinch::motion::default_character();
  const auto standing = flinch::motion::rest_pose(library.character.skeleton);
  flinch::motion::Clip idle;
  idle.name = "stand";
  idle.purpose = flinch::motion::Purpose::idle;
  idle.motion.poses = {standing};
  flinch::motion::Clip duck;
  duck.name = "crouch";
  duck.motion = crouch(standing);
  duck.annotation = flinch::motion::Annotation{.onset_s = 0, .peak_s = 0.5F, .end_s = 1};
  library.clips = {idle, duck};
  return library;
}

}  // namespace

int main() {
  const auto library = crouching_library();
  const float time_to_impact_s = 0.8F;
  const auto response = flinch::runtime::make_response(library, {}, 1, time_to_impact_s);
  const auto head_height = [&](float time_s) {
    const auto pose = flinch::runtime::pose_at(response, time_s);
    const auto frames = flinch::motion::forward_kinematics(library.character.skeleton, pose);
    return frames.position[Role::head].z();
  };
  const float drop = head_height(0) - head_height(time_to_impact_s);
  std::cout << "the head is " << drop << " m lower at the impact\n";

  flinch::models::Selector selector;
  const auto status = flinch::runtime::read_selector("no such file", selector);
  std::cout << "no such file: " << flinch::database::message_of(status) << '\n';

  const bool good = std::abs(drop - 0.3F) < 1e-3F && status == flinch::database::LoadStatus::cannot_open;
  return good ? 0 : 1;
}
