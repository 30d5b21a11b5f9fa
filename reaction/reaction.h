// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "features/ball.h"
#include "motion/body.h"
#include "motion/clip.h"

namespace flinch::sim {
struct FigureModel;  // opaque
}

namespace flinch::reaction {

/// The physical figure of a character: 17 bodies with masses, outlines and joint limits. Make it
/// once at loading; all characters of the same physique may share it on any threads, since it never
/// changes. Null if memory ran out. Allocates; throws nothing.
std::shared_ptr<const sim::FigureModel> make_figure_model(
    const motion::Physique& character) noexcept;

/// The longest frame of a reaction, s.
inline constexpr double kMaxReactionFrame_s = 0.1;

/// Bounds of the balls that a reaction simulates. The solver fails for mass ratios that are too
/// large; the other bounds exclude meaningless values.
inline constexpr double kMinBallMass_kg = 1e-3;    ///< the lightest, kg
inline constexpr double kMaxBallMass_kg = 1000;    ///< the heaviest, kg
inline constexpr double kMinBallRadius_m = 1e-3;   ///< the smallest, m
inline constexpr double kMaxBallRadius_m = 10;     ///< the largest, m
inline constexpr double kMaxBallSpeed_mps = 1000;  ///< the fastest, m/s

/// The schedule of the return from a hit to animation: the double blend of "Anticipating impacts",
/// sections 4.1.3 and 4.2. Physics moves the character alone for a time A after the contact. With
/// E(s) = 3 s^2 - 2 s^3 of s clamped to [0, 1], the pose at time t after the first contact is
///
///     (1 - a) simulated + a destination,      a = E((t - A) / 0.26 s)               (part one)
///     destination = (1 - b) sustained + b returning,  b = E((t - B) / L)            (part two)
///
/// The paper gives the lengths of both parts, 0.26 and 0.375 s, and says that the destination has
/// gone 25 % of its way when part one ends. One ease over both parts does all that: E(q) = 1/4 at
/// q = 1/2 - sin(10 degrees), so that
///
///     L = 0.375 s / (1 - q) = 0.557 s,      B = A + 0.26 s - q L = A + 0.078 s.
///
/// The sustained pose is held until B: for 1/3 s in the paper, of which the part beyond A + 0.078 s
/// lies before the contact. Both weights start and end with zero velocity, so the result is as
/// smooth as the simulation and the motions are.
struct RecoverySchedule {
  double simulation_only_s = 0.075;  ///< A; the paper leaves 0.05 to 0.1 s to the animator
};

/// How a character takes a hit.
struct ReactionOptions {
  RecoverySchedule schedule;  ///< its simulation_only_s from 0.05 to 0.5
  /// Stiffness of the joints as a fraction of that in training, in (0, 1]. Low values let the hit
  /// show.
  double stiffness = 1.0 / 16;
};

/// The result of a call to a reaction.
enum class ReactionStatus : std::uint8_t {
  ok,
  not_begun,    ///< advance() before begin()
  bad_options,  ///< ReactionOptions out of range, or no figure
  bad_time,     ///< a time step that is not in (0, kMaxReactionFrame_s]
  bad_pose,     ///< a number that is not finite, or a rotation that is not unit (to 1e-3)
  bad_ball,     ///< a number that is not finite, or a mass, radius or speed out of range
  bad_push,     ///< not one of motion::kPushPlaces, or a velocity above kMaxBallSpeed_mps
  failed,       ///< the simulation failed; from now on pose() is the motion to return to
};
/// The status in words; never null.
const char* message_of(ReactionStatus status) noexcept;

/// The stage of a reaction.
enum class ReactionPhase : std::uint8_t {
  none,          ///< not begun
  waiting,       ///< physics moves the figure; the ball has not hit yet
  struck,        ///< the ball has hit; physics alone moves the figure
  recovering,    ///< blends from physics to the protective motion
  returning,     ///< blends from the protective motion to the motion to return to; no physics
  over,          ///< pose() is the motion to return to
  knocked_over,  ///< out of balance beyond what a step can save: falls until the game intervenes
};

/// A character's physical reaction to a ball or a push. The figure, contacts and equations are
/// those of training; weaker joint springs track the kinematic response, so that the hit shows. A
/// double blend then returns to animation (see RecoverySchedule). docs/reaction.md explains it.
///
/// World frame: Z up, the ground at z = 0. Each object owns its simulation: equal calls give
/// equal bits, whatever else is simulated on whatever threads. One thread at a time may call an
/// object. Nothing throws. After begin() nothing is allocated while there are at most 64 rows of
/// contacts, which a figure that lies on the ground stays below.
class Reaction {
 public:
  /// `figure` of make_figure_model(). With bad options or no figure every call returns bad_options.
  explicit Reaction(std::shared_ptr<const sim::FigureModel> figure,
                    const ReactionOptions& options = {}) noexcept;
  ~Reaction();
  Reaction(Reaction&&) noexcept;
  Reaction& operator=(Reaction&&) noexcept;

  /// Hands the character to physics in pose `now`, with the velocities that follow from pose
  /// `before`, `dt_s` earlier; poses in the world. Call it at the first contact or, better, up to
  /// 0.3 s before: a ball that has not hit by then counts as having hit, and the character
  /// recovers. `ball` may be null: then nothing hits. May be called at any time, also during a
  /// reaction. Bad input changes nothing.
  ReactionStatus begin(const motion::Pose& before, const motion::Pose& now, double dt_s,
                       const features::Ball* ball) noexcept;

  /// The same for a character that is pushed now: the joint `place` (one of motion::kPushPlaces)
  /// moves with `velocity` (world, m/s) more, and any other body with velocity exp(-d^2 / m^2),
  /// where d is the distance of its centre of mass from the place: the taper of Arikan et al. 2005,
  /// section 3.2, with w = 1 / m^2. The push counts as the contact.
  ReactionStatus begin_push(const motion::Pose& before, const motion::Pose& now, double dt_s,
                            motion::Role place, const Eigen::Vector3d& velocity) noexcept;

  /// Advances by `dt_s`, in (0, kMaxReactionFrame_s], which may differ from frame to frame.
  /// `wanted` is the pose of the protective motion at the new time, `returning` that of the motion
  /// to return to; they may be the same. Bad input changes nothing.
  ReactionStatus advance(double dt_s, const motion::Pose& wanted,
                         const motion::Pose& returning) noexcept;

  /// The pose to show, world. Bones keep their lengths; clavicles and toes follow the motion.
  const motion::Pose& pose() const noexcept;
  /// The stage that the reaction is in.
  ReactionPhase phase() const noexcept;
  /// The ball now. It flies and bounces until the phase is over. Without one, the default ball.
  features::Ball ball() const noexcept;
  /// When the ball first touched the figure, s after begin(); infinite if it has not. 0 for a push.
  double contact_s() const noexcept;
  /// Impulse on each body so far, N·s: from the ball, and from other bodies that the ball drove
  /// into it.
  motion::PerBody<double> impulse() const noexcept;
  /// Momentum that the ball has passed to the figure so far, world, N·s.
  Eigen::Vector3d ball_momentum() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace flinch::reaction
