#!/bin/sh
# SPDX-License-Identifier: MIT
# Babylon.js 9.28.0 (npm @babylonjs/loaders): a figure from a .bvh is the mirror image of the same
# figure from a .glb.
#
# Expected: Babylon's scenes are left-handed, so its loaders turn files of right-handed axes about: a
# figure that looks along +Z and has its left hand at +X has it at -X then, as the .glb loader does it
# by the scale of its root.
# Seen: the .bvh loader takes offsets and angles as they are. What the file calls LeftHand is on the
# figure's right side, and it ducks to the other side than the ball comes from. Nothing looks broken:
# all of the figure is mirrored, as long as no .glb stands beside it. With
# scene.useRightHandedSystem = true both loaders agree.
# Flinch: who shows its .bvh in Babylon.js sets useRightHandedSystem, or shows its .glb.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @babylonjs/core@9.28.0 @babylonjs/loaders@9.28.0 \
  @gltf-transform/core@4.5.1 >/dev/null
cat >hands.mjs <<'JS'
import '@babylonjs/loaders/BVH/index.js';
import '@babylonjs/loaders/glTF/index.js';
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { LoadAssetContainerAsync } from '@babylonjs/core/Loading/sceneLoader.js';
import { Scene } from '@babylonjs/core/scene.js';
import { Document, NodeIO } from '@gltf-transform/core';

const parts = { LeftHand: [0.5, 0, 0], nose: [0, 0, 0.2] };
const figure = new Document();
figure.createBuffer();
const root = figure.createNode('hip');
figure.createScene().addChild(root);
for (const [name, offset] of Object.entries(parts)) {
  root.addChild(figure.createNode(name).setTranslation(offset));
}
const glb = Buffer.from(await new NodeIO().writeBinary(figure)).toString('base64');
const joints = Object.entries(parts).map(([name, offset]) => `JOINT ${name}
{
OFFSET ${offset.join(' ')}
CHANNELS 3 Zrotation Xrotation Yrotation
End Site
{
OFFSET 0 0 0
}
}
`).join('');
const bvh = `HIERARCHY
ROOT hip
{
OFFSET 0 0 0
CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
${joints}}
MOTION
Frames: 1
Frame Time: 0.1
0 0 0 0 0 0 0 0 0 0 0 0
`;
const tell = (format, rightHanded, place) => console.log(
    `${format}${rightHanded ? ', right-handed scene' : ''}: ` + Object.keys(parts).map((name) =>
      `${name} at ${place(name).asArray().map((x) => Math.round(10 * x) / 10 + 0).join(' ')}`).join(', '));
for (const rightHanded of [false, true]) {
  const scene = new Scene(new NullEngine());
  scene.useRightHandedSystem = rightHanded;
  const nodes = await LoadAssetContainerAsync(`data:;base64,${glb}`, scene, { pluginExtension: '.glb' });
  nodes.addAllToScene();
  for (const node of nodes.rootNodes) node.computeWorldMatrix(true);
  tell('.glb', rightHanded, (name) => {
    const node = scene.getNodeByName(name);
    node.computeWorldMatrix(true);
    return node.getAbsolutePosition();
  });
  const bones = await LoadAssetContainerAsync(`data:${bvh}`, scene, { pluginExtension: '.bvh' });
  bones.skeletons[0].computeAbsoluteMatrices(true);
  tell('.bvh', rightHanded, (name) =>
      bones.skeletons[0].bones.find((bone) => bone.name === name).getAbsolutePosition());
}
process.exit();
JS
node hands.mjs | grep -v '^BJS' | tee seen
printf '%s\n' '.glb: LeftHand at -0.5 0 0, nose at 0 0 0.2' '.bvh: LeftHand at 0.5 0 0, nose at 0 0 0.2' \
  '.glb, right-handed scene: LeftHand at 0.5 0 0, nose at 0 0 0.2' \
  '.bvh, right-handed scene: LeftHand at 0.5 0 0, nose at 0 0 0.2' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
