// SPDX-License-Identifier: MIT
// A character that looks ahead: two balls fly at it at once, it simulates what its best clips would
// do against both, within half a millisecond, and prints why it chose. Then it does the same again,
// spread over frames. Usage: look_ahead SELECTOR, which `flinch train` makes.
//
// Left out: drawing, and what happens when a ball hits.
#include "lookahead/look_ahead.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

using namespace flinch;

namespace {

constexpr float kFrame_s = 1.0F / 60;

/// The game's own clock: Flinch has none.
double now_us(void*) {
  using Microseconds = std::chrono::duration<double, std::micro>;
  return Microseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A ball that flies from `from` to `to` in `flight_s`: it solves from + v t - g t^2 / 2 = to.
features::Threat thrown_ball(const Eigen::Vector3f& from, const Eigen::Vector3f& to,
                             float flight_s) {
  features::Threat ball;  // a volleyball
  ball.position = from;
  ball.velocity = (to - from) / flight_s;
  ball.velocity.z() += features::kGravity * flight_s / 2;
  return ball;
}

void print_why(const runtime::Library& library, const lookahead::LookAheadStatus& status) {
  std::printf("%zu threats, %zu of %zu candidates tried, %zu encounters simulated\n",
              status.threats, status.tried, status.count, status.encounters);
  for (std::size_t i = 0; i < status.count; ++i) {
    const lookahead::ForeseenCandidate& candidate = status.candidates[i];
    std::printf("%s %-44s %-10s damage %6.3f N s, work %4.0f J, cost %6.3f N s\n",
                i == status.chosen ? "->" : "  ",
                library.clip_library().clip(candidate.candidate.clip).name.c_str(),
                name_of(candidate.foreseen), static_cast<double>(candidate.damage_ns),
                static_cast<double>(candidate.work_j), static_cast<double>(candidate.cost_ns));
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return std::fputs("usage: look_ahead SELECTOR\n", stderr), 2;
  runtime::Library library;
  if (library.load(std::string(arguments[1])) != database::LoadStatus::ok) return 1;
  const auto data = lookahead::make_look_ahead_data(library);  // one for all characters
  lookahead::LookAheadWorkspace workspace;                     // one for each thread
  if (!workspace.reserve_memory(library, data)) return 1;

  const std::array threats{thrown_ball({9, 1, 1.4F}, {0, 0, 1.6F}, 0.6F),
                           thrown_ball({-1, 9, 1.4F}, {0, 0, 1.1F}, 0.9F)};
  runtime::Character character(library);
  const lookahead::LookAhead eight{.candidates = 8,
                                   .budget = {.us = 500, .now_us = now_us, .clock = nullptr}};
  const lookahead::LookAheadStatus status =
      lookahead::perceive(character, threats, eight, workspace);
  if (status.status != runtime::Status::ok) return 1;
  print_why(library, status);

  // Spread over frames, of which each spares 50 us.
  runtime::Character other(library);
  lookahead::Search search(library);
  if (search.begin(other, threats, 8, workspace) != runtime::Status::ok) return 1;
  int frames = 0;
  const lookahead::Budget little{.us = 50, .now_us = now_us, .clock = nullptr};
  for (; search.is_open(); ++frames) search.update(other, kFrame_s, little, workspace);
  std::printf("spread over %d frames:\n", frames);
  print_why(library, search.status());
  return other.clip() != library.clip_library().idle ? 0 : 1;
}
