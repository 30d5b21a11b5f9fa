#!/bin/sh
# SPDX-License-Identifier: MIT
# Blender 3.4.1 (Debian blender 3.4.1+dfsg-2+b1): a .bvh that goes in and out of it comes back lying on its back and
# 2.5 times as slow, and in three.js 0.187.0 with bones of twice their length.
#
# Expected: File > Import and File > Export of one format, with their defaults, are each other's inverse.
# The importer turns Y up into Blender's Z up, so the exporter, which has no choice of axes, turns it back.
# Seen: as installed, the importer opens no file at all: it asks for mode "rU", which Python 3.11 no longer
# has. With that put right, the exporter leaves the Z axis up, where all other writers and most readers have
# Y up. Frames of 1/60 s become frames of 1/24 s, as the scene has, and 4 of them 250. Each joint has position
# channels that hold its OFFSET again. A reader that lets them replace it has the figure right; three.js,
# which adds them, shows a thigh of 0.8 m.
# Flinch: detects the axis, and lets the positions replace the offsets. The rate it cannot know:
# import --rate-of-file 60, or export at the clip's rate and range, as scripts/blender_open sets them.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
apt-get -s install --no-install-recommends blender=3.4.1+dfsg-2+b1 >plan
# shellcheck disable=SC2046
apt-get -o APT::Sandbox::User=root download -q blender=3.4.1+dfsg-2+b1 blender-data \
  $(awk '/^Inst/ && $2 !~ /^blender/ { print $2 }' plan) >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
LD_LIBRARY_PATH=$(find usr/lib -name '*.so*' -printf "$PWD/%h\n" | sort -u | tr '\n' ':')
BLENDER_SYSTEM_SCRIPTS=$PWD/usr/share/blender/scripts
BLENDER_SYSTEM_DATAFILES=$PWD/usr/share/blender/datafiles
export LD_LIBRARY_PATH BLENDER_SYSTEM_SCRIPTS BLENDER_SYSTEM_DATAFILES HOME="$folder"
cat >leg.bvh <<'BVH'
HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Thigh
  {
    OFFSET 0 -0.1 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT Shin
    {
      OFFSET 0 -0.4 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 0 -0.4 0
      }
    }
  }
}
MOTION
Frames: 4
Frame Time: 0.0166667
0 0.9 0 0 0 0 0 0 0 0 0 0
0 0.9 0 0 0 0 0 20 0 0 -20 0
0 0.9 0 0 0 0 0 40 0 0 -40 0
0 0.9 0 0 0 0 0 60 0 0 -60 0
BVH
cat >pass.py <<'PY'
import bpy
import io_anim_bvh.import_bvh as importer

bpy.ops.object.select_all(action="SELECT")
bpy.ops.object.delete()
try:
    bpy.ops.import_anim.bvh(filepath="leg.bvh")
except RuntimeError as error:
    print("as installed:", str(error).split("ValueError: ")[1].splitlines()[0])
importer.open = lambda path, mode: open(path)
bpy.ops.import_anim.bvh(filepath="leg.bvh")
bpy.ops.export_anim.bvh(filepath="back.bvh")
PY
usr/bin/blender -b --factory-startup -P pass.py 2>/dev/null | grep 'as installed' >seen
grep -A1 '^Frames' back.bvh | tr '\n' ' ' | sed 's/ $/\n/' >>seen
cat >show.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { Vector3 } from 'three';
import { BVHLoader } from 'three/addons/loaders/BVHLoader.js';
import { AnimationMixer } from 'three';

for (const file of ['leg.bvh', 'back.bvh']) {
  const { skeleton, clip } = new BVHLoader().parse(readFileSync(file, 'utf8'));
  const mixer = new AnimationMixer(skeleton.bones[0]);
  mixer.clipAction(clip).play();
  mixer.setTime(0);
  skeleton.bones[0].updateMatrixWorld(true);
  const [hips, thigh, shin] = skeleton.bones.map((bone) =>
    new Vector3().setFromMatrixPosition(bone.matrixWorld));
  const [x, y, z] = hips.toArray().map((value) => Math.abs(value).toFixed(1));
  console.log(`${file}: hips at ${x}, ${y}, ${z}, thigh ${thigh.distanceTo(shin).toFixed(1)} m, `
    + `${clip.duration.toFixed(2)} s`);
}
JS
node show.mjs >>seen
cat seen
cmp -s - seen <<'TEXT' || {
as installed: invalid mode: 'rU'
Frames: 250 Frame Time: 0.041667
leg.bvh: hips at 0.0, 0.9, 0.0, thigh 0.4 m, 0.05 s
back.bvh: hips at 0.0, 0.0, 0.9, thigh 0.8 m, 10.38 s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
