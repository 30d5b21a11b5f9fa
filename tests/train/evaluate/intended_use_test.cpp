// SPDX-License-Identifier: MIT
#include "train/evaluate/intended_use.h"

#include <gtest/gtest.h>

#include "motion/rotation.h"

namespace flinch::train {
namespace {

using motion::Target;

/// A threat to `target` from `degrees`.
Observation threat_to(Target target, float degrees) {
  Observation observation;
  observation.scenario.target = target;
  const float azimuth = motion::radians(degrees);
  observation.scenario.threat.velocity = {-20 * std::cos(azimuth), -20 * std::sin(azimuth), 0};
  return observation;
}

StoreHeader header_with(std::vector<models::ClipSummary> clips) {
  StoreHeader header;
  header.clips = std::move(clips);
  header.idle = 0;
  return header;
}

TEST(IntendedUse, CountsClipsMadeForAnotherTargetOrDirection) {
  const StoreHeader header =
      header_with({{"idle", std::nullopt},
                   {"duck_from_front", motion::Annotation{.target = Target::head, .direction = 0}},
                   {"block_from_left", motion::Annotation{.target = Target::trunk,
                                                          .direction = motion::radians(90.0F)}}});
  const std::vector<Observation> observations{
      threat_to(Target::head, 0),     threat_to(Target::trunk, 0),  threat_to(Target::head, 135),
      threat_to(Target::trunk, -170), threat_to(Target::head, 134), threat_to(Target::legs, 180),
      threat_to(Target::trunk, -90),  threat_to(Target::head, -45)};
  const std::vector<int> chosen{1, 1, 1, 1, 1, 0, 2, 2};
  const IntendedUse use = intended_use(header, observations, chosen);
  EXPECT_DOUBLE_EQ(use.other_target, 3 / 8.0);   // numbers 1, 3 and 7
  EXPECT_DOUBLE_EQ(use.far_direction, 4 / 8.0);  // numbers 2, 3, 6 and 7
  EXPECT_DOUBLE_EQ(use.luck, 2 / 8.0);           // numbers 3 and 7
}

TEST(IntendedUse, TurnsDirectionsWithTheCharacter) {
  const StoreHeader header = header_with(
      {{"idle", std::nullopt},
       {"duck_from_front", motion::Annotation{.target = Target::head, .direction = 0}}});
  Observation observation = threat_to(Target::head, 180);
  observation.scenario.state.facing = motion::radians(180.0F);
  const std::vector<int> chosen{1};
  EXPECT_EQ(intended_use(header, std::span(&observation, 1), chosen).far_direction, 0);
}

}  // namespace
}  // namespace flinch::train
