// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "runtime/character.h"
#include "runtime/workspace.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/file_damage.h"
#include "tests/scenes/flatbuffer_mutation.h"
#include "tests/scenes/read_cost.h"

namespace flinch::runtime {
namespace {

/// A selector of few clips of few poses, so that many mutants can be tried.
std::string small_selector_file(tests::ModelKind model) {
  database::ClipLibrary library = scenes::synthetic_library();
  library.clips.resize(4);
  for (motion::Clip& clip : library.clips) {
    std::vector<motion::Pose> few;
    for (std::size_t i = 0; i < clip.motion.poses.size(); i += 15) {
      few.push_back(clip.motion.poses[i]);
    }
    clip.motion = {.rate_hz = 4, .poses = few};
    if (clip.annotation) clip.annotation->end_s = clip.motion.duration_s();
  }
  library.rate_hz = 4;
  tests::MadeUpSelector made = tests::made_up_selector(library, 30, model);
  made.selector.kinds.push_back({.name = "stone"});
  return made.file();
}

void play(const Library& library, const std::string& what) {
  Workspace workspace;
  ASSERT_EQ(workspace.reserve_memory(library.selection_bytes()), database::LoadStatus::ok);
  Character character(library);
  for (int i = 0; i < 30; ++i) {
    if (i % 10 == 0) {
      features::Threat threat;
      threat.position = {6, 0.1F * static_cast<float>(i), 1.5F};
      threat.velocity = {-12, 0, 1};
      character.perceive(threat, workspace);
    }
    character.update(0.04F);
    ASSERT_TRUE(is_sound(character.pose())) << what;
  }
}

TEST(SelectorMutant, IsRefusedOrPlaysAtTheCostOfAWholeFile) {
  const int count = tests::soak_samples(120, 20'000);  // of each model
  int read = 0;
  for (const auto model : {tests::ModelKind::svm, tests::ModelKind::knn, tests::ModelKind::knn_cost,
                           tests::ModelKind::network, tests::ModelKind::pairwise}) {
    const std::string file = small_selector_file(model);
    const std::size_t allowed = tests::ReadCost::allowance(file.size());
    int number = 0;
    const auto reads = [&](const std::string& mutant) {
      ++number;
      Library library;
      const tests::ReadCost cost;
      const database::LoadStatus status = library.load(database::bytes_of(mutant));
      cost.expect_below(allowed);
      if (status != database::LoadStatus::ok) return false;
      play(library, "model " + std::to_string(static_cast<int>(model)) + ", mutant " +
                        std::to_string(number));
      return true;
    };
    const tests::ReadCounts counts =
        tests::try_damaged_content(database::kSelectorFormat, file, count, 16,
                                   tests::FlatbufferMutation(tests::content_of(file)), reads);
    EXPECT_GT(counts.refused, count / 4);
    read += counts.read;
  }
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace flinch::runtime
