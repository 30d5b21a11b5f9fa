// SPDX-License-Identifier: MIT
#pragma once

#include "features/ball.h"
#include "sim/body_set.h"

namespace flinch::sim {

/// Version of the simulation's laws. Raised when the same options give other impulses, so that
/// stores of different laws are not continued or merged.
/// 5: feet that leave a stance turn on their heels, and what hardly bounces rests in longer steps.
/// 4: feet that hip and ankle cannot follow roll over their soles; 3 bent the ankles.
/// 3: a step ends at a contact on its path; 2 approached it in contact steps.
/// 2: friction is bounded along the velocity of sliding; 1 bounded it along the world's axes.
inline constexpr int kLawVersion = 5;

/// How a step ends at a contact of ball and figure.
enum class ContactSearch : unsigned char {
  /// A whole step is taken, the contact found on its path, and the step ends there: the fewest
  /// steps.
  on_path,
  /// Contact steps while the ball may touch something: motion near a contact that a game can show.
  by_short_steps,
};

/// The figure that tracks a motion.
enum class FigureKind : unsigned char {
  people,    ///< joints, limits and strengths of people
  waist_up,  ///< the character of Rose (2006), appendix A: see sim/figure/waist_up.h
};

/// How to simulate. The defaults are those of the shipped selectors; docs/simulation.md has the
/// study behind them.
struct SimulationOptions {
  double free_step_s = 1.0 / 60;       ///< step while the ball touches nothing, s
  double contact_step_s = 1.0 / 2000;  ///< step of a contact, s
  /// Longest step of a contact in which something that hardly bounces (kMaxRestingBounce) rests on
  /// the body that it has hit: it is pushed, and does not strike. Only with ContactSearch::on_path.
  double resting_step_s = 1.0 / 60;
  ContactSearch contact_search = ContactSearch::on_path;
  double gravity_mps2 =
      features::kGravity_mps2;      ///< of the figure, downwards; balls have their own
  BodySet ball_meets = kAllBodies;  ///< the ball passes through other bodies
  bool keeps_places = false;        ///< whether results tell where each body was hit
  bool measures_limits = false;     ///< whether results tell how far joints exceed their limits
  FigureKind figure = FigureKind::people;
  BodySet limp_joints = 0;  ///< joints to the parents of these bodies have limits and no springs
};

}  // namespace flinch::sim
