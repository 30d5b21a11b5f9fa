// SPDX-License-Identifier: MIT
#pragma once

#include <ode/ode.h>

#include <Eigen/Geometry>
#include <memory>

#include "sim/body_state.h"

namespace flinch::sim {

/// Number of messages that ODE has tried to print on this thread. ODE keeps one message handler per
/// process; ours counts on the thread that the message came from, so that a simulation can tell its
/// own.
int solver_messages_on_this_thread();

/// Must be called on a thread before it steps a world that another thread created. Cheap.
void prepare_this_thread();

/// An empty ODE world with its own threading object, so that different threads can step different
/// worlds at the same time. The constructor first prepares ODE for the process and for the calling
/// thread. Errors of ODE are thrown as flinch::Error; nothing is ever printed.
class OdeWorld {
 public:
  OdeWorld();

  dWorldID id() const { return world_.get(); }
  /// Runs one step of the direct solver, dWorldStep. If ODE fails, throws Error; the world and its
  /// bodies then stay in memory for good, since ODE cannot free a world in the middle of a step,
  /// and each later step throws at once.
  void step(double step_s);

 private:
  struct Free {
    void operator()(dxThreadingImplementation* threading) const;
    void operator()(dxWorld* world) const;
  };
  std::unique_ptr<dxThreadingImplementation, Free> threading_;  // must outlive the world
  std::unique_ptr<dxWorld, Free> world_;
};

// ODE's vectors converted to Eigen.
Eigen::Vector3d position_of(dBodyID body);          ///< m
Eigen::Quaterniond orientation_of(dBodyID body);    ///< unit
Eigen::Vector3d velocity_of(dBodyID body);          ///< of the centre of mass, m/s
Eigen::Vector3d angular_velocity_of(dBodyID body);  ///< rad/s, world

void set_state(dBodyID body, const BodyState& state);
BodyState state_of(dBodyID body);

}  // namespace flinch::sim
