// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <memory>

#include "database/export/gltf_writer.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "program/command.h"
#include "program/printable.h"
#include "program/table.h"
#include "runtime/character.h"
#include "train/fit/selector_reader.h"

namespace flinch::program {

namespace {

constexpr float kFramesPerSecond = 60;
constexpr float kStandBefore_s = 0.5F;  // before the push
constexpr float kIdleAfter_s = 0.5F;    // after the character is back
constexpr float kLongestPush_s = 20;

struct PushOptions {
  std::string selector;
  std::string out;
  std::string at{"chest"};
  double from = 0;
  double speed = 1;
  std::optional<double> repeat_s;
  bool force = false;
  bool json = false;
};

std::vector<std::string> place_names() {
  std::vector<std::string> names;
  for (const motion::Role place : motion::kPushPlaces)
    names.emplace_back(motion::push_place_name(place));
  return names;
}

/// What happened, with the motion that shows it.
struct PushRecording {
  motion::Motion motion;
  std::vector<runtime::PushCandidate> candidates;  ///< of the first push
  float reached_mps = 0;  ///< fastest of the pushed joint along the push, over 1/15 s
};

/// Pushes a character that stands at the origin and faces +X, once or twice.
class PushedCharacter {
 public:
  PushedCharacter(const runtime::Library& library, const PushOptions& options)
      : library_(library), options_(options), character_(library) {
    if (workspace_.reserve_memory(library.selection_bytes()) != database::LoadStatus::ok)
      throw Error("", "there is not enough memory");
    recording_.motion.rate_hz = kFramesPerSecond;
  }

  PushRecording recorded() {
    for (float time_s = 0; time_s < kStandBefore_s; time_s += 1 / kFramesPerSecond) step();
    push();
    const auto all = character_.push_candidates();
    recording_.candidates.assign(all.begin(), all.end());
    float since_s = 0;
    bool again = options_.repeat_s.has_value();
    float idle_s = 0;
    while (since_s < kLongestPush_s && idle_s < kIdleAfter_s) {
      step();
      since_s += 1 / kFramesPerSecond;
      if (again && since_s >= static_cast<float>(*options_.repeat_s)) {
        push();
        again = false;
      }
      idle_s = character_.phase() == runtime::Phase::idle ? idle_s + 1 / kFramesPerSecond : 0;
    }
    recording_.reached_mps = reached();
    return std::move(recording_);
  }

 private:
  Eigen::Vector3f velocity() const {
    const auto from = static_cast<float>(motion::radians(options_.from));
    return -static_cast<float>(options_.speed) * Eigen::Vector3f(std::cos(from), std::sin(from), 0);
  }
  motion::Role place() const { return *motion::push_place_named(options_.at); }

  void step() {
    recording_.motion.poses.push_back(character_.pose());
    character_.update(1 / kFramesPerSecond);
  }

  void push() {
    const runtime::Status status = character_.push(place(), velocity(), workspace_);
    if (status == runtime::Status::ok) return;
    std::string why = message_of(status);
    if (status == runtime::Status::no_good_answer) {
      const runtime::PushCandidate& best = character_.push_candidates().front();
      why += ": the best, " + library_.clip_library().clip(best.clip).name + ", has a realism of " +
             fixed(double{best.realism}, 2) + "; push less, or from where recorded pushes come";
    }
    throw Error(options_.selector, why);
  }

  float reached() const {
    const motion::Skeleton& skeleton = library_.clip_library().character.skeleton;
    const Eigen::Vector3f along = velocity().normalized();
    constexpr std::size_t kFrames = 4;
    std::vector<Eigen::Vector3f> places;
    for (const motion::Pose& pose : recording_.motion.poses)
      places.push_back(motion::forward_kinematics(skeleton, pose).position[place()]);
    float most = 0;
    for (std::size_t k = kFrames; k < places.size(); ++k)
      most =
          std::max(most, along.dot(places[k] - places[k - kFrames]) * kFramesPerSecond / kFrames);
    return most;
  }

