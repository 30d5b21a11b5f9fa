// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "database/author/stance.h"
#include "database/export/bvh_writer.h"
#include "database/export/filmstrip.h"
#include "database/export/gltf_writer.h"
#include "database/files/file_io.h"
#include "database/import/import.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "program/command.h"
#include "program/command_line.h"
#include "program/look_ahead_option.h"
#include "program/printable.h"
#include "program/response_recording.h"
#include "program/table.h"
#include "program/threat_options.h"
#include "runtime/response/prepared_library.h"
#include "train/fit/selector_reader.h"

namespace flinch::program {

namespace {

/// A threat that comes after the first; what is not given is as the first one's.
struct SecondThreat {
  std::optional<double> time_to_impact_s;  ///< none: there is no second threat
  std::optional<double> azimuth;
  std::optional<double> speed_mps;
  std::optional<std::string> target;
};

struct RespondOptions {
  std::string selector;               ///< empty: none, the answer is by rule
  std::optional<std::string> motion;  ///< that the character is in, if there is no selector
  double at_s = 0;                    ///< how far in that motion
  bool by_rule = false;
  bool startles = false;
  std::string out;
  ThreatOptions threat;
  SecondThreat second;
  std::optional<std::string> start;
  std::optional<std::string> clip;
  std::optional<int> look_ahead;
  double reaction_delay_s = 0;
  double noise = 0;
  double failure = 0;
  std::uint64_t seed = 1;
  std::string ending = "clip";
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

std::string clip_name(const runtime::Library& library, int clip) {
  return clip == runtime::kNoClip ? "by rule" : library.clip_library().clip(clip).name;
}

// Draws the recording as a clip that protects the part and the side that the threat comes to, so
// that the filmstrip shows its arrow. A figure that walks stays in the middle of its column.
void write_filmstrip(const runtime::Library& library, const ResponseRecording& recording,
                     const RespondOptions& options, bool walks) {
  motion::Clip clip;
  clip.name = clip_name(library, recording.clip);
  if (options.threat.kind) clip.name = *options.threat.kind + ": " + clip.name;
  clip.motion = recording.motion;
  database::BallTrack threat = recording.ball;
  for (std::size_t k = 0; walks && k < clip.motion.poses.size(); ++k) {
    Eigen::Vector3f& root = clip.motion.poses[k].root_position;
    const Eigen::Vector3f moved(root.x(), root.y(), 0);
    root -= moved;
    if (threat.positions[k]) *threat.positions[k] -= moved;
  }
  clip.annotation =
      motion::Annotation{.target = *motion::target_named(options.threat.target),
                         .direction = static_cast<float>(motion::radians(options.threat.azimuth)),
                         .peak_s = recording.impact_s,
                         .end_s = recording.motion.duration_s()};
  database::write_file_atomically(
      options.out, database::filmstrip_svg(motion::make_figure(library.clip_library().character),
                                           clip, &threat));
}

database::MotionFacts facts_of(const runtime::Library& library,
                               const ResponseRecording& recording) {
  database::MotionFacts facts{.clip = clip_name(library, recording.clip),
                              .impact_s = recording.impact_s};
  if (const RecordedHit& hit = recording.hits.front(); std::isfinite(hit.contact_s)) {
    facts.contact_s = hit.contact_s;
    facts.hit_body = hit.hit_body;
    facts.impulse_ns = hit.impulse_ns;
  }
  return facts;
}

void write(const runtime::Library& library, const ResponseRecording& recording,
           const RespondOptions& options, bool walks) {
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
      write_filmstrip(library, recording, options, walks);
      break;
  }
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// Returns the library of a character that is in a motion and has no selector.
runtime::Library library_of_motion(const RespondOptions& options) {
  database::ClipLibrary clips = database::import_library({*options.motion}, std::nullopt).library;
  const float duration_s = clips.clips.front().motion.duration_s();
  if (options.at_s > double{duration_s})
    throw Error(*options.motion,
                "lasts " + fixed(double{duration_s}, 2) + " s; --at must be a moment of it");
  clips.clips.front().purpose = motion::Purpose::stance;
  motion::Clip idle;
  idle.name = "idle";
  idle.purpose = motion::Purpose::idle;
  idle.kind = "idle";
  idle.motion = database::idle_motion(motion::make_figure(clips.character), clips.rate_hz);
  clips.clips.insert(clips.clips.begin(), idle);
  clips.idle = 0;
  runtime::Library library;
  if (library.take(std::move(clips)) != database::LoadStatus::ok)
    throw Error("", "there is not enough memory");
  return library;
}

/// Returns the number of the stance that --start names, which is its clip's or its kind.
int stance_of(const database::ClipLibrary& library, const RespondOptions& options) {
  if (options.motion) return 1;
  if (!options.start) return 0;
  std::vector<std::string> known;
  int stance = 0;
  for (const int index : database::stance_clips(library)) {
    const motion::Clip& clip = library.clip(index);
    if (clip.name == *options.start) return stance;
    known.push_back(clip.name);
    ++stance;
  }
  throw Error(options.selector,
              "has no stance " + *options.start + " for --start; it has: " + quoted_list(known));
}

std::optional<int> clip_of(const database::ClipLibrary& library, const RespondOptions& options) {
  if (!options.clip) return std::nullopt;
  if (options.second.time_to_impact_s)
    throw UsageError("--clip answers one threat; leave out the second one's options");
  for (std::size_t i = 0; i < library.clips.size(); ++i) {
    const bool answers = library.clips[i].annotation || static_cast<int>(i) == library.idle;
    if (answers && library.clips[i].name == *options.clip) return static_cast<int>(i);
  }
  throw Error(options.selector, "has no clip " + *options.clip +
                                    " that answers threats; `flinch info` lists its clips");
}

/// Returns the threat to a character in its stance at the origin: it leads one that walks.
RecordedThreat thrown_at(const runtime::Library& library, const RecordedScene& scene,
                         const ThreatOptions& options) {
  models::Selector known = library.selector();
  if (scene.stance != 0) {
    features::CharacterState state;
    state.stance = scene.stance;
    state.idle_time_s = scene.stance_time_s;
    known.target_centres = features::predict_character(library.prepared().figure_in(state), state,
                                                       static_cast<float>(options.time_to_impact_s))
                               .target_centres;
  }
  const features::ThreatDescription threat = described(options, known);
  return {features::threat_from_description(threat, known.target_centres[threat.target], 0),
          threat.target, threat.time_to_impact_s};
}

ThreatOptions second_threat(const RespondOptions& options) {
  ThreatOptions second = options.threat;
  second.time_to_impact_s = *options.second.time_to_impact_s;
  if (second.time_to_impact_s <= options.threat.time_to_impact_s)
    throw Error("", "--second-time-to-impact must be later than --time-to-impact");
  second.azimuth = options.second.azimuth.value_or(second.azimuth);
  second.target = options.second.target.value_or(second.target);
  if (options.second.speed_mps) second.speed_mps = options.second.speed_mps;
  return second;
}

/// What a person's errors are, as often as --noise says.
runtime::PerceptionLimits limits_of(const RespondOptions& options) {
  const runtime::PerceptionLimits human = runtime::human_limits();
  const auto noise = static_cast<float>(options.noise);
  return {.reaction_delay_s = static_cast<float>(options.reaction_delay_s),
          .bearing_noise = noise * human.bearing_noise,
          .distance_noise = noise * human.distance_noise,
          .heading_noise = noise * human.heading_noise,
          .speed_noise = noise * human.speed_noise,
          .chance_to_fail = static_cast<float>(options.failure)};
}

RecordedScene scene_of(const runtime::Library& library, const RespondOptions& options) {
  const database::ClipLibrary& clips = library.clip_library();
  RecordedScene scene;
  scene.stance = stance_of(clips, options);
  scene.stance_time_s = static_cast<float>(options.at_s);
  scene.clip = clip_of(clips, options);
  scene.by_rule = options.by_rule || options.motion;
  scene.startles = options.startles;
  scene.limits = limits_of(options);
  scene.seed = options.seed;
  scene.ending = options.ending == "clip"   ? Ending::clip
                 : options.ending == "idle" ? Ending::stance
                                            : Ending::none;
  const auto add = [&](const ThreatOptions& threat) {
    scene.threats.push_back(thrown_at(library, scene, threat));
  };
  add(options.threat);
  if (options.second.time_to_impact_s) add(second_threat(options));
  return scene;
}

void add_hit(const RecordedHit& hit, Json& document) {
  const bool hits = std::isfinite(hit.contact_s);
  document["hits"] = hits;
  if (!hits) return;
  document["contact_s"] = shortest(hit.contact_s);
  document["impulse_ns"] = shortest(hit.impulse_ns);
  document["hit_body"] = motion::name_of(hit.hit_body);
}

Json document_of(const runtime::Library& library, const ResponseRecording& recording,
                 const RespondOptions& options) {
  Json document{{"file", options.out},
                {"clip", clip_name(library, recording.clip)},
                {"noticed", recording.is_noticed},
                {"target", options.threat.target},
                {"time_to_impact_s", options.threat.time_to_impact_s},
                {"duration_s", shortest(recording.motion.duration_s())},
                {"knocked_over", recording.knocked_over}};
  add_hit(recording.hits.front(), document);
  if (recording.reaction_clip)
    document["reaction_clip"] = clip_name(library, *recording.reaction_clip);
  if (recording.hits.size() > 1) add_hit(recording.hits.back(), document["second"]);
  return document;
}

std::string hit_text(const RecordedHit& hit, features::ThreatShape shape) {
  const std::string threat = "the " + std::string(name_of(shape));
  if (!std::isfinite(hit.contact_s)) return threat + " hits nothing";
  return threat + " hits at " + fixed(double{hit.contact_s}, 2) + " s with " +
         fixed(double{hit.impulse_ns}, 1) + " N s";
}

void print_text(const runtime::Library& library, const RecordedScene& scene,
                const ResponseRecording& recording, const RespondOptions& options) {
  const int kind = scene.threats.front().threat.kind;
  const features::ThreatShape shape =
      library.selector().kinds[static_cast<std::size_t>(kind)].shape;
  std::cout << printable(options.out) << ": "
            << (recording.is_noticed ? printable(clip_name(library, recording.clip))
                                     : "the threat is not noticed")
            << ", " << fixed(double{recording.motion.duration_s()}, 2) << " s; "
            << hit_text(recording.hits.front(), shape);
  if (recording.hits.size() > 1) std::cout << "; then " << hit_text(recording.hits.back(), shape);
  if (recording.reaction_clip)
    std::cout << ", then " << printable(clip_name(library, *recording.reaction_clip));
  std::cout << (recording.knocked_over ? ", which knocks the character over\n" : "\n");
}

void check_sources(const RespondOptions& options) {
  if (options.selector.empty() == !options.motion)
    throw UsageError(
        "respond needs a SELECTOR or --motion, and not both; see flinch respond --help");
  const bool by_rule = options.by_rule || options.motion;
  if (by_rule && (options.clip || options.look_ahead || options.second.time_to_impact_s))
    throw UsageError("an answer by rule takes neither --clip nor --look-ahead nor a second threat");
}

void run_respond(const RespondOptions& options) {
  check_sources(options);
  database::check_outputs({output_of(options.out)}, {options.motion.value_or(options.selector)},
                          overwrite_of(options.force));
  const runtime::Library library =
      options.motion ? library_of_motion(options) : train::load_runtime_library(options.selector);
  const RecordedScene scene = scene_of(library, options);
  lookahead::LookAheadWorkspace look_ahead;
  if (options.look_ahead) look_ahead = look_ahead_workspace(library, options.selector);
  const ResponseRecording recording = record_response(
      library, scene, options.look_ahead ? &look_ahead : nullptr, options.look_ahead.value_or(1));
  features::CharacterState start;
  start.stance = scene.stance;
  write(library, recording, options, library.prepared().stance_of(start).loop.travels());
  if (options.json) {
    print(document_of(library, recording, options));
  } else {
    print_text(library, scene, recording, options);
  }
}

std::vector<Option> scene_options(RespondOptions& options) {
  return {
      {"--start", "stance that the character is in, such as guard (default: its idle clip)",
       &options.start},
      {"--rules", "answer by the pose rules, without a clip", &options.by_rule},
      {"--startle", "by the rules: flinch first", &options.startles},
      {"--motion",
       "BVH, FBX or glTF file of a motion that the character is in, in place of SELECTOR: "
       "it answers by the rules",
       &options.motion},
      {"--at", "how far it is in its stance or motion, s", &options.at_s, Range{0, 1e4}},
      {"--clip", "clip that answers, whatever the selector would choose", &options.clip},
      {"--reaction-delay", "from seeing the threat to acting on it, s", &options.reaction_delay_s,
       Range{0, 5}},
      {"--noise", "errors in what is seen: 1 is a person's, 2 twice those", &options.noise,
       Range{0, 10}},
      {"--failure", "probability of not noticing the threat", &options.failure, Range{0, 1}},
      {"--seed", "of noise and failure", &options.seed},
      {"--end",
       "after a blow: clip, the library's that fits it, or idle, back to the stance; none: balls "
       "move nothing",
       &options.ending, OneOf{{"clip", "idle", "none"}}},
      {"--second-time-to-impact", "of a second threat, later than the first, s",
       &options.second.time_to_impact_s, Range{0.01, 10}},
      {"--second-azimuth", "its direction, degrees (default: the first one's)",
       &options.second.azimuth, Range{-360, 360}},
      {"--second-speed", "its speed, m/s (default: the first one's)", &options.second.speed_mps,
       Range{0.1, 900}},
      {"--second-target", "the part that it threatens (default: the first one's)",
       &options.second.target, OneOf{target_names()}}};
}

}  // namespace

Command respond_command() {
  auto options = std::make_shared<RespondOptions>();
  return {
      .name = "respond",
      .summary = "Write the whole response to a threat as an animation, ball included",
      .required = {{"--out",
                    "FILE.glb for Blender and glTF viewers, FILE.bvh, or FILE.svg for a "
                    "filmstrip",
                    &options->out}},
      .optional = join({{{"SELECTOR", "selector made by flinch train", &options->selector}},
                        threat_options(options->threat),
                        scene_options(*options),
                        {look_ahead_option(options->look_ahead), force_option(options->force),
                         json_option(options->json)}}),
      .notes =
          "The character is at the origin, facing the front, perceives the threats at once, and "
          "is\n"
          "hit by them as in the simulation. Threats lead a character that walks.\n\n"
          "Example:\n  flinch respond default.flinch --azimuth 40 --speed 24 --target head "
          "--out hit.glb",
      .run = [options] { run_respond(*options); }};
}

}  // namespace flinch::program
