// SPDX-License-Identifier: MIT
// A character that crouches under a ball, and a file that is not there.
#include <cmath>
#include <cstddef>
#include <iostream>
#include <numbers>
#include <string>

#include "database/library_file.h"
#include "motion/default_character.h"
#include "runtime/response.h"
#include "runtime/selector_file.h"

using namespace flinch;

namespace {

struct GameCharacter {
  database::Library library;
  models::Selector selector;
  runtime::Response response;  // refers to the library

  bool load(const std::string& library_file, const std::string& selector_file) {
    return database::read_library(library_file, library) == database::LoadStatus::ok &&
           runtime::read_selector(selector_file, selector) == database::LoadStatus::ok &&
           selector.library_hash == library.hash;
  }
  void perceive(const features::Scenario& scenario) {
    const auto& idle = library.clips[static_cast<std::size_t>(library.idle)].motion;
    const auto x = features::to_vector(features::features_of(scenario, idle));
    const int clip = models::select(selector, x, scenario.target);
    response = runtime::make_response(library, scenario.state, clip, scenario.time_to_impact_s);
  }
  motion::Pose pose(float time_s) const { return runtime::pose_at(response, time_s); }
};

constexpr float kDepth = 0.3F;  // m, that the character crouches by
constexpr int kFrames = 60;     // of its crouch, half down and half up

motion::Clip crouch(const motion::Pose& standing) {
  motion::Clip clip;
  clip.name = "crouch";
  clip.annotation = motion::Annotation{.onset_s = 0, .peak_s = 0.5F, .end_s = 1};
  for (int frame = 0; frame <= kFrames; ++frame) {
    const float phase = std::numbers::pi_v<float> * static_cast<float>(frame) / kFrames;
    motion::Pose pose = standing;
    pose.root_position.z() -= kDepth * std::sin(phase);
    clip.motion.poses.push_back(pose);
  }
  return clip;
}

// A character of two clips, whose selector has seen one threat and crouched.
GameCharacter crouching_character() {
  GameCharacter character;
  character.library.character = motion::default_character();
  const auto standing = motion::rest_pose(character.library.character.skeleton);
  motion::Clip idle;
  idle.name = "stand";
  idle.purpose = motion::Purpose::idle;
  idle.motion.poses = {standing};
  character.library.clips = {idle, crouch(standing)};

  for (const auto& clip : character.library.clips)
    character.selector.clips.push_back({clip.name, clip.annotation});
  character.selector.scaling.least.assign(features::kFeatureCount, -1);
  character.selector.scaling.most.assign(features::kFeatureCount, 1);
  models::KnnModel model;
  model.feature_count = features::kFeatureCount;
  model.points.assign(features::kFeatureCount, 0);
  model.label = {1};
  character.selector.model = model;
  return character;
}

float head_height(const GameCharacter& character, float time_s) {
  const auto& skeleton = character.library.character.skeleton;
  const auto frames = motion::forward_kinematics(skeleton, character.pose(time_s));
  return frames.position[motion::Role::head].z();
}

}  // namespace

int main() {
  GameCharacter character = crouching_character();
  features::Scenario scenario;
  scenario.threat.position = {16, 0, 1.7F};
  scenario.threat.velocity = {-20, 0, 0};
  scenario.time_to_impact_s = 0.8F;
  character.perceive(scenario);
  const float drop = head_height(character, 0) - head_height(character, scenario.time_to_impact_s);
  std::cout << "the head is " << drop << " m lower at the impact\n";

  GameCharacter nobody;
  const bool loaded = nobody.load("missing.flinchlib", "missing.flinch");
  std::cout << "missing files are " << (loaded ? "loaded\n" : "refused\n");
  return std::abs(drop - kDepth) < 1e-3F && !loaded ? 0 : 1;
}
