// SPDX-License-Identifier: MIT
// A separate game project: a ball flies at a character's head, and the head moves out of the way.
// Usage: consumer SELECTOR
#include <algorithm>
#include <iostream>
#include <string>

#include "runtime/character.h"

using namespace flinch;

namespace {

/// Stands in for a game: one throw in three seconds; checks the poses that would be drawn.
class Game {
 public:
  bool is_running() const { return frame_ < 180; }
  bool ball_is_thrown() const { return frame_ == 60; }
  features::Threat ball() const {
    return {.position = {9, 1, 1.4F}, .velocity = {-20, -2.2F, 2.8F}};
  }
  float frame_time_s() const { return 1.0F / 60; }
  void draw(const motion::Skeleton& skeleton, const motion::Pose& pose) {
    const auto frames = motion::forward_kinematics(skeleton, pose);
    const Eigen::Vector3f head = frames.position[motion::Role::head];
    if (frame_ == 0) head_at_first_ = head;
    head_moved_by_ = std::max(head_moved_by_, (head - head_at_first_).norm());
    ++frame_;
  }
  float head_moved_by() const { return head_moved_by_; }

 private:
  int frame_ = 0;
  float head_moved_by_ = 0;
  Eigen::Vector3f head_at_first_ = Eigen::Vector3f::Zero();
};

bool play(Game& game, const std::string& selector_file) {
  runtime::Library library;      // one for all characters of a kind
  runtime::Workspace workspace;  // one for each thread
  if (library.load(selector_file) != database::LoadStatus::ok ||
      workspace.reserve_memory(library.selection_bytes()) != database::LoadStatus::ok) {
    return false;
  }
  runtime::Character character(library);
  while (game.is_running()) {
    if (game.ball_is_thrown()) character.perceive(game.ball(), workspace);
    character.update(game.frame_time_s());
    game.draw(library.clip_library().character.skeleton, character.pose());
  }
  return true;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return 2;
  Game game;
  const bool played = play(game, arguments[1]);
  std::cout << "the head has moved by " << game.head_moved_by() << " m\n";
  Game nothing;
  const bool refused = !play(nothing, "missing.flinch");
  std::cout << "a missing file is " << (refused ? "refused\n" : "loaded\n");
  return played && game.head_moved_by() > 0.1F && refused ? 0 : 1;
}
