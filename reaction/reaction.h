// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "reaction/recovery.h"
#include "sim/rehearsal/simulator.h"

namespace flinch::sim {
struct FigureModel;
}

namespace flinch::reaction {

/// The physical figure of a character, made once at loading and shared by all who look like it, on
/// any threads. Never changes. Nothing if memory ran out.
std::shared_ptr<const sim::FigureModel> make_figure_model(
    const motion::Physique& character) noexcept;

/// The longest frame of a reaction, s.
inline constexpr double kMaxReactionFrame_s = 0.1;

/// How a character takes a blow.
struct ReactionOptions {
  RecoverySchedule schedule;    ///< simulation_only_s from 0.05 to 0.5
  double stiffness = 1.0 / 16;  ///< share of the trainer's figure's, in (0, 1]
};

enum class ReactionStatus : std::uint8_t {
  ok,
  not_begun,    ///< advance before begin
  bad_options,  ///< out of their ranges, or no figure
  bad_time,     ///< dt not in (0, 0.1] s
  bad_pose,     ///< not finite, or rotations not unit (to 1e-3)
  bad_ball,     ///< not finite, or mass, radius or speed beyond what can be simulated
  failed,       ///< the physics engine failed: the motion returned to is shown from now on
};
/// What it means, for people; never null.
const char* message_of(ReactionStatus status) noexcept;

enum class ReactionPhase : std::uint8_t {
  none,          ///< not begun
  waiting,       ///< simulated; the ball has not hit yet
  struck,        ///< hit; the simulation has the figure alone
  recovering,    ///< part one: over from the simulation to the motion
  returning,     ///< part two: the motion over to what it returns to; nothing is simulated
  over,          ///< the motion returned to is all that is shown
  knocked_over,  ///< out of balance beyond a step: it falls, until the caller does something else
};

/// One character's reaction to a ball: the trainer's figure, contacts and laws (see OdeEncounter),
/// tracking the motion that the kinematic response plays with weakened springs, so that the blow
/// shows, and the double blend back. docs/reaction.md says more.
///
/// Holds its own world. Equal calls give equal bits, whatever else is simulated and on whatever
/// threads; one object must not be called by two threads at a time. Nothing throws. After begin,
/// nothing of ours allocates; the physics engine may.
class Reaction {
 public:
  explicit Reaction(std::shared_ptr<const sim::FigureModel> figure,
                    const ReactionOptions& options = {}) noexcept;
  ~Reaction();
  Reaction(Reaction&&) noexcept;
  Reaction& operator=(Reaction&&) noexcept;

  /// Takes the character over at its pose `now`, to which it came from `before` in `dt_s`, at the
  /// first contact or, better, up to 0.3 s before it: where the ball has not hit by then, it is
  /// given back as after a contact. May be called at any time, also during a reaction. Bad input
  /// leaves things as they were.
  ReactionStatus begin(const motion::Pose& before, const motion::Pose& now, double dt_s,
                       const sim::Ball* ball) noexcept;

  /// Goes on by `dt_s` (above 0, at most kMaxReactionFrame_s, uneven as it may be). `wanted` is
  /// where the motion that the character protects itself with is by then, `returning` where the one
  /// is that it returns to; they may be the same. Bad input leaves things as they were.
  ReactionStatus advance(double dt_s, const motion::Pose& wanted,
                         const motion::Pose& returning) noexcept;

  /// What to show. No bone is stretched; clavicles and toes are those of the motion.
  const motion::Pose& pose() const noexcept;
  ReactionPhase phase() const noexcept;
  /// Where the ball is by now and how it moves; as it was given to begin where there is none. It
  /// flies and bounces on until the phase is over.
  sim::Ball ball() const noexcept;
  /// When the ball first touched the figure, s from begin; infinite if it has not.
  double contact_s() const noexcept;
  /// Impulse that each body took, N·s; see SimulationResult.
  motion::PerBody<double> impulse() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace flinch::reaction
