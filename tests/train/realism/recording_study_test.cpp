// SPDX-License-Identifier: MIT
#include "train/realism/recording_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/push/push_scene.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"
#include "train/realism/label_file.h"
#include "train/realism/proxy_judge.h"
#include "train/realism/realism_fit.h"

namespace flinch::train {
namespace {

using testing::HasSubstr;

// Figure 5 of Arikan et al. 2005.
constexpr StudyTable kUndergraduates{Verdicts{807, 65, 511}, Verdicts{227, 47, 507},
                                     Verdicts{240, 29, 126}};
constexpr StudyTable kGraduates{Verdicts{39, 0, 39}, Verdicts{2, 0, 38}, Verdicts{12, 0, 11}};

TEST(RecordingStudy, GivesThePapersShares) {
  EXPECT_NEAR(share_of_yes(kUndergraduates[0])->share, 0.584, 5e-4);
  EXPECT_NEAR(share_of_yes(kUndergraduates[1])->share, 0.291, 5e-4);
  EXPECT_NEAR(share_of_yes(kUndergraduates[2])->share, 0.608, 5e-4);
  EXPECT_NEAR(share_of_yes(kGraduates[1])->share, 0.05, 1e-9);
  EXPECT_NEAR(*good_against_recordings(kUndergraduates), 0.96, 5e-3);
  EXPECT_NEAR(*good_against_recordings(kGraduates), 0.96, 5e-3);
  EXPECT_NEAR(*agreement_without_unsure(kUndergraduates), 0.64, 5e-3);
  EXPECT_NEAR(*agreement_without_unsure(kGraduates), 0.65, 5e-3);
}

TEST(RecordingStudy, IntervalIsWilsons) {
  // Both ends solve |p - share| = z sqrt(p (1 - p) / n).
  for (const Verdicts& verdicts : {Verdicts{3, 1, 6}, Verdicts{0, 0, 7}, Verdicts{40, 0, 2}}) {
    const ShareOfYes share = *share_of_yes(verdicts);
    const auto n = static_cast<double>(verdicts.yes + verdicts.unsure + verdicts.no);
    for (const double p : {share.low, share.high}) {
      EXPECT_NEAR(std::abs(p - share.share), 1.959964 * std::sqrt(std::max(p * (1 - p), 0.0) / n),
                  1e-9);
    }
    EXPECT_LE(share.low, share.share);
    EXPECT_GE(share.high, share.share);
  }
  EXPECT_FALSE(share_of_yes({}));
  EXPECT_FALSE(good_against_recordings({}));
  EXPECT_FALSE(agreement_without_unsure({}));
}

TEST(DrawStudyMotion, ShowsEveryKindAndRecordingsAsTheyAre) {
  const tests::PushScene scene;
  // What deforms little is good.
  std::vector<Label> labels;
  for (std::uint64_t i = 0; i < 120; ++i) {
    features::Random random(7, features::RandomStream::realism, i);
    const PushExample example = sample_example(scene.responses, random);
    labels.push_back({example, example.answer.deformation.norm() < 0.8F ? 1.0F : 0.0F, "", ""});
  }
  const models::RealismModel model = fit_realism(
      configurations_of(scene.responses, std::move(labels)), RealismKind::ours, "made up");
  std::array<int, kShown.size()> counts{};
  for (std::uint64_t number = 0; number < 90; ++number) {
    features::Random random(2, features::RandomStream::realism, number);
    const StudyMotion drawn = draw_study_motion(scene.responses, model, random);
    ++counts[static_cast<std::size_t>(drawn.shown)];
    if (drawn.shown != Shown::recording) {
      EXPECT_EQ(drawn.realism > 0.5F, drawn.shown == Shown::good);
      continue;
    }
    const motion::Motion shown = shown_motion(scene.responses, drawn);
    const motion::Motion& clip = scene.library.clip(drawn.example.answer.clip).motion;
    const float push_s = push_time_s(drawn.example);
    EXPECT_NEAR(shown.duration_s() - push_s, clip.duration_s() - drawn.example.state_s, 0.02F);
    const motion::Pose expected = motion::sample(clip, drawn.example.state_s);
    const auto frame = static_cast<std::size_t>(std::lround(60 * push_s));
    EXPECT_LT((shown.poses[frame].root_position - expected.root_position).norm(), 1e-4F);
  }
  for (const int count : counts) EXPECT_GT(count, 15);
}

TEST(StudyFile, IsReadLineByLineAndRefusedInOneLine) {
  const tests::PushScene scene;
  const tests::TemporaryFolder folder;
  const std::string header = "{\"format\":\"flinch study 1\",\"library\":\"" +
                             database::hash_text(scene.library.hash) + "\"}\n";
  const auto line = [](const std::string& judge, const std::string& shown,
                       const std::string& answer) {
    return "{\"judge\":\"" + judge + "\",\"shown\":\"" + shown + "\",\"answer\":\"" + answer +
           "\"}\n";
  };
  const auto read = [&](const std::string& text) {
    folder.write("a.flinchstudy", text);
    return read_study(folder / "a.flinchstudy", scene.library);
  };
  const std::string two = line("Eva", "good", "yes") + line("Otto", "recording", "unsure");
  const StudyFile study = read(header + two + header + line("Eva", "bad", "no"));
  EXPECT_EQ(study.judges, 2U);
  EXPECT_EQ(study.table[0].yes, 1U);
  EXPECT_EQ(study.table[1].no, 1U);
  EXPECT_EQ(study.table[2].unsure, 1U);
  const auto message = [&](const std::string& text) {
    return tests::error_of([&] { read(text); });
  };
  EXPECT_THAT(message(header + line("Eva", "nice", "yes")), HasSubstr(":2: is no answer: shown"));
  EXPECT_THAT(message(header + two + line("Eva", "bad", "maybe")),
              HasSubstr(":4: is no answer: answer"));
  EXPECT_THAT(message(header + two.substr(0, two.size() - 4)), HasSubstr(":3: is cut short"));
  EXPECT_THAT(message("{\"format\":\"flinch labels 1\"}\n"), HasSubstr("not a file of the test"));
}

}  // namespace
}  // namespace flinch::train
