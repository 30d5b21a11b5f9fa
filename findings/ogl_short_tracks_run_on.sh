#!/bin/sh
# SPDX-License-Identifier: MIT
# OGL 1.0.11 (npm ogl): a glTF channel that ends before its animation runs on along its first two keys,
# and a smooth channel does not follow its tangents.
#
# Expected: as glTF 2.0 says, before its first and after its last key a channel keeps that key's value,
# and a cubic channel between two keys td seconds apart is the Hermite curve of td times the tangents.
# Seen: after the last key the line through the FIRST two keys is followed on, and before the first key it is
# followed back. A hand that goes 1 m to and fro between 1 and 2 s is 1 m off at 0.5 s, and 4 m at 3 s. The
# cubic curve has weights of its own: with keys of 0 and slopes of 1 per second, 2 s apart, it is at 0.09
# after half a second where glTF's is at 0.19.
# Exporters that leave out keys which repeat the one before write channels of different ends.
# Flinch: its .glb has linear keys on every frame of each channel.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . ogl@1.0.11 >/dev/null
cat >tracks.mjs <<'JS'
import { GLTFAnimation, Vec3 } from 'ogl';

// The first coordinate of a joint at `seconds` of an animation that another joint makes 4 s long.
function place(seconds, interpolation, times, values) {
  const joint = { position: new Vec3() };
  const other = { position: new Vec3() };
  const animation = new GLTFAnimation([
    { node: joint, transform: 'position', interpolation, times, values },
    { node: other, transform: 'position', interpolation: 'LINEAR', times: [0, 4], values: [0, 0, 0, 0, 0, 0] },
  ]);
  animation.elapsed = seconds;
  animation.update(1, true);
  return joint.position.x.toFixed(2);
}

const at = (x) => [x, 0, 0];
const swing = [[1, 1.5, 2], [at(0), at(1), at(0)].flat()];
for (const seconds of [0.5, 1.5, 3])
  console.log(`keys 0, 1, 0 at 1, 1.5, 2 s; at ${seconds} s: ${place(seconds, 'LINEAR', ...swing)}`);
// In-tangent, value and out-tangent of each key.
const smooth = [[0, 2], [at(0), at(0), at(1), at(1), at(0), at(0)].flat()];
const [t, td] = [0.25, 2];
const hermite = td * (t ** 3 - 2 * t ** 2 + t) + td * (t ** 3 - t ** 2);
console.log(`smooth, at 0.5 s: ${place(0.5, 'CUBICSPLINE', ...smooth)}, glTF's curve ${hermite.toFixed(2)}`);
JS
node tracks.mjs | tee seen
printf '%s\n' 'keys 0, 1, 0 at 1, 1.5, 2 s; at 0.5 s: -1.00' \
  'keys 0, 1, 0 at 1, 1.5, 2 s; at 1.5 s: 1.00' 'keys 0, 1, 0 at 1, 1.5, 2 s; at 3 s: 4.00' \
  "smooth, at 0.5 s: 0.09, glTF's curve 0.19" | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
