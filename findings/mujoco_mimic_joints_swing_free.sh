#!/bin/sh
# SPDX-License-Identifier: MIT
# MuJoCo 2.2.2 (Debian libmujoco-dev 2.2.2-3): a joint of a .urdf that mimics another one swings freely.
#
# Expected: <mimic joint="knuckle" multiplier="2"/> keeps the fingertip at twice the knuckle's angle, or
# the reader says that it cannot do that, as it does for other things.
# Seen: the file loads without a word and without the element. A torque bends the knuckle, and the
# fingertip hangs back by its inertia: it turns the other way. Limits of the same joints are
# read. MuJoCo has what it takes, an equality of two joints with polycoef, which one adds by
# hand; issue 3527 of google-deepmind/mujoco asks for it.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libmujoco-dev=2.2.2-3 libmujoco2.2.2=2.2.2-3 libccd2 liblodepng0 libqhull-r8.0 \
  libtinyxml2-9; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >finger.urdf <<'XML'
<robot name="finger">
  <link name="world"/>
  <link name="phalanx">
    <inertial>
      <origin xyz="0 0 -0.1"/>
      <mass value="1"/>
      <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <link name="tip">
    <inertial>
      <origin xyz="0 0 -0.1"/>
      <mass value="1"/>
      <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <joint name="knuckle" type="revolute">
    <parent link="world"/>
    <child link="phalanx"/>
    <axis xyz="0 1 0"/>
    <limit lower="-3" upper="3" effort="5" velocity="10"/>
  </joint>
  <joint name="fingertip" type="revolute">
    <parent link="phalanx"/>
    <child link="tip"/>
    <origin xyz="0 0 -0.2"/>
    <axis xyz="0 1 0"/>
    <limit lower="-3" upper="3" effort="5" velocity="10"/>
    <mimic joint="knuckle" multiplier="2"/>
  </joint>
</robot>
XML
cat >finger.cpp <<'CPP'
#include <cstdio>
#include <mujoco/mujoco.h>

int main() {
  mjModel* model = mj_loadXML("finger.urdf", nullptr, nullptr, 0);
  mjData* data = mj_makeData(model);
  for (double& g : model->opt.gravity) g = 0;
  data->qfrc_applied[0] = 1;
  for (int step = 0; step < 50; ++step) mj_step(model, data);
  std::printf("the knuckle bends %s, the fingertip %s, with %d equalities\n",
              data->qpos[0] > 0.05 ? "forward" : "little", data->qpos[1] < 0 ? "backward" : "forward",
              model->neq);
}
CPP
g++ -std=c++17 -I usr/include finger.cpp -o finger -L "$library" -Wl,-rpath-link,"$library" -lmujoco
LD_LIBRARY_PATH=$library ./finger | tee seen
echo 'the knuckle bends forward, the fingertip backward, with 0 equalities' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
