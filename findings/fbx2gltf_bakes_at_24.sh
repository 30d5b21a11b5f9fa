#!/bin/sh
# SPDX-License-Identifier: MIT
# FBX2glTF 0.9.7 (npm fbx2gltf): a blow that lasts a sixtieth of a second is not in the .gltf.
#
# Expected: a .fbx with a key each 1/120 s becomes a .gltf that plays the same, as glTF keeps keys at
# any time.
# Seen: the movement is sampled at 24 frames per second, whatever rate the file has, and drawn as lines
# between. A hand that reaches 1 m at two keys between two of those frames and is back at 0 then does not
# move, and as nothing moves, the file has no animation. The option --anim-framerate knows 24, 30 and 60
# frames per second and no more: 30 misses this blow too, and of motion capture at 120 every second key
# is the most that one gets.
# Flinch: imports .fbx by Assimp, which takes the keys of the file.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . fbx2gltf@0.9.7 >/dev/null
converter=node_modules/fbx2gltf/bin/Linux/FBX2glTF
chmod +x "$converter"
cat >write.mjs <<'JS'
import { writeFileSync } from 'node:fs';

const ticks = (seconds) => Math.round(seconds * 46186158000);
const frames = Array.from({ length: 121 }, (_, frame) => frame);
const curve = (id, keys, values) => `  AnimationCurve: ${id}, "AnimCurve::", "" {
    Default: 0
    KeyVer: 4008
    KeyTime: *${keys.length} {
      a: ${keys.join()}
    }
    KeyValueFloat: *${keys.length} {
      a: ${values.join()}
    }
    KeyAttrFlags: *1 {
      a: 4
    }
    KeyAttrDataFloat: *4 {
      a: 0,0,0,0
    }
    KeyAttrRefCount: *1 {
      a: ${keys.length}
    }
  }
`;
// A hand that is 100 cm away at the frames 61 and 62 of 120 in a second.
const reach = frames.map((frame) => (frame === 61 || frame === 62 ? 100 : 0));
writeFileSync('blow.fbx', `; FBX 7.4.0 project file
FBXHeaderExtension:  {
  FBXHeaderVersion: 1003
  FBXVersion: 7400
}
GlobalSettings:  {
  Version: 1000
  Properties70:  {
    P: "UnitScaleFactor", "double", "Number", "",1
    P: "TimeMode", "enum", "", "",0
    P: "TimeSpanStop", "KTime", "Time", "",${ticks(1)}
  }
}
Definitions:  {
  Version: 100
  Count: 5
  ObjectType: "Model" {
    Count: 1
  }
  ObjectType: "AnimationStack" {
    Count: 1
  }
  ObjectType: "AnimationLayer" {
    Count: 1
  }
  ObjectType: "AnimationCurveNode" {
    Count: 1
  }
  ObjectType: "AnimationCurve" {
    Count: 3
  }
}
Objects:  {
  Model: 1, "Model::Hand", "Null" {
    Version: 232
    Properties70:  {
      P: "Lcl Translation", "Lcl Translation", "", "A",0,0,0
    }
  }
  AnimationStack: 2, "AnimStack::take", "" {
    Properties70:  {
      P: "LocalStop", "KTime", "Time", "",${ticks(1)}
      P: "ReferenceStop", "KTime", "Time", "",${ticks(1)}
    }
  }
  AnimationLayer: 3, "AnimLayer::base", "" {
  }
  AnimationCurveNode: 4, "AnimCurveNode::T", "" {
    Properties70:  {
      P: "d|X", "Number", "", "A",0
      P: "d|Y", "Number", "", "A",0
      P: "d|Z", "Number", "", "A",0
    }
  }
${curve(5, frames.map((frame) => ticks(frame / 120)), reach)}${curve(6, [0], [0])}${curve(7, [0], [0])}}
Connections:  {
  C: "OO",1,0
  C: "OO",3,2
  C: "OO",4,3
  C: "OP",4,1, "Lcl Translation"
  C: "OP",5,4, "d|X"
  C: "OP",6,4, "d|Y"
  C: "OP",7,4, "d|Z"
}
`.replace(/^ +/gm, (spaces) => '\t'.repeat(spaces.length / 2)));
JS
cat >read.mjs <<'JS'
import { readFileSync } from 'node:fs';

const [name, folder] = process.argv.slice(2);
const gltf = JSON.parse(readFileSync(`${folder}_out/${folder}.gltf`));
const bytes = readFileSync(`${folder}_out/buffer.bin`);
const sampler = gltf.animations?.[0].samplers[0];
if (!sampler) {
  console.log(`${name}: no animation`);
  process.exit();
}
const numbers = (index) => {
  const { bufferView, byteOffset = 0, count, type } = gltf.accessors[index];
  const start = (gltf.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
  return Array.from({ length: count * { SCALAR: 1, VEC3: 3 }[type] }, (_, i) =>
      bytes.readFloatLE(start + 4 * i));
};
const places = numbers(sampler.output).filter((_, i) => i % 3 === 0);
console.log(`${name}: ${numbers(sampler.input).length} keys, reaches ${Math.max(...places)} m`);
JS
node write.mjs
{
  "$converter" -i blow.fbx -o unasked >/dev/null 2>&1
  node read.mjs unasked unasked
  for rate in 30 60; do
    "$converter" -i blow.fbx -o "$rate" --anim-framerate "bake$rate" >/dev/null 2>&1
    node read.mjs "bake$rate" "$rate"
  done
} | tee seen
cmp -s - seen <<'TEXT' || {
unasked: no animation
bake30: no animation
bake60: 61 keys, reaches 1 m
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
