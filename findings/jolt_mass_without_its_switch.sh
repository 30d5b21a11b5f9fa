#!/bin/sh
# SPDX-License-Identifier: MIT
# jolt-physics 1.1.0 (npm): a body that is made with a mass of 7 kg has 520 kg.
#
# Expected: BodyCreationSettings has mMassPropertiesOverride: a sphere with a radius of 0.5 m and an mMass
# of 7 there has 7 kg.
# Seen: it has 520 kg, the mass of its volume at 1000 kg per cubic metre: the override counts only where
# mOverrideMassProperties is set to say which parts of it do, and that is none unless told. A limb that
# is given 7 kg is too heavy by its volume, and a ball of 0.15 kg and 3.7 cm happens to have 0.21, so that
# small things look right. With EOverrideMassProperties_CalculateInertia it is 7 kg.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . jolt-physics@1.1.0 >/dev/null
cat >mass.mjs <<'JS'
import startJolt from 'jolt-physics';

const J = await startJolt();
const pairs = new J.ObjectLayerPairFilterTable(1);
const layers = new J.BroadPhaseLayerInterfaceTable(1, 1);
layers.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
const settings = new J.JoltSettings();
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
const bodies = new J.JoltInterface(settings).GetPhysicsSystem().GetBodyInterface();
for (const [radius, mass] of [[0.5, 7], [0.037, 0.15]]) {
  for (const told of [false, true]) {
    const creation = new J.BodyCreationSettings(new J.SphereShape(radius), new J.RVec3(0, 0, 0),
        new J.Quat(0, 0, 0, 1), J.EMotionType_Dynamic, 0);
    creation.mMassPropertiesOverride.mMass = mass;
    if (told) creation.mOverrideMassProperties = J.EOverrideMassProperties_CalculateInertia;
    const made = 1 / bodies.CreateBody(creation).GetMotionProperties().GetInverseMass();
    console.log(`${mass} kg${told ? ', with the switch' : ''}: ${Number(made.toPrecision(2))} kg`);
  }
}
process.exit();
JS
node mass.mjs 2>/dev/null | tee seen
cmp -s - seen <<'TEXT' || {
7 kg: 520 kg
7 kg, with the switch: 7 kg
0.15 kg: 0.21 kg
0.15 kg, with the switch: 0.15 kg
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
