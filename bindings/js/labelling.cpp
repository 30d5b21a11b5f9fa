// SPDX-License-Identifier: MIT
// A judge's answers in C.
#include "train/realism/labelling.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "bindings/js/exports.h"
#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"
#include "train/realism/recording_study.h"

namespace runtime = flinch::runtime;
namespace train = flinch::train;
using runtime::check;

struct flinch_labelling : runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0007;
  struct Content {
    explicit Content(runtime::SharedLibrary of, std::uint32_t seed)
        : library(std::move(of)),
          hash(flinch::database::hash_text(library->clip_library().hash)),
          labelling(library->push_responses(), seed) {}
    runtime::SharedLibrary library;
    std::string hash;
    train::Labelling labelling;
    train::PushExample example;    // that is shown
    flinch::motion::Motion shown;  // how
  };
  explicit flinch_labelling(std::unique_ptr<Content> made)
      : HandleHeader(kMark), content(std::move(made)) {}

  std::unique_ptr<Content> content;
};

namespace {

using Content = flinch_labelling::Content;

void play(Content& content) {
  content.example = content.labelling.example();
  content.shown = train::played(content.library->push_responses(), content.example);
}

void write(float (&to)[3], const Eigen::Vector3f& from) {
  std::copy_n(from.data(), 3, to);
}

flinch_push_example example_in_c(const train::PushExample& example) {
  flinch_push_example result{};
  result.state_clip = example.state_clip;
  result.state_s = example.state_s;
  result.place = static_cast<std::int32_t>(example.place);
  write(result.asked, example.asked);
  result.response_clip = example.answer.clip;
  result.turn = example.answer.turn;
  result.taper = example.answer.taper;
  write(result.deformation, example.answer.deformation);
  return result;
}

bool are_finite(const flinch_push_example& example) {
  const auto finite = [](float number) { return std::isfinite(number); };
  return finite(example.state_s) && finite(example.turn) && example.taper > 0 &&
         finite(example.taper) && std::ranges::all_of(example.asked, finite) &&
         std::ranges::all_of(example.deformation, finite);
}

/// The label of a motion; false where this library has no such motion.
bool to_label(const runtime::Library& library, const flinch_push_example& from, float quality,
              train::Label& label) {
  const auto& responses = library.push_responses().responses;
  const auto response =
      std::ranges::find(responses, from.response_clip, &runtime::PushResponse::clip);
  const bool is_clip = runtime::is_index(from.state_clip, library.clip_library().clips.size());
  if (!is_clip || response == responses.end() || !are_finite(from) ||
      !runtime::is_index(from.place, flinch::motion::kRoleCount) ||
      !flinch::motion::is_push_place(static_cast<flinch::motion::Role>(from.place)) ||
      !(quality >= 0 && quality <= 1)) {
    return false;
  }
  train::PushExample& example = label.example;
  example.state_clip = from.state_clip;
  example.state_s = from.state_s;
  example.place = static_cast<flinch::motion::Role>(from.place);
  example.asked = Eigen::Vector3f(from.asked);
  example.answer.response = static_cast<int>(response - responses.begin());
  example.answer.clip = from.response_clip;
  example.answer.turn = from.turn;
  example.answer.taper = from.taper;
  example.answer.deformation = Eigen::Vector3f(from.deformation);
  label.quality = quality;
  return true;
}

}  // namespace

flinch_status flinch_labelling_create(const flinch_library* library, uint32_t seed,
                                      flinch_labelling** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  if (library->content->push_responses().responses.empty()) return FLINCH_BAD_PUSH;
  return runtime::make_handle(out, [&] {
    auto made = std::make_unique<Content>(library->content, seed);
    play(*made);
    return made;
  });
}

flinch_status flinch_labelling_free(flinch_labelling* labelling) {
  return runtime::free_handle(labelling);
}

flinch_status flinch_labelling_add(flinch_labelling* labelling, const flinch_push_example* examples,
                                   const float* qualities, int32_t count) try {
  if (const flinch_status status = check(labelling)) return status;
  if (count < 0 || (count > 0 && (examples == nullptr || qualities == nullptr)))
    return FLINCH_NULL_POINTER;
  std::vector<train::Label> labels(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!to_label(*labelling->content->library, examples[i], qualities[i], labels[i]))
      return FLINCH_BAD_INDEX;
  }
  labelling->content->labelling.add(labels);
  return FLINCH_OK;
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_labelling_question(const flinch_labelling* labelling, flinch_question* out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = check(labelling)) return status;
  const Content& content = *labelling->content;
  const train::Labelling& asked = content.labelling;
  const train::RecentAgreement& agreement = asked.agreement();
  *out = {};
  out->estimate = asked.estimate().value_or(-1);
  out->frame_count = static_cast<std::int32_t>(content.shown.poses.size());
  out->push_s = train::push_time_s(content.example);
  out->label_count = static_cast<std::int32_t>(asked.label_count());
  out->compared = static_cast<std::int32_t>(agreement.count);
  out->same_side = static_cast<float>(agreement.same_side);
  out->mean_error = static_cast<float>(agreement.mean_error);
  out->is_agreement = agreement.is_enough ? 1 : 0;
  return FLINCH_OK;
}

flinch_status flinch_labelling_example(const flinch_labelling* labelling,
                                       flinch_push_example* out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = check(labelling)) return status;
  *out = example_in_c(labelling->content->example);
  return FLINCH_OK;
}

flinch_status flinch_labelling_pose(const flinch_labelling* labelling, int32_t frame,
                                    flinch_pose* out) {
  if (const flinch_status status = check(labelling, out)) return status;
  const auto& poses = labelling->content->shown.poses;
  if (!runtime::is_index(frame, poses.size())) return FLINCH_BAD_INDEX;
  runtime::write_struct(*out, runtime::to_c(poses[static_cast<std::size_t>(frame)]));
  return FLINCH_OK;
}

flinch_status flinch_labelling_judge(flinch_labelling* labelling, float quality) try {
  if (const flinch_status status = check(labelling)) return status;
  if (!(quality >= 0 && quality <= 1)) return FLINCH_BAD_INDEX;
  labelling->content->labelling.judge(quality);
  return flinch_labelling_skip(labelling);
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_labelling_skip(flinch_labelling* labelling) try {
  if (const flinch_status status = check(labelling)) return status;
  labelling->content->labelling.next();
  play(*labelling->content);
  return FLINCH_OK;
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_labelling_study(flinch_labelling* labelling, uint32_t seed, uint32_t number,
                                     int32_t* shown, float* realism) try {
  if (shown == nullptr || realism == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = check(labelling)) return status;
  Content& content = *labelling->content;
  const auto& responses = content.library->push_responses();
  const flinch::models::RealismModel* model = content.library->push_model().realism;
  if (model == nullptr) return FLINCH_BAD_PUSH;
  flinch::features::Random random(seed, flinch::features::RandomStream::realism, number);
  const train::StudyMotion motion = train::draw_study_motion(responses, *model, random);
  content.example = motion.example;
  content.shown = train::shown_motion(responses, motion);
  *shown = static_cast<std::int32_t>(motion.shown);
  *realism = motion.realism;
  return FLINCH_OK;
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

const char* flinch_labelling_library(const flinch_labelling* labelling) {
  return check(labelling) == FLINCH_OK ? labelling->content->hash.c_str() : nullptr;
}
