// SPDX-License-Identifier: MIT
#include "train/realism/recording_study.h"

#include <cmath>

#include "train/realism/realism_fit.h"

namespace flinch::train {
namespace {

constexpr int kTries = 200;

const Verdicts& of(const StudyTable& table, Shown shown) {
  return table[static_cast<std::size_t>(shown)];
}

float estimated(const runtime::PushResponses& responses, const models::RealismModel& model,
                const PushExample& example) {
  const LabelledConfigurations one = configurations_of(responses, {{example, 0, "", ""}});
  return models::estimate_realism(model, features_of(model, one, 0));
}

StudyMotion recording(const runtime::PushResponses& responses, features::Random& random) {
  const auto index = static_cast<std::size_t>(random.index(responses.responses.size()));
  const runtime::PushResponse& response = responses.responses[index];
  StudyMotion motion;
  motion.example.state_clip = response.clip;
  motion.example.state_s = response.contact_s;
  motion.example.place = responses.library->clip(response.clip).push->place;
  motion.example.asked = response.velocity[runtime::push_place_index(motion.example.place)];
  motion.example.answer.response = static_cast<int>(index);
  motion.example.answer.clip = response.clip;
  motion.example.answer.taper = 1;
  return motion;
}

}  // namespace

std::string_view name_of(Shown shown) {
  switch (shown) {
    case Shown::good:
      return "good";
    case Shown::bad:
      return "bad";
    case Shown::recording:
      break;
  }
  return "recording";
}

StudyMotion draw_study_motion(const runtime::PushResponses& responses,
                              const models::RealismModel& model, features::Random& random) {
  const Shown wanted = kShown[static_cast<std::size_t>(random.index(kShown.size()))];
  if (wanted == Shown::recording) return recording(responses, random);
  StudyMotion motion;
  for (int k = 0; k < kTries; ++k) {
    motion.example = sample_example(responses, random);
    motion.realism = estimated(responses, model, motion.example);
    motion.shown = motion.realism > runtime::kGoodRealism ? Shown::good : Shown::bad;
    if (motion.shown == wanted) break;
  }
  return motion;
}

motion::Motion shown_motion(const runtime::PushResponses& responses, const StudyMotion& motion) {
  if (motion.shown != Shown::recording) return played(responses, motion.example);
  const motion::Motion& clip = responses.library->clip(motion.example.answer.clip).motion;
  motion::Motion shown;
  const float begin_s = motion.example.state_s - push_time_s(motion.example);
  for (int k = 0;; ++k) {
    const float time_s = begin_s + static_cast<float>(k) / shown.rate_hz;
    if (time_s > clip.duration_s()) return shown;
    shown.poses.push_back(motion::sample(clip, time_s));
  }
}

// Wilson 1927: the shares p for which what was seen is within z standard deviations.
std::optional<ShareOfYes> share_of_yes(const Verdicts& verdicts) {
  constexpr double kZ = 1.959964;
  const auto count = static_cast<double>(verdicts.yes + verdicts.unsure + verdicts.no);
  if (!(count > 0)) return std::nullopt;
  const double share = static_cast<double>(verdicts.yes) / count;
  const double z2 = kZ * kZ / count;
  const double centre = (share + z2 / 2) / (1 + z2);
  const double half = kZ / (1 + z2) * std::sqrt(share * (1 - share) / count + z2 / (4 * count));
  return ShareOfYes{share, centre - half, centre + half};
}

std::optional<double> good_against_recordings(const StudyTable& table) {
  const auto good = share_of_yes(of(table, Shown::good));
  const auto recorded = share_of_yes(of(table, Shown::recording));
  if (!good || !recorded || !(recorded->share > 0)) return std::nullopt;
  return good->share / recorded->share;
}

std::optional<double> agreement_without_unsure(const StudyTable& table) {
  const Verdicts& good = of(table, Shown::good);
  const Verdicts& bad = of(table, Shown::bad);
  const auto count = static_cast<double>(good.yes + good.no + bad.yes + bad.no);
  if (!(count > 0)) return std::nullopt;
  return static_cast<double>(good.yes + bad.no) / count;
}

}  // namespace flinch::train
