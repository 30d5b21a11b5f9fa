#!/bin/sh
# SPDX-License-Identifier: MIT
# @babylonjs/havok 1.3.14 (npm): a step that is longer than about a 23rd of a second moves the world by less
# than the step.
#
# Expected: HP_World_Step(world, timestep) advances the world by that time. A second in 10 steps is a second,
# coarser than in 60. HP_World_SetIdealStepTime is said to keep the stiffness of the solver alike.
# Seen: without HP_World_SetIdealStepTime a ball at 1 m/s is at 0.43 m after 10 steps of 0.1 s, and a
# falling one has 4.2 m/s instead of 9.8: each step ends after 0.043 s. From 24 steps per second on both
# are right, and with the ideal time set to that of the step at any rate. So who calls the engine with the
# time since the last frame has slow motion on slow machines, with no error. planck 1.5.0 takes the steps
# as they are.
# Flinch: does not use it. Babylon.js sets the ideal time before each step.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @babylonjs/havok@1.3.14 planck@1.5.0 >/dev/null
cat >second.mjs <<'JS'
import { readFileSync } from 'node:fs';
import startHavok from '@babylonjs/havok';
import { Circle, Vec2, World } from 'planck';

const wasmBinary = readFileSync('node_modules/@babylonjs/havok/lib/esm/HavokPhysics.wasm');
const H = await startHavok({ wasmBinary });
const told = (name, count, place, speed) => console.log(
    `${name}, ${count} steps: ${place.toFixed(2)} m along, falls at ${(-speed).toFixed(2)} m/s`);
for (const count of [60, 24, 20, 10]) {
  for (const ideal of [false, true]) {
    const world = H.HP_World_Create()[1];
    H.HP_World_SetGravity(world, [0, -9.81, 0]);
    if (ideal) H.HP_World_SetIdealStepTime(world, 1 / count);
    const shape = H.HP_Shape_CreateSphere([0, 0, 0], 0.1)[1];
    const body = H.HP_Body_Create()[1];
    H.HP_Body_SetShape(body, shape);
    H.HP_Body_SetMotionType(body, H.MotionType.DYNAMIC);
    H.HP_Body_SetMassProperties(body, H.HP_Shape_BuildMassProperties(shape)[1]);
    H.HP_World_AddBody(world, body, false);
    H.HP_Body_SetLinearVelocity(body, [1, 0, 0]);
    for (let i = 0; i < count; ++i) H.HP_World_Step(world, 1 / count);
    told(`havok${ideal ? ', ideal time set' : ''}`, count, H.HP_Body_GetPosition(body)[1][0],
        H.HP_Body_GetLinearVelocity(body)[1][1]);
  }
}
const world = new World(new Vec2(0, -9.81));
const body = world.createDynamicBody();
body.createFixture({ shape: new Circle(0.1), density: 1 });
body.setLinearVelocity(new Vec2(1, 0));
for (let i = 0; i < 10; ++i) world.step(0.1);
told('planck', 10, body.getPosition().x, body.getLinearVelocity().y);
process.exit();
JS
node second.mjs | tee seen
cmp -s - seen <<'TEXT' || {
havok, 60 steps: 1.00 m along, falls at 9.81 m/s
havok, ideal time set, 60 steps: 1.00 m along, falls at 9.81 m/s
havok, 24 steps: 1.00 m along, falls at 9.81 m/s
havok, ideal time set, 24 steps: 1.00 m along, falls at 9.81 m/s
havok, 20 steps: 0.86 m along, falls at 8.44 m/s
havok, ideal time set, 20 steps: 1.00 m along, falls at 9.81 m/s
havok, 10 steps: 0.43 m along, falls at 4.22 m/s
havok, ideal time set, 10 steps: 1.00 m along, falls at 9.81 m/s
planck, 10 steps: 1.00 m along, falls at 9.81 m/s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
