#!/bin/sh
# SPDX-License-Identifier: MIT
# Babylon.js 9.28.0 (npm @babylonjs/core): a copy that MakeAnimationAdditive() makes is the animation as it
# was, unless it also cuts the copy.
#
# Expected: with cloneOriginalAnimation the copy holds differences from the reference frame, as the animation
# itself does without it, and the animation stays as it was.
# Seen: neither is changed. The differences of a turn from 1 to 2 rad are 1 and 2, where they are 0
# and 1 in place, for a copy with clipKeys, and for a copy of a group. Added to a pose, the copy turns the
# joint by the pose of the reference frame once more.
# Flinch: writes whole poses. Who adds its clips in Babylon.js copies a whole group.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @babylonjs/core@9.28.0 >/dev/null
cat >additive.mjs <<'JS'
import {
  Animation, AnimationGroup, NullEngine, Quaternion, Scene, TransformNode,
} from '@babylonjs/core/Legacy/legacy.js';

const turn = (angle) => new Quaternion(Math.sin(angle / 2), 0, 0, Math.cos(angle / 2));
const kinds = {
  angle: [Animation.ANIMATIONTYPE_FLOAT, (x) => x, (v) => v],
  quaternion: [Animation.ANIMATIONTYPE_QUATERNION, turn, (v) => 2 * Math.atan2(v.x, v.w)],
};
const scene = new Scene(new NullEngine());
for (const [kind, [type, value, angle]] of Object.entries(kinds)) {
  const made = () => {
    const animation = new Animation('joint', 'rotation', 60, type);
    animation.setKeys([{ frame: 0, value: value(1) }, { frame: 10, value: value(2) }]);
    return animation;
  };
  const shown = (animation) => animation.getKeys().map((key) => angle(key.value).toFixed(2)).join(' to ');
  const additive = (options) => shown(Animation.MakeAnimationAdditive(made(), { referenceFrame: 0, ...options }));
  const group = new AnimationGroup('clip', scene);
  group.addTargetedAnimation(made(), new TransformNode('joint', scene));
  const copy = AnimationGroup.MakeAnimationAdditive(group, { cloneOriginalAnimationGroup: true });
  console.log(`${kind}: in place ${additive({})}, copied ${additive({ cloneOriginalAnimation: true })},` +
    ` copied and cut ${additive({ cloneOriginalAnimation: true, clipKeys: true })},` +
    ` group copied ${shown(copy.targetedAnimations[0].animation)}`);
}
JS
node additive.mjs | grep -v '^BJS' | tee seen
printf '%s\n' \
  'angle: in place 0.00 to 1.00, copied 1.00 to 2.00, copied and cut 0.00 to 1.00, group copied 0.00 to 1.00' \
  'quaternion: in place 0.00 to 1.00, copied 1.00 to 2.00, copied and cut 0.00 to 1.00, group copied 0.00 to 1.00' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
