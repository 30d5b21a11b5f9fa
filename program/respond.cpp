// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "database/export/bvh_writer.h"
#include "database/export/filmstrip.h"
#include "database/export/gltf_writer.h"
#include "database/files/file_io.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "program/command.h"
#include "program/load.h"
#include "program/look_ahead_option.h"
#include "program/printable.h"
#include "program/response_recording.h"
#include "program/table.h"
#include "program/threat_options.h"

namespace flinch::program {

namespace {

struct RespondOptions {
  std::string selector;
  std::string out;
  ThreatOptions threat;
  std::optional<int> look_ahead;
  bool force = false;
  bool json = false;
};

enum class Kind : std::uint8_t { glb, bvh, svg };

Kind kind_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".glb") return Kind::glb;
  if (extension == ".bvh") return Kind::bvh;
  if (extension == ".svg") return Kind::svg;
  throw Error(path, "unknown kind of file; use a name that ends in .glb, .bvh or .svg");
}

/// Returns what `--out` will be. Throws Error for a name with another ending.
database::Output output_of(const std::string& path) {
  using database::FileKind;
  switch (kind_of(path)) {
    case Kind::glb:
      return {path, FileKind::gltf, database::kGlbMark};
    case Kind::bvh:
      return {path, FileKind::bvh, database::kBvhMark};
    default:
      return {path, FileKind::text, database::kFilmstripMark};
  }
}

// Draws the recording as a clip that protects the side that the threat comes from, so that the
// filmstrip shows its arrow.
void write_filmstrip(const runtime::Library& library, const ResponseRecording& recording,
                     const RespondOptions& options) {
  motion::Clip clip = library.clip_library().clip(recording.clip);
  clip.motion = recording.motion;
  if (clip.annotation) {
    clip.annotation->onset_s = 0;
    clip.annotation->peak_s = recording.impact_s;
    clip.annotation->end_s = recording.motion.duration_s();
    clip.annotation->direction = static_cast<float>(motion::radians(options.threat.azimuth));
  }
  database::write_file_atomically(
      options.out,
      database::filmstrip_svg(motion::make_figure(library.clip_library().character), clip));
}

const std::string& clip_name(const runtime::Library& library, int clip) {
  return library.clip_library().clip(clip).name;
}

database::MotionFacts facts_of(const runtime::Library& library,
                               const ResponseRecording& recording) {
  database::MotionFacts facts{.clip = clip_name(library, recording.clip),
                              .impact_s = recording.impact_s};
  if (std::isfinite(recording.contact_s)) {
    facts.contact_s = recording.contact_s;
    facts.hit_body = recording.hit_body;
    facts.impulse_ns = recording.impulse_ns;
  }
  return facts;
}

void write(const runtime::Library& library, const ResponseRecording& recording,
           const RespondOptions& options) {
  const motion::Physique& character = library.clip_library().character;
  switch (kind_of(options.out)) {
    case Kind::glb:
      database::write_glb(options.out, character, recording.motion, recording.ball,
                          facts_of(library, recording));
      break;
    case Kind::bvh:
      database::write_bvh(options.out, character, recording.motion);
      break;
    case Kind::svg:
      write_filmstrip(library, recording, options);
      break;
  }
}

void run_respond(const RespondOptions& options) {
  database::check_outputs({output_of(options.out)}, {options.selector},
                          overwrite_of(options.force));
  const runtime::Library library = load_runtime_library(options.selector);
  const motion::PerTarget<Eigen::Vector3f>& centres = library.selector().target_centres;
  const features::ThreatDescription threat = described(options.threat, library.selector());
  lookahead::LookAheadWorkspace look_ahead;
  if (options.look_ahead) look_ahead = look_ahead_workspace(library, options.selector);
  const ResponseRecording recording =
      record_response(library, features::threat_from_description(threat, centres[threat.target], 0),
                      threat.target, threat.time_to_impact_s,
                      options.look_ahead ? &look_ahead : nullptr, options.look_ahead.value_or(1));
  write(library, recording, options);

  const std::string& clip = clip_name(library, recording.clip);
  const bool hits = std::isfinite(recording.contact_s);
  if (options.json) {
    Json document{{"file", options.out},
                  {"clip", clip},
                  {"target", options.threat.target},
                  {"time_to_impact_s", options.threat.time_to_impact_s},
                  {"duration_s", shortest(recording.motion.duration_s())},
                  {"hits", hits},
                  {"knocked_over", recording.knocked_over}};
    if (recording.reaction_clip)
      document["reaction_clip"] = clip_name(library, *recording.reaction_clip);
    if (hits) {
      document["contact_s"] = shortest(recording.contact_s);
      document["impulse_ns"] = shortest(recording.impulse_ns);
      document["hit_body"] = motion::name_of(recording.hit_body);
    }
    print(document);
    return;
  }
  std::cout << printable(options.out) << ": " << printable(clip) << ", "
            << fixed(double{recording.motion.duration_s()}, 2) << " s; ";
  if (hits) {
    std::cout << "the ball hits at " << fixed(double{recording.contact_s}, 2) << " s with "
              << fixed(double{recording.impulse_ns}, 1) << " N s";
  } else {
    std::cout << "the ball hits nothing";
  }
  if (recording.reaction_clip)
    std::cout << ", then " << printable(clip_name(library, *recording.reaction_clip));
  std::cout << (recording.knocked_over ? ", which knocks the character over\n" : "\n");
}

}  // namespace

Command respond_command() {
  auto options = std::make_shared<RespondOptions>();
  return {.name = "respond",
          .summary = "Write the whole response to a threat as an animation, ball included",
          .required = {{"SELECTOR", "selector made by flinch train", &options->selector},
                       {"--out",
                        "FILE.glb for Blender and glTF viewers, FILE.bvh, or FILE.svg for a "
                        "filmstrip",
                        &options->out}},
          .optional = join({threat_options(options->threat),
                            {look_ahead_option(options->look_ahead), force_option(options->force),
                             json_option(options->json)}}),
          .notes =
              "The character stands at the origin, facing the front, perceives the threat at once, "
              "and is\n"
              "hit by it as in the simulation.\n\n"
              "Example:\n  flinch respond default.flinch --azimuth 40 --speed 24 --target head "
              "--out hit.glb",
          .run = [options] { run_respond(*options); }};
}

}  // namespace flinch::program
