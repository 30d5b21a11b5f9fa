#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three): in a .usda, what moves the right foot moves the left one, if both are
# called Foot, and most other moving prims stand still.
#
# Expected: a prim's name is unique among its siblings only, so /Figure/Left/Foot and /Figure/Right/Foot
# are two prims; and all the ops in a prim's xformOpOrder are applied, in that order, moving or not. Most of
# them USDLoader applies so where nothing moves. What a loader leaves out it warns of.
# Seen: a track is bound by the prim's last name. Both tracks go to the left foot, which is in the middle of
# the two movements, and the right one stays. Of what moves, only xformOp:translate, orient, rotateXYZ and
# scale do: a hinge's rotateZ, another order of axes, an op with a suffix and a matrix stand still. An
# op that moves forgets the others of its prim: a door with a pivot turns about its middle, and a movement along
# turned axes goes along the parent's. Time samples in one line, { 0: 0, 10: 1 }, are none. No warning for any.
# Flinch: writes no USD. Its .glb, whose joints have names of their own, three.js plays as it is.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
cat >figure.mjs <<'JS'
import * as THREE from 'three';
import { USDLoader } from 'three/addons/loaders/USDLoader.js';

console.warn = (...words) => console.log('warning:', ...words);
// A prim with the given ops, of which each is: type and name, value at 0 s, value at 1 s if it moves.
function prim(name, ...ops) {
  const lines = ops.map(([what, first, last]) => (last === undefined ? `${what} = ${first}`
    : `${what}.timeSamples = {\n0: ${first},\n10: ${last},\n}`));
  const order = ops.map(([what]) => `"${what.split(' ')[1]}"`);
  return `def Xform "${name}"\n{\n${lines.join('\n')}
uniform token[] xformOpOrder = [${order.join(', ')}]\n}\n`;
}
const move = (x) => ['double3 xformOp:translate', '(0, 0, 0)', `(${x}, 0, 0)`];
const identity = '((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))';
const moved = identity.replace('(0, 0, 0, 1)', '(1, 0, 0, 1)');
const figure = `#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Y"
    timeCodesPerSecond = 10
)
def Xform "Figure"
{
def Xform "Left"
{
${prim('Foot', move(1))}}
def Xform "Right"
{
${prim('Foot', move(2))}}
${prim('Turned', ['float3 xformOp:rotateXYZ', '(0, 0, 0)', '(0, 0, 90)'])}
${prim('Hinge', ['float xformOp:rotateZ', '0', '90'])}
${prim('Shoulder', ['float3 xformOp:rotateYXZ', '(0, 0, 0)', '(0, 0, 90)'])}
${prim('Suffix', ['float3 xformOp:rotateXYZ:spin', '(0, 0, 0)', '(0, 0, 90)'])}
${prim('Matrix', ['matrix4d xformOp:transform', identity, moved])}
${prim('Door', ['double3 xformOp:translate:pivot', '(1, 0, 0)'],
    ['float3 xformOp:rotateXYZ', '(0, 0, 0)', '(0, 0, 90)'])
    .replace('xformOp:rotateXYZ"]', 'xformOp:rotateXYZ", "!invert!xformOp:translate:pivot"]')}
${prim('Slider', ['float3 xformOp:rotateXYZ', '(0, 0, 90)'], move(1))}
}
`;
function after(text) {
  const root = new USDLoader().parse(text);
  const mixer = new THREE.AnimationMixer(root);
  for (const clip of root.animations) {
    const action = mixer.clipAction(clip).setLoop(THREE.LoopOnce).play();
    action.clampWhenFinished = true;
  }
  mixer.setTime(1);
  root.updateMatrixWorld(true);
  return root;
}
const root = after(figure);
const tell = (node, wanted) => {
  const [x, y] = new THREE.Vector3().setFromMatrixPosition(node.matrixWorld).toArray();
  const angle = Math.atan2(node.matrixWorld.elements[1], node.matrixWorld.elements[0]);
  const name = node.name === 'Foot' ? `${node.parent.name}/Foot` : node.name;
  console.log(`${name}: at ${x.toFixed(1)}, ${y.toFixed(1)}, turned by `
    + `${(angle * 180 / Math.PI).toFixed(0)}; ${wanted} in USD`);
};
const find = (name) => root.getObjectByName(name);
tell(find('Left').children[0], '1, 0, 0');
tell(find('Right').children[0], '2, 0, 0');
tell(find('Turned'), '0, 0, 90');
tell(find('Hinge'), '0, 0, 90');
tell(find('Shoulder'), '0, 0, 90');
tell(find('Suffix'), '0, 0, 90');
tell(find('Matrix'), '1, 0, 0');
tell(find('Door'), '1, -1, 90');
tell(find('Slider'), '0, 1, 90');
const oneLine = figure.replace(/\{\n0: (.*),\n10: (.*),\n\}/g, '{ 0: $1, 10: $2 }');
console.log(`clips with samples in lines: ${root.animations.length}, `
  + `in one line: ${after(oneLine).animations.length}`);
JS
node figure.mjs | tee seen
cmp -s - seen <<'TEXT' || {
Left/Foot: at 1.5, 0.0, turned by 0; 1, 0, 0 in USD
Right/Foot: at 0.0, 0.0, turned by 0; 2, 0, 0 in USD
Turned: at 0.0, 0.0, turned by 90; 0, 0, 90 in USD
Hinge: at 0.0, 0.0, turned by 0; 0, 0, 90 in USD
Shoulder: at 0.0, 0.0, turned by 0; 0, 0, 90 in USD
Suffix: at 0.0, 0.0, turned by 0; 0, 0, 90 in USD
Matrix: at 0.0, 0.0, turned by 0; 1, 0, 0 in USD
Door: at 0.0, 0.0, turned by 90; 1, -1, 90 in USD
Slider: at 1.0, 0.0, turned by 90; 0, 1, 90 in USD
clips with samples in lines: 1, in one line: 0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
