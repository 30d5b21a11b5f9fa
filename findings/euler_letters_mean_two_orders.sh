#!/bin/sh
# SPDX-License-Identifier: MIT
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2) and MuJoCo 3.3.8 (npm mujoco-js 0.0.7): the same letters
# "xyz" and the same three angles are two rotations, and "XYZ" the two others.
#
# Expected: Euler angles of the sequence "xyz" in one library are those of "xyz" in the other.
# Seen: small letters are fixed axes in SciPy and turning axes in MuJoCo (compiler eulerseq), where the
# large ones are the fixed; MuJoCo's default is "xyz". three.js 0.187.0 knows large letters only, which
# are turning axes there as in SciPy. So what is "XYZ" in SciPy and three.js is "xyz" in MuJoCo, and as
# "XYZ" there it is the rotation with its order turned about. Where two of the angles are zero all agree.
# Flinch: its files have no Euler angles but in .bvh, whose channels say their order.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . mujoco-js@0.0.7 three@0.187.0 \
  >/dev/null
for package in python3-scipy=1.10.1-2 python3-numpy python3-decorator libblas3 liblapack3 libgfortran5 \
  liblbfgsb0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
triplet=$PWD/usr/lib/x86_64-linux-gnu
cat >angles.py <<'PY'
from scipy.spatial.transform import Rotation

for letters in ("xyz", "XYZ"):
    x, y, z, w = Rotation.from_euler(letters, [0.5, 0.6, 0.7]).as_quat()
    print(f"SciPy {letters}: {w:.3f} {x:.3f} {y:.3f} {z:.3f}")
PY
cat >angles.mjs <<'JS'
import start from 'mujoco-js';
import { Euler, Quaternion } from 'three';

const mujoco = await start();
const tell = (name, q) => console.log(`${name}: ${q.map((x) => x.toFixed(3)).join(' ')}`);
for (const letters of ['xyz', 'XYZ']) {
  mujoco.FS.writeFile('/limb.xml', `<mujoco>
    <compiler angle="radian" eulerseq="${letters}"/>
    <worldbody>
      <body euler="0.5 0.6 0.7">
        <geom type="sphere" size="0.1"/>
      </body>
    </worldbody>
  </mujoco>`);
  const model = mujoco.MjModel.loadFromXML('/limb.xml');
  tell(`MuJoCo ${letters}`, Array.from(model.body_quat).slice(4, 8));
}
const { w, x, y, z } = new Quaternion().setFromEuler(new Euler(0.5, 0.6, 0.7, 'XYZ'));
tell('three.js XYZ', [w, x, y, z]);
JS
{
  PYTHONPATH=$PWD/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack \
    /usr/bin/python3 angles.py
  node angles.mjs
} | tee seen
cmp -s - seen <<'TEXT' || {
SciPy xyz: 0.895 0.124 0.350 0.249
SciPy XYZ: 0.844 0.320 0.188 0.386
MuJoCo xyz: 0.844 0.320 0.188 0.386
MuJoCo XYZ: 0.895 0.124 0.350 0.249
three.js XYZ: 0.844 0.320 0.188 0.386
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
