// SPDX-License-Identifier: MIT
// Draws the filmstrips of docs/response.md: the same clip from idling, from the guard and from a
// walk.
//
//     stance_drawing FOLDER
#include <array>
#include <string>

#include "database/author/authored_library.h"
#include "database/export/filmstrip.h"
#include "database/files/file_io.h"
#include "motion/default_character.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response.h"
#include "tests/bench/study.h"
#include "tests/scenes/walk.h"

namespace flinch {
namespace {

constexpr const char* kClip = "block_trunk_front_exaggerated";
constexpr std::array kStances{"idle", "guard", "walk"};
constexpr float kImpact_s = 0.6F;
constexpr float kAfter_s = 0.6F;

int clip_named(const database::ClipLibrary& library, const std::string& name) {
  for (std::size_t i = 0; i < library.clips.size(); ++i)
    if (library.clips[i].name == name) return static_cast<int>(i);
  throw Error("", "there is no clip " + name);
}

/// The response and a moment after it; one that walks stays in the middle of its column.
motion::Clip recorded(const runtime::Response& response, bool walks) {
  constexpr float kRate_hz = 60;
  motion::Clip clip;
  clip.motion.rate_hz = kRate_hz;
  const float end_s = runtime::duration_s(response) + kAfter_s;
  for (float t = 0; t < end_s; t += 1 / kRate_hz) {
    motion::Pose pose = runtime::pose_at(response, t);
    if (walks) pose.root_position.head<2>().setZero();
    clip.motion.poses.push_back(pose);
  }
  clip.annotation = motion::Annotation{
      .target = motion::Target::trunk, .peak_s = kImpact_s, .end_s = clip.motion.duration_s()};
  return clip;
}

void run(const bench::StudyArguments& arguments) {
  const database::ClipLibrary library =
      tests::with_walk(database::authored_library(motion::default_character()));
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  const motion::Figure figure = motion::make_figure(library.character);
  features::CharacterState state;
  state.idle_time_s = 0.2F;
  for (const char* name : kStances) {
    const bool walks = prepared.stance_of(state).loop.travels();
    motion::Clip clip = recorded(
        runtime::make_response(prepared, state, clip_named(library, kClip), kImpact_s), walks);
    clip.name = std::string(kClip) + " from " + name;
    database::write_file_atomically(arguments.text(0) + "/from_" + name + ".svg",
                                    database::filmstrip_svg(figure, clip));
    ++state.stance;
  }
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"stance_drawing FOLDER", 1, 1}, flinch::run);
}