  const runtime::Library& library_;
  const PushOptions& options_;
  runtime::Character character_;
  runtime::Workspace workspace_;
  PushRecording recording_;
};

void print_text(const runtime::Library& library, const PushOptions& options,
                const PushRecording& recording) {
  using enum Table::Align;
  const auto name = [&](int clip) { return library.clip_library().clip(clip).name; };
  Table table({{"response"},
               {"realism", right},
               {"turn", right},
               {"deformation, m/s", right},
               {"taper, 1/m2", right}});
  for (const runtime::PushCandidate& candidate : recording.candidates) {
    table.add({name(candidate.clip), fixed(double{candidate.realism}, 2),
               fixed(motion::degrees(double{candidate.turn}), 0),
               fixed(double{candidate.deformation.norm()}, 2), fixed(double{candidate.taper}, 0)});
  }
  std::cout << printable(options.out) << ": " << printable(name(recording.candidates[0].clip))
            << ", " << fixed(double{recording.motion.duration_s()}, 2) << " s; the " << options.at
            << " reaches " << fixed(double{recording.reached_mps}, 2) << " m/s\n"
            << "judged by " << printable(library.selector().realism->judge) << "\n\n"
            << table.text();
}

Json document_of(const runtime::Library& library, const PushOptions& options,
                 const PushRecording& recording) {
  Json candidates = Json::array();
  for (const runtime::PushCandidate& candidate : recording.candidates) {
    const Eigen::Vector3f& m = candidate.deformation;
    candidates.push_back({{"clip", library.clip_library().clip(candidate.clip).name},
                          {"realism", shortest(candidate.realism)},
                          {"turn_degrees", shortest(motion::degrees(candidate.turn))},
                          {"deformation_mps", {shortest(m.x()), shortest(m.y()), shortest(m.z())}},
                          {"taper", shortest(candidate.taper)}});
  }
  return {{"file", options.out},
          {"clip", candidates[0]["clip"]},
          {"place", options.at},
          {"duration_s", shortest(recording.motion.duration_s())},
          {"reached_mps", shortest(recording.reached_mps)},
          {"judge", library.selector().realism->judge},
          {"candidates", candidates}};
}

void run_push(const PushOptions& options) {
  if (!options.out.ends_with(".glb"))
    throw Error(options.out, "unknown kind of file; use a name that ends in .glb");
  database::check_outputs({{options.out, database::FileKind::gltf, database::kGlbMark}},
                          {options.selector}, overwrite_of(options.force));
  const runtime::Library library = train::load_runtime_library(options.selector);
  const PushRecording recording = PushedCharacter(library, options).recorded();
  database::write_glb(options.out, library.clip_library().character, recording.motion);
  if (options.json) {
    print(document_of(library, options, recording));
  } else {
    print_text(library, options, recording);
  }
}

}  // namespace

Command push_command() {
  auto options = std::make_shared<PushOptions>();
  return {.name = "push",
          .summary = "Push a character and write its answer as an animation",
          .required = {{"SELECTOR", "selector with a realism model (flinch train-realism)",
                        &options->selector},
                       {"--out", "FILE.glb for Blender and glTF viewers", &options->out}},
          .optional = {{"--at", "joint that is pushed", &options->at, OneOf{place_names()}},
                       {"--from", "where the push comes from, degrees: 0 is the front, 90 the left",
                        &options->from, Range{-360, 360}},
                       {"--speed", "velocity that the joint shall reach, m/s", &options->speed,
                        Range{0.05, 20}},
                       {"--repeat", "push a second time, this many seconds after the first",
                        &options->repeat_s, Range{0, 10}},
                       force_option(options->force),
                       json_option(options->json)},
          .notes =
              "The character stands at the origin and faces the front.\n\n"
              "Example:\n  flinch push real.flinch --at left_shoulder --from 120 --speed 1.2 "
              "--out push.glb",
          .run = [options] { run_push(*options); }};
}

}  // namespace flinch::program
