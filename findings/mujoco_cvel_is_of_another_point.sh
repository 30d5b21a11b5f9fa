#!/bin/sh
# SPDX-License-Identifier: MIT
# MuJoCo 3.3.8 (npm mujoco-js 0.0.7): the linear velocity of a body in cvel is not the body's.
#
# Expected: mjData.cvel is said to be the "com-based velocity" of each body: three angular and three
# linear numbers, the latter of the body's centre of mass. A hand at 1 m from the axis of a body that
# turns at 2 rad/s has 2 m/s.
# Seen: it has 0.2. The numbers are of the point of the body that is at the centre of mass of the whole
# tree of bodies, here 10 cm from the axis. A chest of 9 kg and a hand of 1 kg share that point, so the
# hand is as fast as the chest there, and a heavier chest changes the hand's cvel. mj_objectVelocity()
# gives the velocity at the body itself. Rewards and strike speeds that are taken from cvel are too small.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . mujoco-js@0.0.7 >/dev/null
cat >hand.mjs <<'JS'
import start from 'mujoco-js';

const mujoco = await start();
for (const chest of [9, 99]) {
  mujoco.FS.writeFile('/figure.xml', `<mujoco>
    <option gravity="0 0 0"/>
    <worldbody>
      <body name="chest">
        <freejoint/>
        <geom type="sphere" size="0.1" mass="${chest}"/>
        <body name="hand" pos="1 0 0">
          <geom type="sphere" size="0.1" mass="1"/>
        </body>
      </body>
    </worldbody>
  </mujoco>`);
  const model = mujoco.MjModel.loadFromXML('/figure.xml');
  const data = new mujoco.MjData(model);
  data.qvel.set([0, 0, 0, 0, 0, 2]);
  mujoco.mj_forward(model, data);
  const hand = 2;
  const velocity = new mujoco.DoubleBuffer(6);
  mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY.value, hand, velocity, 0);
  console.log(`chest of ${chest} kg: the hand has ${data.cvel[6 * hand + 4].toFixed(2)} m/s in cvel, ` +
      `${velocity.GetView()[4].toFixed(2)} by mj_objectVelocity`);
}
JS
node hand.mjs | tee seen
cmp -s - seen <<'TEXT' || {
chest of 9 kg: the hand has 0.20 m/s in cvel, 2.00 by mj_objectVelocity
chest of 99 kg: the hand has 0.02 m/s in cvel, 2.00 by mj_objectVelocity
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
