#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three): once a clip that plays once has ended, setTime() shows its first pose at any
# time.
#
# Expected: AnimationMixer.setTime(t) shows the clips as they are at that time, so a slider over a clip
# shows the same pose at 0.5 s whatever was shown before.
# Seen: when the time passes the end of an action with LoopOnce, the action is paused, or disabled where
# clampWhenFinished is false. setTime() sets its time to 0 and does not undo that, so from then on each
# time of the slider shows the pose at 0. action.reset() before setTime() mends it, and LoopRepeat does
# not have it.
# Flinch: its page poses the figure of each time itself.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
cat >slider.mjs <<'JS'
import * as three from 'three';

const clip = new three.AnimationClip('walk', -1,
    [new three.NumberKeyframeTrack('.position[x]', [0, 1], [0, 10])]);
for (const [name, loop, clamp, reset] of [['once, clamped', three.LoopOnce, true, false],
  ['once', three.LoopOnce, false, false], ['once, clamped, reset', three.LoopOnce, true, true],
  ['repeated', three.LoopRepeat, false, false]]) {
  const figure = new three.Object3D();
  const mixer = new three.AnimationMixer(figure);
  const action = mixer.clipAction(clip).setLoop(loop);
  action.clampWhenFinished = clamp;
  action.play();
  const shown = [0.2, 0.5, 1.2, 0.5, 0.2].map((time) => {
    if (reset) action.reset();
    mixer.setTime(time);
    return `${figure.position.x.toFixed(0)} m at ${time} s`;
  });
  console.log(`${name}: ${shown.join(', ')}`);
}
JS
node slider.mjs | tee seen
cmp -s - seen <<'TEXT' || {
once, clamped: 2 m at 0.2 s, 5 m at 0.5 s, 10 m at 1.2 s, 0 m at 0.5 s, 0 m at 0.2 s
once: 2 m at 0.2 s, 5 m at 0.5 s, 0 m at 1.2 s, 0 m at 0.5 s, 0 m at 0.2 s
once, clamped, reset: 2 m at 0.2 s, 5 m at 0.5 s, 10 m at 1.2 s, 5 m at 0.5 s, 2 m at 0.2 s
repeated: 2 m at 0.2 s, 5 m at 0.5 s, 2 m at 1.2 s, 5 m at 0.5 s, 2 m at 0.2 s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
