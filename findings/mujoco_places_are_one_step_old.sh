#!/bin/sh
# SPDX-License-Identifier: MIT
# MuJoCo 3.3.8 (npm mujoco-js 0.0.7): after mj_step, bodies' places and sensors are those of the step before,
# and joint positions and velocities are new.
#
# Expected: all that mjData holds after a step is of the time that it holds.
# Seen: mj_step computes places, contacts and sensors of the present state, and then integrates qpos and
# qvel, without going over the places again. A hand at 20 m/s, in steps of 5 ms, is 10 cm behind its own
# joint in xpos and in a framepos sensor, so rows that are recorded as qpos and xpos do not belong together.
# mj_forward, or mj_kinematics for places alone, makes them one. Issue 889 of google-deepmind/mujoco is
# about it.
# Flinch: does not use it. Its solver has poses and velocities of one time after each step.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . mujoco-js@0.0.7 >/dev/null
cat >hand.mjs <<'JS'
import start from 'mujoco-js';

const mujoco = await start();
mujoco.FS.writeFile('/hand.xml', `<mujoco>
  <option gravity="0 0 0" timestep="0.005"/>
  <worldbody>
    <body name="hand">
      <joint type="slide" axis="1 0 0"/>
      <geom type="sphere" size="0.1" mass="1"/>
      <site name="palm"/>
    </body>
  </worldbody>
  <sensor><framepos objtype="site" objname="palm"/></sensor>
</mujoco>`);
const model = mujoco.MjModel.loadFromXML('/hand.xml');
const data = new mujoco.MjData(model);
data.qvel.set([20]);
const told = (name) => console.log(`${name}: at ${data.time.toFixed(3)} s `
    + `joint ${data.qpos[0].toFixed(2)} m, body ${data.xpos[3].toFixed(2)} m, `
    + `sensor ${data.sensordata[0].toFixed(2)} m`);
for (let i = 0; i < 100; ++i) mujoco.mj_step(model, data);
told('after 100 steps');
mujoco.mj_forward(model, data);
told('after mj_forward');
JS
node hand.mjs | tee seen
cmp -s - seen <<'TEXT' || {
after 100 steps: at 0.500 s joint 10.00 m, body 9.90 m, sensor 9.90 m
after mj_forward: at 0.500 s joint 10.00 m, body 10.00 m, sensor 10.00 m
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
