#!/bin/sh
# SPDX-License-Identifier: MIT
# ODE 0.16.2 (Debian libode-dev 2:0.16.2-1): attached as (0, body), a hinge's motor and stops run
# against the angle that it reports.
#
# Expected: in a joint to the world either of the two bodies may be 0. The angle may change its sign
# with that, but motor, stops and angle go together, as a slider's do.
# Seen: ODE exchanges the bodies, and dJointGetHingeAngle turns the sign, but motor and stops keep
# that of the exchanged joint. A servo, which sets the motor's velocity to the angle that is
# missing, runs away from its goal, and stops at -0.1 and 1 hold the angle between -1 and 0.1. With
# (body, 0), and for a slider in both orders, all is well.
# Flinch: attaches child and parent, and motors to the world as (body, 0).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libode-dev libode8; do
  apt-get -o APT::Sandbox::User=root download -q "$package=2:0.16.2-1" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libode.so' | head -n 1)")
cat >hinge.cpp <<'CPP'
#include <ode/ode.h>
#include <cstdio>

struct Hinge {
  dWorldID world = dWorldCreate();
  dBodyID body = dBodyCreate(world);
  dJointID joint = dJointCreateHinge(world, nullptr);
  explicit Hinge(bool world_first) {
    dJointAttach(joint, world_first ? nullptr : body, world_first ? body : nullptr);
    dJointSetHingeAnchor(joint, 0, 0, 0);
    dJointSetHingeAxis(joint, 0, 0, 1);
  }
  ~Hinge() { dWorldDestroy(world); }
};

/// The angle after 1 s of a servo whose goal is 0.5 rad.
double servo(bool world_first) {
  const Hinge hinge(world_first);
  dJointSetHingeParam(hinge.joint, dParamFMax, 100);
  for (int step = 0; step < 100; ++step) {
    dJointSetHingeParam(hinge.joint, dParamVel, 5 * (0.5 - dJointGetHingeAngle(hinge.joint)));
    dWorldStep(hinge.world, 0.01);
  }
  return dJointGetHingeAngle(hinge.joint);
}

/// The angle that `torque` turns it to against stops at -0.1 and 1 rad.
double pushed(bool world_first, double torque) {
  const Hinge hinge(world_first);
  dJointSetHingeParam(hinge.joint, dParamLoStop, -0.1);
  dJointSetHingeParam(hinge.joint, dParamHiStop, 1);
  for (int step = 0; step < 300; ++step) {
    dJointAddHingeTorque(hinge.joint, torque);
    dWorldStep(hinge.world, 0.01);
  }
  return dJointGetHingeAngle(hinge.joint);
}

int main() {
  dInitODE2(0);
  for (int order = 0; order < 2; ++order) {
    const bool world_first = order == 1;
    std::printf("%s: servo to 0.5 reaches %.1f, stops hold it from %.1f to %.1f\n",
                world_first ? "(0, body)" : "(body, 0)", servo(world_first),
                pushed(world_first, -1), pushed(world_first, 1));
  }
  dCloseODE();
}
CPP
g++ -DdIDEDOUBLE -I usr/include hinge.cpp -o hinge -L "$library" -lode
LD_LIBRARY_PATH=$library ./hinge | tee seen
printf '%s\n' '(body, 0): servo to 0.5 reaches 0.5, stops hold it from -0.1 to 1.0' \
  '(0, body): servo to 0.5 reaches -2.5, stops hold it from -1.0 to 0.1' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
