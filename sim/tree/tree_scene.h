// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "features/ball.h"
#include "sim/contact/contact_constraint.h"
#include "sim/contact/contact_impulse.h"
#include "sim/figure/support.h"
#include "sim/simulation_options.h"
#include "sim/tree/box_lcp.h"
#include "sim/tree/joint_tree.h"

namespace flinch::sim {

/// A figure and a ball that obey the laws of an OdeScene, stepped by JointTree in a tenth of the
/// time. A plain value except for its reference to the figure model.
class TreeScene {
 public:
  /// `figure_model` must outlive this. `gravity_mps2` is the figure's; the ball has its own.
  TreeScene(const FigureModel& figure_model, const motion::PerBody<BodyState>& start,
            const features::Ball* ball, double gravity_mps2);
  TreeScene(const FigureModel& figure_model, const ReferenceState& start,
            const features::Ball* ball, double gravity_mps2)
      : TreeScene(figure_model, start.body, ball, gravity_mps2) {}

  /// Starts anew from another state as a new object would, without allocating.
  void restart(const motion::PerBody<BodyState>& start, const features::Ball* ball);

  motion::PerBody<MovingShape> shapes() const;
  std::optional<features::Ball> flight() const;

  /// Moves figure and ball. The ball keeps its spin.
  void place(const motion::PerBody<BodyState>& figure, const features::Ball& ball);

  // Contacts of the next step; see Contacts.
  void clear_contacts();
  void add_hit(motion::Body body, const motion::Clearance& at);
  void add_bounce();
  void add_body_contact(motion::Body first, motion::Body second, const motion::Clearance& at,
                        double free_closing_mps, bool measured);
  void add_supports(const ReferenceState& target, double step_s, const Drive& drive = {});

  /// Runs a step that ends at `target`.
  void step(const ReferenceState& target, double step_s, const Drive& drive = {});
  /// The same in a lane, beside steps of other scenes: call begin_step, factor_trees(),
  /// solve_contacts, move_figures() and end_step, each for all lanes.
  template <std::size_t kLanes>
  void begin_step(const ReferenceState& target, double step_s, const Drive& drive,
                  TreeLanes<kLanes>& lanes, std::size_t lane);
  template <std::size_t kLanes>
  void solve_contacts(TreeLanes<kLanes>& lanes, std::size_t lane);
  template <std::size_t kLanes>
  void end_step(const TreeLanes<kLanes>& lanes, std::size_t lane);
  /// Runs a step of the ball alone.
  void step_ball(double step_s);
  std::span<const ContactImpulse> impulses(double step_s);

  const motion::PerBody<BodyState>& bodies() const { return bodies_; }
  /// The ball's state; at the origin if there is none.
  const BodyState& ball_state() const { return ball_state_; }
  /// Number of steps whose contacts were not solved.
  int solver_messages() const { return solver_messages_; }

 private:
  /// A side of a contact: a body of the figure, the ball or, as the second, the ground.
  struct ContactBody {
    enum class Kind : unsigned char { body, ball, ground } kind = Kind::ground;
    motion::Body body{};
  };
  struct Contact {
    ContactConstraint constraint;
    ContactBody first;
    ContactBody second;
    bool measured = false;
    double impulse_ns = 0;
  };
  /// One direction of a contact, a row of the complementarity problem.
  struct Row {
    std::size_t contact = 0;
    Eigen::Vector3d direction;      ///< of the impulse on the first
    Eigen::Vector3d first_moment;   ///< moment of that impulse
    Eigen::Vector3d second_moment;  ///< moment of the opposite impulse on the second
    Eigen::Index normal = -1;       ///< normal row whose force bounds this row
  };

  /// Of the rows' impulses: matrix x - right_hand_side is their velocity less the wanted one.
  struct Equations {
    Scratch::Matrix matrix;
    Scratch::Vector right_hand_side;
  };

  void apply_gravity(double time_s);
  void set_forces(const ReferenceState& target, double step_s, const Drive& drive);
  /// Solves the contacts and returns their impulse on the ball.
  Twist solve_contacts(double step_s);
  void move_ball(const Twist& impulse, double step_s);
  void move_rod(const Twist& after, double step_s, bool is_struck);
  const BodyState& state_of(const ContactBody& contact_body) const;
  /// Velocity of a side of a contact now, and after the step without contact impulses.
  Twist current_velocity(const ContactBody& contact_body) const;
  Twist free_velocity(const ContactBody& contact_body) const;
  static double relative_velocity(const Row& row, const Twist& first, const Twist& second);
  void make_rows();
  void propagate_rows();
  double change_by_ball(const Row& row, const Row& other) const;
  Equations make_equations(double step_s);
  double target_relative_velocity(const Row& row, double step_s) const;
  bool solve_rows(const Equations& equations, Scratch::Vector& solution);
  void apply(const Scratch::Vector& solution, Twist& on_ball);
  static void move(BodyState& state, const Twist& after, double step_s);

  const FigureModel& figure_model_;
  double gravity_mps2_;
  motion::PerBody<BodyState> bodies_;
  /// As it was thrown, but for a rod's turn; its flight is in ball_state_.
  std::optional<features::Ball> ball_;
  BodyState ball_state_;
  double ball_inertia_ = 0;  ///< about any axis, kg m^2
  JointTree tree_;
  std::vector<Contact> contacts_;
  std::vector<ContactImpulse> impulses_;
  int solver_messages_ = 0;
  BodySet dragged_ = 0;  ///< the parts that the ground slows in the next step

  // Scratch buffers of a step.
  motion::PerBody<Twist> after_;
  BodySet pushed_ = 0;             // the bodies on which forces act
  motion::PerBody<Twist> pushes_;  // their impulses; others are not set
  std::vector<Row> rows_;
  std::vector<PropagatedImpulse> propagated_;  // one per row; may be longer than the number of rows
  static constexpr Eigen::Index kReservedRows = 64;  // more rows allocate
  Scratch matrix_{kReservedRows * kReservedRows};
  Scratch right_hand_side_{kReservedRows};
  Scratch bounds_{2 * kReservedRows};
  Scratch solution_{kReservedRows};
  BoxLcp lcp_{kReservedRows};
};

}  // namespace flinch::sim
