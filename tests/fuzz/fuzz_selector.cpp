// SPDX-License-Identifier: MIT
// The selector's reader, and a character in a game that plays what was read. An input is a
// selector's content; the target seals it.
#include <array>

#include "runtime/character.h"
#include "tests/fuzz/fuzz.h"

namespace {

using namespace flinch;

constexpr float kFrame_s = 1.0F / 30;

void require_finite(const motion::Pose& pose) {
  tests::require(is_sound(pose, 1e-4F), "poses of an accepted selector are finite and unit");
}

/// Two balls, the second while the character answers the first.
void play(const runtime::Library& library) {
  runtime::Workspace workspace;
  if (workspace.reserve_memory(library.selection_bytes()) != database::LoadStatus::ok) return;
  runtime::Character character(library);
  features::Threat ball;
  ball.position = {8, 4, 1.5F};
  ball.velocity = {-16, -8, 2.7F};
  for (int throw_number = 0; throw_number < 2; ++throw_number) {
    character.perceive(ball, workspace);
    character.perceive(ball, motion::Target::head, 0.5F, workspace);
    for (int frame = 0; frame < 20; ++frame) {
      character.update(kFrame_s);
      require_finite(character.pose());
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string file = tests::sealed(database::kSelectorFormat, tests::text_of(data, size));
  runtime::Library library;
  if (library.load(database::bytes_of(file)) == database::LoadStatus::ok) play(library);
  return 0;
}
