#!/bin/sh
# SPDX-License-Identifier: MIT
# Simbody 3.7 (Debian libsimbody-dev 3.7+dfsg-3) and Box2D 2.4.1 (libbox2d-dev 2.4.1-3): a body's moment
# of inertia is about its origin, not about its centre of mass.
#
# Expected: of a mass, a centre of mass and a moment of inertia, as URDF, OpenSim, MuJoCo, DART and KDL
# have them, the moment is about that centre. A trunk of 30 kg with 1.4 kg m^2 whose centre is 10 cm
# above its joint has 1.7 about the joint.
# Seen: MassProperties and b2MassData take the moment about the body's origin. The trunk has 1.4 about
# the joint in Simbody, a sixth too little, and turns freely in Box2D as if it had 1.1. Both take the
# numbers without a word, as the difference is positive; only a body whose centre is so far off that it
# is not stops with an error. shiftFromMassCenter() moves the moment.
# Flinch: does not use them. ODE, which it does use, wants the centre of mass at the origin.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libsimbody-dev=3.7+dfsg-3 libsimbody3.7=3.7+dfsg-3 libbox2d-dev=2.4.1-3 \
  libbox2d2=2.4.1-3 libblas3 liblapack3 libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >trunk.cpp <<'CPP'
#include <SimTKsimbody.h>
#include <box2d/box2d.h>
#include <cstdio>

using namespace SimTK;

void with_simbody(const char* moment, const Inertia& inertia) {
  MultibodySystem system;
  SimbodyMatterSubsystem matter(system);
  MobilizedBody::Pin pin(matter.Ground(), Body::Rigid(MassProperties(30, Vec3(0, 0.1, 0), inertia)));
  const State state = system.realizeTopology();
  system.realize(state, Stage::Position);
  Vector about_the_joint;
  matter.multiplyByM(state, Vector(1, 1.0), about_the_joint);
  std::printf("Simbody, moment about the %s: %.1f kg m^2 about the joint\n", moment,
              about_the_joint[0]);
}

int main() {
  const Inertia central(1.4, 0.3, 1.4);
  with_simbody("centre", central);
  with_simbody("origin", central.shiftFromMassCenter(Vec3(0, 0.1, 0), 30));
  for (const float moment : {1.4F, 1.7F}) {
    b2World world({0, 0});
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    b2Body* trunk = world.CreateBody(&definition);
    const b2MassData mass{30, {0, 0.1F}, moment};
    trunk->SetMassData(&mass);
    trunk->ApplyAngularImpulse(1, true);
    std::printf("Box2D, %.1f: turns as with %.1f kg m^2 about its centre\n", moment,
                1 / trunk->GetAngularVelocity());
  }
}
CPP
g++ -std=c++17 -w -I usr/include -I usr/include/simbody trunk.cpp -o trunk -L "$library" \
  -lSimTKsimbody -lSimTKmath -lSimTKcommon -lbox2d -Wl,--unresolved-symbols=ignore-in-shared-libs
LD_LIBRARY_PATH=$library:$library/blas:$library/lapack ./trunk | tee seen
cmp -s - seen <<'TEXT' || {
Simbody, moment about the centre: 1.4 kg m^2 about the joint
Simbody, moment about the origin: 1.7 kg m^2 about the joint
Box2D, 1.4: turns as with 1.1 kg m^2 about its centre
Box2D, 1.7: turns as with 1.4 kg m^2 about its centre
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
