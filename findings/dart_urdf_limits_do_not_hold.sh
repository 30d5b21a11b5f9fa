#!/bin/sh
# SPDX-License-Identifier: MIT
# DART 6.12.1 (Debian libdart-utils-urdf-dev 6.12.1+dfsg4-12+b2): a joint of a .urdf goes through the
# limits that the file gives it.
#
# Expected: DartLoader reads a revolute joint with limits of -0.1 and 0.1 rad, tells them when asked,
# and the joint stops there.
# Seen: it reads and tells them, and a torque of 1 N m turns the joint past 1 rad. Limits of a joint
# hold after setLimitEnforcement(true) only, and the loader leaves it at false, so an elbow bends
# backwards without a word. MuJoCo 2.2.2 (Debian libmujoco-dev 2.2.2-3) holds the limits of the same
# file.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libdart-dev libdart6.12 libdart-utils-dev libdart-utils6.12 libdart-utils-urdf-dev \
  libdart-utils-urdf6.12 libdart-external-odelcpsolver6.12 libdart-external-odelcpsolver-dev \
  libdart-external-convhull-3d-dev libdart-external-ikfast-dev; do
  apt-get -o APT::Sandbox::User=root download -q "$package=6.12.1+dfsg4-12+b2" >/dev/null
done
for package in libmujoco-dev=2.2.2-3 libmujoco2.2.2=2.2.2-3 liblodepng0 libqhull-r8.0 libtinyxml2-9 \
  libtinyxml2.6.2v5 liburdfdom-model3.0 liburdfdom-world3.0 liburdfdom-headers-dev libconsole-bridge1.0 \
  libfcl-dev libfcl0.7 libccd-dev libccd2 liboctomap-dev liboctomap1.9 libeigen3-dev libassimp-dev \
  libassimp5 libboost1.74-dev libboost-filesystem1.74.0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >arm.urdf <<'XML'
<robot name="arm">
  <link name="world"/>
  <link name="forearm">
    <inertial>
      <origin xyz="0 0 -0.2"/>
      <mass value="1"/>
      <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="world"/>
    <child link="forearm"/>
    <axis xyz="0 1 0"/>
    <limit lower="-0.1" upper="0.1" effort="5" velocity="10"/>
  </joint>
</robot>
XML
cat >arm.cpp <<'CPP'
#include <cstdio>
#include <dart/dart.hpp>
#include <dart/utils/urdf/DartLoader.hpp>
#include <mujoco/mujoco.h>

const char* where(double angle) { return angle > 1 ? "past 1" : angle < 0.15 ? "at 0.1" : "elsewhere"; }

void with_dart(bool enforced, const std::string& file) {
  const auto arm = dart::utils::DartLoader().parseSkeleton("file://" + file);
  auto* elbow = arm->getDof("elbow");
  if (enforced) elbow->getJoint()->setLimitEnforcement(true);
  const auto world = dart::simulation::World::create();
  world->setGravity(Eigen::Vector3d::Zero());
  world->addSkeleton(arm);
  for (int step = 0; step < 500; ++step) {
    elbow->setForce(1);
    world->step();
  }
  std::printf("DART%s: limits %g and %g, the elbow is %s\n",
              enforced ? " after setLimitEnforcement" : "", elbow->getPositionLowerLimit(),
              elbow->getPositionUpperLimit(), where(elbow->getPosition()));
}

void with_mujoco(const std::string& file) {
  mjModel* model = mj_loadXML(file.c_str(), nullptr, nullptr, 0);
  mjData* data = mj_makeData(model);
  for (double& g : model->opt.gravity) g = 0;
  data->qfrc_applied[0] = 1;
  for (int step = 0; step < 250; ++step) mj_step(model, data);
  std::printf("MuJoCo: limits %g and %g, the elbow is %s\n", model->jnt_range[0], model->jnt_range[1],
              where(data->qpos[0]));
}

int main(int, char** arguments) {
  with_dart(false, arguments[1]);
  with_dart(true, arguments[1]);
  with_mujoco(arguments[1]);
}
CPP
g++ -std=c++17 -w -I usr/include -I usr/include/eigen3 arm.cpp -o arm -L "$library" \
  -Wl,-rpath-link,"$library" -ldart-utils-urdf -ldart -lassimp -lfcl -lccd -loctomap -lmujoco
LD_LIBRARY_PATH=$library ./arm "$PWD/arm.urdf" | tee seen
printf '%s\n' 'DART: limits -0.1 and 0.1, the elbow is past 1' \
  'DART after setLimitEnforcement: limits -0.1 and 0.1, the elbow is at 0.1' \
  'MuJoCo: limits -0.1 and 0.1, the elbow is at 0.1' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
