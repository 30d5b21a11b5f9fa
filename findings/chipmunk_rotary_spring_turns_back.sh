#!/bin/sh
# SPDX-License-Identifier: MIT
# Chipmunk 7.0.3 (Debian libchipmunk-dev 7.0.3-5): of the joints for two bodies, the rotary spring
# and the motor count the angle the other way than the limits and the gear.
#
# Expected: all joints of a library mean by "relative angle" the same one. A spring with a rest
# angle of 0.5 rests where a limit joint of [0.5, 0.5] or a gear of phase 0.5 holds the body.
# Seen: limits and gear hold b at a + 0.5, counterclockwise. cpDampedRotarySpring rests at a - 0.5,
# and cpSimpleMotor with a rate of 0.5 turns b by -0.5 rad/s. So a spring with a rest angle inside
# its joint's limits pushes against one of them for good. The manual calls all of them the relative
# angle or rotation of the two bodies, without a sign.
# Flinch: does not use it. Who does negates rest angles and rates, or exchanges the bodies.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libchipmunk-dev libchipmunk7; do
  apt-get -o APT::Sandbox::User=root download -q "$package=7.0.3-5" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libchipmunk.so' | head -n 1)")
cat >joints.c <<'C'
#include <chipmunk/chipmunk.h>
#include <stdio.h>

static cpBody* ground;
static cpBody* body;

/* The angle of a body 10 s after it was pinned to the ground, with up to two more joints. */
static double held(cpConstraint* (*first)(void), cpConstraint* (*second)(void)) {
  cpSpace* space = cpSpaceNew();
  ground = cpSpaceGetStaticBody(space);
  body = cpSpaceAddBody(space, cpBodyNew(1, 1));
  cpSpaceAddConstraint(space, cpPivotJointNew(ground, body, cpvzero));
  cpSpaceAddConstraint(space, first());
  if (second) cpSpaceAddConstraint(space, second());
  for (int step = 0; step < 600; ++step) cpSpaceStep(space, 1.0 / 60);
  return cpBodyGetAngle(body);
}

static cpConstraint* limit(void) { return cpRotaryLimitJointNew(ground, body, 0.5, 0.5); }
static cpConstraint* range(void) { return cpRotaryLimitJointNew(ground, body, -0.2, 1); }
static cpConstraint* gear(void) { return cpGearJointNew(ground, body, 0.5, 1); }
static cpConstraint* spring(void) { return cpDampedRotarySpringNew(ground, body, 0.5, 20, 5); }
static cpConstraint* motor(void) { return cpSimpleMotorNew(ground, body, 0.5); }

int main(void) {
  printf("limits 0.5 and 0.5: %.2f\n", held(limit, 0));
  printf("gear of phase 0.5: %.2f\n", held(gear, 0));
  printf("rotary spring of rest angle 0.5: %.2f\n", held(spring, 0));
  printf("that spring within limits -0.2 and 1: %.1f\n", held(spring, range));
  printf("motor of rate 0.5 after 10 s: %.0f\n", held(motor, 0));
}
C
gcc -O1 -DNDEBUG -I usr/include joints.c -o joints -L "$library" -lchipmunk
LD_LIBRARY_PATH=$library ./joints 2>/dev/null | grep -v '^Init\|^Compile' | tee seen
printf '%s\n' 'limits 0.5 and 0.5: 0.50' 'gear of phase 0.5: 0.50' \
  'rotary spring of rest angle 0.5: -0.50' 'that spring within limits -0.2 and 1: -0.2' \
  'motor of rate 0.5 after 10 s: -5' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
