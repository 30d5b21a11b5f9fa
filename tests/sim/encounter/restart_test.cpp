// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>

#include "sim/encounter/encounter.h"
#include "tests/scenes/allocation_count.h"
#include "tests/sim/random_hits.h"

namespace flinch::sim {
namespace {

/// Half a second in which a ball meets a figure that stands.
motion::PerBody<double> impulses(Encounter<TreeScene>& encounter, const ReferenceState& standing) {
  while (encounter.time_s() < 0.5) {
    const double step_s = encounter.begin_step(standing, 0.5 - encounter.time_s());
    encounter.end_step(standing, standing, step_s);
  }
  return encounter.impulse();
}

TEST(Encounter, ARestartIsANewEncounterWithoutAllocations) {
  const motion::Physique character = motion::default_character();
  const FigureModel figure_model(character);
  const ReferenceState standing = state_at_rest(figure_model.skeleton, figure_model.model,
                                                scenes::standing(figure_model.skeleton));
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const SimulationOptions options;
  Encounter<TreeScene> used(figure_model, options, 0, figure_model, standing.body, nullptr,
                            options.gravity_mps2);
  int hits = 0;
  for (scenes::Hit hit : scenes::random_hits(character, motions, 20, 3)) {
    hit.ball.position = Eigen::Vector3d(0, 0, 1.2) - 0.2 * hit.ball.velocity;
    Encounter<TreeScene> fresh(figure_model, options, 0, figure_model, standing.body, &hit.ball,
                               options.gravity_mps2);
    const std::size_t allocations = tests::allocation_count();
    used.restart(0, standing.body, &hit.ball);
    const motion::PerBody<double> found = impulses(used, standing);
    EXPECT_EQ(tests::allocation_count(), allocations);
    const motion::PerBody<double> expected = impulses(fresh, standing);
    EXPECT_EQ(std::memcmp(&found, &expected, sizeof found), 0);
    EXPECT_EQ(used.first_contact_s(), fresh.first_contact_s());
    hits += std::isfinite(used.first_contact_s());
  }
  EXPECT_GT(hits, 10);
}

}  // namespace
}  // namespace flinch::sim
