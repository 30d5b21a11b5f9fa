#!/bin/sh
# SPDX-License-Identifier: MIT
# Rapier 0.21.0 (npm @dimforge/rapier3d-compat): a ray or a query of the world sees what the last step
# saw, and no new collider at all.
#
# Expected: a ray that is cast after a collider was made or a body moved meets it where it is; getters
# such as translation() give the new place at once. Or a function brings queries up to date.
# Seen: a ball that was just made is not hit, nor found by intersectionsWithShape, until world.step().
# One that was moved by setTranslation is hit where it stood before. The collider's own castRay does
# hit it. propagateModifiedBodyPositionsToColliders, which the documentation names for this, is
# not enough for a new one: only a step is, be it one of timestep 0.
# Flinch: has no such queries; who places its figure and looks for free space around it steps first.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @dimforge/rapier3d-compat@0.21.0 >/dev/null
cat >ray.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';

await Rapier.init();
const world = new Rapier.World({ x: 0, y: 0, z: 0 });
const ray = new Rapier.Ray({ x: -5, y: 0, z: 0 }, { x: 1, y: 0, z: 0 });
const show = (when) => {
  const hit = world.castRay(ray, 100, true);
  console.log(`${when}: ${hit ? `hit at ${hit.timeOfImpact} m` : 'no hit'}`);
};
const body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic());
const collider = world.createCollider(Rapier.ColliderDesc.ball(0.5), body);
show('new');
world.propagateModifiedBodyPositionsToColliders();
show('propagated');
console.log(`the collider itself: hit at ${collider.castRay(ray, 100, true)} m`);
world.timestep = 0;
world.step();
show('stepped by 0 s');
body.setTranslation({ x: 0, y: 10, z: 0 }, true);
show('moved by 10 m');
world.step();
show('stepped again');
JS
node ray.mjs | tee seen
printf '%s\n' 'new: no hit' 'propagated: no hit' 'the collider itself: hit at 4.5 m' \
  'stepped by 0 s: hit at 4.5 m' 'moved by 10 m: hit at 4.5 m' 'stepped again: no hit' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
