// SPDX-License-Identifier: MIT
// A game loop around one character: balls fly at it in frames of uneven length, and the loop prints
// what it does. Usage: game_loop SELECTOR, which `flinch train` makes.
//
// Left out: drawing, what happens when a ball hits, and more than one character. Characters share a
// library; those of one thread share a workspace.
#include <array>
#include <cstdio>
#include <string>

#include "runtime/character.h"

using namespace flinch;

namespace {

constexpr float kLastThrow_s = 6;
constexpr float kEnd_s = 9;

/// A ball that the game throws at time `at_s`: it flies from `from` to `to` in `flight_s`.
struct Throw {
  float at_s;
  Eigen::Vector3f from;
  Eigen::Vector3f to;
  float flight_s;
  bool hits;
};
const std::array<Throw, 3> kThrows{{{1, {9, 7, 1.2F}, {0, 0, 1.6F}, 0.6F, true},
                                    {kLastThrow_s / 2, {8, 0, 1.5F}, {0, 0, 1.2F}, 0.5F, true},
                                    {kLastThrow_s, {9, -2, 1.5F}, {0, 4, 2}, 0.7F, false}}};

/// Frame times as in a game: some short, some long, one hitch.
float frame_time_s(int frame) {
  constexpr std::array<float, 6> kTimes_s{1.0F / 60, 1.0F / 144, 1.0F / 30,
                                          0.011F,    1.0F / 60,  0.1F};
  return kTimes_s[static_cast<std::size_t>(frame) % kTimes_s.size()];
}

/// The ball at its start, with the velocity v that solves from + v t - g t^2 / 2 = to.
features::Threat ball_of(const Throw& thrown) {
  features::Threat ball;  // a volleyball
  ball.position = thrown.from;
  ball.velocity = (thrown.to - thrown.from) / thrown.flight_s;
  ball.velocity.z() += features::kGravity * thrown.flight_s / 2;
  return ball;
}

float head_height(const runtime::Library& library, const motion::Pose& pose) {
  const auto frames = motion::forward_kinematics(library.clip_library().character.skeleton, pose);
  return frames.position[motion::Role::head].z();
}

void print_what_it_does(const runtime::Library& library, const runtime::Character& character,
                        float time_s) {
  const motion::Clip& clip =
      library.clip_library().clips[static_cast<std::size_t>(character.clip())];
  std::printf("%5.2f s  %-10s  %-36s  head at %.2f m", static_cast<double>(time_s),
              name_of(character.phase()), clip.name.c_str(),
              static_cast<double>(head_height(library, character.pose())));
  if (character.phase() != runtime::Phase::idle)
    std::printf(", impact in %.2f s", static_cast<double>(character.time_to_impact_s()));
  std::printf("\n");
}

/// Shows the character the ball. Returns whether it judged correctly if the ball hits or misses.
bool perceive(runtime::Character& character, runtime::Workspace& workspace, const Throw& thrown) {
  const runtime::Status status = character.perceive(ball_of(thrown), workspace);
  std::printf("a ball is thrown: %s\n", message_of(status));
  for (const models::Candidate& candidate : character.candidates().first(
           status == runtime::Status::ok ? character.candidates().size() : 0))
    std::printf("  clip %d is expected to cost %.2f N s\n", candidate.clip,
                static_cast<double>(candidate.expected_cost_ns));
  return status == (thrown.hits ? runtime::Status::ok : runtime::Status::misses);
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return std::fputs("usage: game_loop SELECTOR\n", stderr), 2;
  runtime::Library library;
  const database::LoadStatus loaded = library.load(std::string(arguments[1]));
  runtime::Workspace workspace;
  if (loaded != database::LoadStatus::ok ||
      workspace.reserve_memory(library.selection_bytes()) != database::LoadStatus::ok) {
    std::fprintf(stderr, "game_loop: %s %s\n", arguments[1], message_of(loaded));
    return 1;
  }

  runtime::Character character(library);
  character.place({0, 0}, 0, 0.3F);
  bool is_right = true;
  std::size_t thrown = 0;
  int answers = 0;
  runtime::Phase before = character.phase();
  float time_s = 0;
  for (int frame = 0; time_s < kEnd_s; ++frame) {
    if (thrown < kThrows.size() && time_s >= kThrows[thrown].at_s)
      is_right &= perceive(character, workspace, kThrows[thrown++]);
    const float dt_s = frame_time_s(frame);
    is_right &= character.update(dt_s) == runtime::Status::ok;
    time_s += dt_s;
    if (character.phase() != before) print_what_it_does(library, character, time_s);
    answers += character.phase() == runtime::Phase::protecting && character.phase() != before;
    before = character.phase();
  }
  std::printf("%d of the balls were answered with a clip\n", answers);
  return is_right && answers > 0 && before == runtime::Phase::idle ? 0 : 1;
}
