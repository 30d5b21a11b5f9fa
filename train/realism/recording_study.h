// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "models/realism.h"
#include "train/realism/push_example.h"

namespace flinch::train {

/// What a judge sees in the test of Arikan et al. 2005, section 6: a pushed motion whose realism is
/// estimated above 0.5, one that is not, or a recorded response as it is.
enum class Shown : std::uint8_t { good, bad, recording };
inline constexpr std::array kShown{Shown::good, Shown::bad, Shown::recording};
/// The name in files: "good", "bad" or "recording".
std::string_view name_of(Shown shown);

/// A motion of the test.
struct StudyMotion {
  Shown shown = Shown::recording;
  PushExample example;  ///< of a recording: the response after its own beginning
  float realism = 1;    ///< estimated; 1 for a recording
};

/// Draws one: each kind alike. A kind that does not come up in 200 tries gives way to what does.
StudyMotion draw_study_motion(const runtime::PushResponses& responses,
                              const models::RealismModel& model, features::Random& random);

/// How it is shown, at 60 Hz: played(), or the recording itself.
motion::Motion shown_motion(const runtime::PushResponses& responses, const StudyMotion& motion);

/// What judges said: is it a recording?
struct Verdicts {
  std::size_t yes = 0;
  std::size_t unsure = 0;
  std::size_t no = 0;
};
/// One per Shown.
using StudyTable = std::array<Verdicts, kShown.size()>;

/// A share with its 95 % interval.
struct ShareOfYes {
  double share = 0;
  double low = 0;
  double high = 1;
};
/// Of all answers, as the paper counts, with Wilson's interval; none without answers.
std::optional<ShareOfYes> share_of_yes(const Verdicts& verdicts);
/// The share of yes for good motions divided by that for recordings; none without either.
std::optional<double> good_against_recordings(const StudyTable& table);
/// The share of answers about pushed motions, without "unsure", that are yes for good ones and no
/// for bad ones; none without any.
std::optional<double> agreement_without_unsure(const StudyTable& table);

}  // namespace flinch::train
