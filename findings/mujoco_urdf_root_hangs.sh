#!/bin/sh
# SPDX-License-Identifier: MIT
# MuJoCo 3.3.8 (npm mujoco-js 0.0.7): a figure from a .urdf hangs in the air, and links with a fixed joint
# are gone.
#
# Expected: a .urdf that says nothing of the world is of a figure that is free, and falls; each link is a
# body of its name.
# Seen: the root link is a part of the world: it has no joint and no velocity, its mass is not in the
# model's, and only its limbs swing. A hand with a fixed joint is a part of its forearm: its mass is
# there, and its name is nowhere, so that looking for it gives -1. <mujoco><compiler fusestatic="false"/>
# in the .urdf keeps the hand as a body. No element of the file frees the root; an MJCF figure needs
# <freejoint/> likewise.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . mujoco-js@0.0.7 >/dev/null
cat >fall.mjs <<'JS'
import start from 'mujoco-js';

const mujoco = await start();
const link = (name, mass) => `<link name="${name}">
  <inertial>
    <mass value="${mass}"/>
    <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/>
  </inertial>
</link>`;
const joint = (name, type, parent, child) => `<joint name="${name}" type="${type}">
  <parent link="${parent}"/>
  <child link="${child}"/>
  <origin xyz="0 0 -0.3"/>
  <axis xyz="0 1 0"/>
  <limit lower="-1" upper="1" effort="9" velocity="9"/>
</joint>`;
for (const compiler of ['', '<mujoco><compiler fusestatic="false"/></mujoco>']) {
  mujoco.FS.writeFile('/figure.urdf', `<robot name="figure">
    ${compiler}
    ${link('trunk', 30)}
    ${link('forearm', 2)}
    ${link('hand', 1)}
    ${joint('elbow', 'revolute', 'trunk', 'forearm')}
    ${joint('wrist', 'fixed', 'forearm', 'hand')}
  </robot>`);
  const model = mujoco.MjModel.loadFromXML('/figure.urdf');
  const data = new mujoco.MjData(model);
  for (let step = 0; step < 500; ++step) mujoco.mj_step(model, data);
  const body = (name) => mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY.value, name);
  const forearm = body('forearm');
  console.log(`${compiler ? 'fusestatic="false": ' : ''}${model.nv} degree of freedom, ` +
      `${mujoco.mj_getTotalmass(model).toFixed(0)} kg, trunk ${body('trunk')}, hand ${body('hand')}, ` +
      `forearm of ${model.body_mass[forearm].toFixed(0)} kg at ${data.xpos[3 * forearm + 2].toFixed(1)} m`);
}
JS
node fall.mjs | tee seen
cmp -s - seen <<'TEXT' || {
1 degree of freedom, 3 kg, trunk -1, hand -1, forearm of 3 kg at -0.3 m
fusestatic="false": 1 degree of freedom, 33 kg, trunk 1, hand 3, forearm of 2 kg at -0.3 m
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
