// SPDX-License-Identifier: MIT
// A game loop around one character that balls hit: it anticipates, physics takes the blow, and it
// comes back to idle; the program prints what happens. Usage: reaction SELECTOR, a file that
// `flinch train` makes.
//
// Left out: drawing, getting up, and more than one character. Characters of one library share
// its ReactionData.
#include <cstdio>

#include "reaction/reacting_character.h"

using namespace flinch;

namespace {

constexpr float kFrame_s = 1.0F / 60;
constexpr float kFlight_s = 0.25F;  // too short to get away
// Physics takes over this long before the predicted impact, since the ball may hit earlier.
constexpr float kAhead_s = 0.15F;

/// A volleyball from the front left at the belly; v solves from + v t - g t^2 / 2 = to.
features::Threat thrown_ball() {
  features::Threat ball;
  ball.position = {4.5F, 3.5F, 1.2F};
  ball.velocity = (Eigen::Vector3f(0, 0, 1.1F) - ball.position) / kFlight_s;
  ball.velocity.z() += features::kGravity * kFlight_s / 2;
  return ball;
}

/// Prints what moves the character, the clip or physics, whenever that changes.
void tell(float time_s, const reaction::ReactingCharacter& hero, reaction::PoseSource& last) {
  if (hero.pose_source() == last) return;
  last = hero.pose_source();
  std::printf("%5.2f s  moved by %s\n", static_cast<double>(time_s), name_of(last));
}

/// Throws one ball after a second and plays until the character idles again.
bool play(const runtime::Library& library, runtime::Workspace& workspace) {
  const auto data = reaction::make_reaction_data(library);
  reaction::ReactingCharacter hero(library, data);
  const features::Threat threat = thrown_ball();
  reaction::PoseSource last = hero.pose_source();
  float flown_s = -1;  // time since the throw; negative before
  bool is_met = false;
  for (int frame = 0; frame < 600; ++frame) {
    const bool is_thrown = flown_s < 0 && flown_s + kFrame_s >= 0;
    if (is_thrown) {
      flown_s = 0;
      const runtime::Status status = hero.character().perceive(threat, workspace);
      if (status != runtime::Status::ok) return false;
    }
    if (!is_met && flown_s >= kFlight_s - kAhead_s) {
      is_met = hero.react_to(features::ball_of(features::advanced(threat, flown_s))) ==
               reaction::ReactionStatus::ok;
    }
    if (hero.update(kFrame_s) != reaction::ReactionStatus::ok) return false;
    flown_s += kFrame_s;
    tell(static_cast<float>(frame) * kFrame_s, hero, last);
    // A game draws hero.pose() here, and the ball: hero.reaction().ball() once it is met.
  }
  double impulse_ns = 0;
  for (const double part : hero.reaction().impulse()) impulse_ns += part;
  std::printf("the body took %.1f N s; it ends %s\n", impulse_ns,
              runtime::name_of(hero.character().phase()));
  return is_met && hero.pose_source() == reaction::PoseSource::character &&
         hero.character().phase() == runtime::Phase::idle;
}

}  // namespace

int main(int argument_count, char** arguments) {
  runtime::Library library;
  runtime::Workspace workspace;
  if (argument_count != 2 || library.load(arguments[1]) != database::LoadStatus::ok ||
      workspace.reserve_memory(library.selection_bytes()) != database::LoadStatus::ok) {
    std::fprintf(stderr, "usage: reaction SELECTOR, which can be loaded\n");
    return 2;
  }
  return play(library, workspace) ? 0 : 1;
}
