// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "reaction/reaction.h"
#include "sim/ode/ode_simulator.h"
#include "tests/sim/random_hits.h"

// Characters that are about to be hit, for the tests and benchmarks of reactions.
namespace flinch::scenes {

/// A motion, a ball, and the time in the motion at which the reaction begins and learns of the
/// ball.
struct ReactionCase {
  const motion::Motion* motion;
  features::Ball ball;
  double begin_s;
};

constexpr double kLead_s = 0.02;  ///< from begin() to the contact
constexpr double kFrame_s = 1.0 / 60;

inline motion::Pose pose_at(const motion::Motion& motion, double time_s) {
  return motion::sample(motion, static_cast<float>(time_s));
}

/// Returns those balls of random_hits that hit, with `mass_kg`.
inline std::vector<ReactionCase> random_reaction_cases(const motion::Physique& character,
                                                       const std::vector<NamedMotion>& motions,
                                                       std::size_t count, unsigned seed,
                                                       double mass_kg = 0.27) {
  const sim::OdeSimulator simulator(character, {});
  std::vector<ReactionCase> cases;
  for (const Hit& hit : random_hits(character, motions, count, seed)) {
    const motion::Motion& motion = motions[hit.motion].motion;
    const double contact_s = simulator.simulate(motion, &hit.ball, 1).first_contact_s;
    const double begin_s = contact_s - kLead_s;
    if (!std::isfinite(contact_s) || begin_s < kFrame_s) continue;
    features::Ball ball = hit.ball;
    const Eigen::Vector3d gravity(0, 0, -sim::SimulationOptions{}.gravity_mps2);
    ball.position += begin_s * ball.velocity + begin_s * begin_s / 2 * gravity;
    ball.velocity += begin_s * gravity;
    ball.mass_kg = mass_kg;
    cases.push_back({&motion, ball, begin_s});
  }
  return cases;
}

inline reaction::ReactionStatus begin(reaction::Reaction& reaction,
                                      const ReactionCase& reaction_case) {
  return reaction.begin(pose_at(*reaction_case.motion, reaction_case.begin_s - kFrame_s),
                        pose_at(*reaction_case.motion, reaction_case.begin_s), kFrame_s,
                        &reaction_case.ball);
}

}  // namespace flinch::scenes
