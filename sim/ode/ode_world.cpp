// SPDX-License-Identifier: MIT
#include "sim/ode/ode_world.h"

#include <cstdarg>
#include <cstdio>
#include <mutex>

#include "motion/error.h"

namespace flinch::sim {
namespace {

// ODE has one set of handlers per process and passes them no context; a counter per thread is the
// least state that tells the messages of one simulation from those of another.
thread_local int message_count = 0;

void count_message(int, const char*, va_list) {
  ++message_count;
}

// ODE calls exit() or abort() when this returns, so it throws. That is safe inside a step: ODE is
// compiled as C++ and unwinds. But a world that was left in mid-step may fail again when it is
// destroyed, and a second exception would end the process: see OdeWorld::step().
[[noreturn]] void throw_error(int number, const char* format, va_list arguments) {
  char text[256];
  std::vsnprintf(text, sizeof text, format, arguments);
  throw Error("simulation", "the physics engine failed with error " + std::to_string(number) +
                                " (" + text +
                                "); this is a fault of the program, please report it");
}

Eigen::Vector3d vector(const dReal* values) {
  return {values[0], values[1], values[2]};
}

}  // namespace

int solver_messages_on_this_thread() {
  return message_count;
}

// ODE stays initialised until the process ends: closing it would require every thread to be done.
void prepare_this_thread() {
  static std::once_flag once;
  std::call_once(once, [] {
    dInitODE2(0);
    dSetMessageHandler(count_message);
    dSetErrorHandler(throw_error);
    dSetDebugHandler(throw_error);
  });
  if (dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)) == 0) {
    throw Error("simulation", "the physics engine has no memory for this thread");
  }
}

OdeWorld::OdeWorld() {
  prepare_this_thread();
  threading_.reset(dThreadingAllocateSelfThreadedImplementation());
  world_.reset(dWorldCreate());
  dWorldSetStepThreadingImplementation(id(), dThreadingImplementationGetFunctions(threading_.get()),
                                       threading_.get());
  dWorldSetAutoDisableFlag(id(), 0);
}

void OdeWorld::step(double step_s) {
  if (!world_) throw Error("simulation", "the physics engine has failed before");
  try {
    if (dWorldStep(id(), step_s) != 0) return;
  } catch (const Error&) {
    static_cast<void>(world_.release());  // never destroyed: that would throw in a destructor
    static_cast<void>(threading_.release());
    throw;
  }
  throw Error("simulation", "the physics engine has no memory for a step");
}

void OdeWorld::Free::operator()(dxThreadingImplementation* threading) const {
  dThreadingFreeImplementation(threading);
}

void OdeWorld::Free::operator()(dxWorld* world) const {
  dWorldDestroy(world);
}

Eigen::Vector3d position_of(dBodyID body) {
  return vector(dBodyGetPosition(body));
}

Eigen::Quaterniond orientation_of(dBodyID body) {
  const dReal* q = dBodyGetQuaternion(body);
  return {q[0], q[1], q[2], q[3]};
}

Eigen::Vector3d velocity_of(dBodyID body) {
  return vector(dBodyGetLinearVel(body));
}

Eigen::Vector3d angular_velocity_of(dBodyID body) {
  return vector(dBodyGetAngularVel(body));
}

void set_state(dBodyID body, const BodyState& state) {
  const Eigen::Vector3d& x = state.position;
  const Eigen::Vector3d& v = state.velocity;
  const Eigen::Vector3d& w = state.angular_velocity;
  const Eigen::Quaterniond& q = state.orientation;
  const dQuaternion quaternion{q.w(), q.x(), q.y(), q.z()};
  dBodySetPosition(body, x.x(), x.y(), x.z());
  dBodySetQuaternion(body, quaternion);
  dBodySetLinearVel(body, v.x(), v.y(), v.z());
  dBodySetAngularVel(body, w.x(), w.y(), w.z());
}

BodyState state_of(dBodyID body) {
  return {position_of(body), orientation_of(body), velocity_of(body), angular_velocity_of(body)};
}

}  // namespace flinch::sim
