// SPDX-License-Identifier: MIT
#pragma once

#include <ode/ode.h>

#include <Eigen/Geometry>
#include <memory>

#include "sim/body_state.h"

namespace flinch::sim {

/// What ODE wanted to print on this thread so far. ODE keeps one message handler a process; ours
/// counts on the thread that the message came from, so that a simulation can tell its own.
int solver_messages_on_this_thread();

/// To be called on a thread before a world that was made on another is stepped there. Cheap.
void prepare_this_thread();

/// An empty ODE world with its own threading object, so that worlds can be stepped on different
/// threads at a time. Prepares ODE, and the calling thread for it, first. What ODE holds to be an
/// error is thrown as flinch::Error; nothing is ever printed.
class OdeWorld {
 public:
  OdeWorld();

  dWorldID id() const { return world_.get(); }
  /// One step of the direct solver, dWorldStep.
  void step(double step_s) const;

 private:
  struct Free {
    void operator()(dxThreadingImplementation* threading) const;
    void operator()(dxWorld* world) const;
  };
  std::unique_ptr<dxThreadingImplementation, Free> threading_;  // outlives the world
  std::unique_ptr<dxWorld, Free> world_;
};

// ODE's vectors in Eigen's terms.
Eigen::Vector3d position_of(dBodyID body);          ///< m
Eigen::Quaterniond orientation_of(dBodyID body);    ///< unit
Eigen::Vector3d velocity_of(dBodyID body);          ///< of the centre of mass, m/s
Eigen::Vector3d angular_velocity_of(dBodyID body);  ///< rad/s, world

void set_state(dBodyID body, const BodyState& state);
BodyState state_of(dBodyID body);

}  // namespace flinch::sim
