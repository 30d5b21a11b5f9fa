#!/bin/sh
# SPDX-License-Identifier: MIT
# three-vrm 3.5.5 (npm @pixiv/three-vrm-springbone): the same hair swings nearly twice as far at 30
# frames per second as at 240.
#
# Expected: the manager's update(delta) takes the time of a frame, so that the swing of a spring bone
# does not depend on the frame rate, but for the error of the integration.
# Seen: the drag force is the part of the speed that is lost in each frame, whatever the frame's time
# is, and gravity moves the tip by its power times the time, not times its square. So a strand of 30 cm
# hangs back by 55 degrees at 30 frames per second and by 30 at 240 when its head moves a metre to the
# side in a quarter of a second, and with smaller steps it does not settle on a value. VRM's formula
# says so, and other players of the format have it too. Hair that was tuned on a screen of 60 Hz is
# another on one of 144, and in a recording at 30.
# Flinch: does not play spring bones. Who shows its motion on a VRM figure steps the manager at 1/60 s.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 @pixiv/three-vrm-springbone@3.5.5 \
  >/dev/null
cat >swing.mjs <<'JS'
import { VRMSpringBoneJoint, VRMSpringBoneManager } from '@pixiv/three-vrm-springbone';
import { Object3D, Quaternion, Vector3 } from 'three';

for (const rate of [30, 60, 120, 240, 480]) {
  const [head, hair, tip] = [new Object3D(), new Object3D(), new Object3D()];
  head.add(hair);
  hair.add(tip);
  tip.position.set(0, -0.3, 0);
  head.updateMatrixWorld(true);
  const manager = new VRMSpringBoneManager();
  manager.addJoint(new VRMSpringBoneJoint(hair, tip,
      { hitRadius: 0, stiffness: 0, dragForce: 0.1, gravityPower: 1 }));
  manager.setInitState();
  let farthest = 0;
  for (let frame = 1; frame <= rate; ++frame) {
    head.position.x = Math.min(1, 4 * frame / rate);
    head.updateMatrixWorld(true);
    manager.update(1 / rate);
    head.updateMatrixWorld(true);
    const down = new Vector3(0, -1, 0).applyQuaternion(hair.getWorldQuaternion(new Quaternion()));
    farthest = Math.max(farthest, Math.atan2(-down.x, -down.y) * 180 / Math.PI);
  }
  console.log(`${rate} frames per second: the hair hangs back by ${Math.round(farthest)} degrees`);
}
JS
node swing.mjs | tee seen
cmp -s - seen <<'TEXT' || {
30 frames per second: the hair hangs back by 55 degrees
60 frames per second: the hair hangs back by 46 degrees
120 frames per second: the hair hangs back by 37 degrees
240 frames per second: the hair hangs back by 30 degrees
480 frames per second: the hair hangs back by 25 degrees
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
