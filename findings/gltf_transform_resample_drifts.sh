#!/bin/sh
# SPDX-License-Identifier: MIT
# glTF-Transform 4.5.1 (npm @gltf-transform/functions): resample() takes a slow movement off, and more
# of it the more keys the file has.
#
# Expected: resample() is said to drop keys without loss, with a tolerance of 1e-4: what is left is
# within a tenth of a millimetre of what was there, or within some of them.
# Seen: each key is compared with the line from the last kept key to the next one of the file, which is
# right beside it. So the step from one key to the next has to bend by the tolerance, and many small
# bends may follow each other. A sway of 5 cm in 4 s is 0.5 mm off at 60 keys per second, 3 mm at 240,
# and at 1000, the rate of a simulation or a force plate, two keys are left and it stands still. A file
# at 30 keys per second comes out best. `gltf-transform optimize` resamples unless told not to.
# Flinch: its .glb has a key on every frame; who makes it smaller by glTF-Transform leaves resample()
# out.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . @gltf-transform/core@4.5.1 \
  @gltf-transform/functions@4.5.1 >/dev/null
cat >sway.mjs <<'JS'
import { Document } from '@gltf-transform/core';
import { resample } from '@gltf-transform/functions';

const sway = (time) => 0.05 * Math.sin(2 * Math.PI * time / 4);
for (const rate of [30, 60, 240, 1000]) {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type, numbers) =>
      document.createAccessor().setType(type).setArray(Float32Array.from(numbers)).setBuffer(buffer);
  const times = Array.from({ length: 4 * rate + 1 }, (_, i) => i / rate);
  const sampler = document.createAnimationSampler().setInterpolation('LINEAR')
      .setInput(accessor('SCALAR', times))
      .setOutput(accessor('VEC3', times.flatMap((time) => [sway(time), 1, 0])));
  const hips = document.createNode('Hips');
  document.createScene().addChild(hips);
  document.createAnimation('sway').addSampler(sampler).addChannel(document.createAnimationChannel()
      .setTargetNode(hips).setTargetPath('translation').setSampler(sampler));
  await document.transform(resample());
  const kept = sampler.getInput().getArray();
  const places = sampler.getOutput().getArray();
  let worst = 0;
  for (const time of times) {
    let key = 0;
    while (key < kept.length - 2 && kept[key + 1] < time) ++key;
    const part = (time - kept[key]) / (kept[key + 1] - kept[key]);
    const place = places[3 * key] * (1 - part) + places[3 * key + 3] * part;
    worst = Math.max(worst, Math.abs(place - sway(time)));
  }
  console.log(`${rate} keys per second: ${kept.length} of ${times.length} keys are left, up to ` +
      `${(1000 * worst).toFixed(1)} mm off`);
}
JS
node sway.mjs | tee seen
cmp -s - seen <<'TEXT' || {
30 keys per second: 44 of 121 keys are left, up to 0.2 mm off
60 keys per second: 26 of 241 keys are left, up to 0.4 mm off
240 keys per second: 8 of 961 keys are left, up to 3.2 mm off
1000 keys per second: 2 of 4001 keys are left, up to 50.0 mm off
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
