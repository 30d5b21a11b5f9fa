#!/bin/sh
# SPDX-License-Identifier: MIT
# matter-js 0.20.0 (npm): a ball stays where it is on a slope of 12 degrees.
#
# Expected: Bodies.circle makes a circle. On a slope with enough friction it rolls with two thirds of the
# acceleration of what slides, from the smallest angle on, at any radius.
# Seen: it is a polygon with as many sides as its radius has units, 10 at least and 26 at most. It stands on
# a side until the slope is steeper than a half of the angle between two sides: a ball with a radius of
# 10 stays on 12 degrees, and one of 60 on 4. The argument maxSides is 25 unless told, and does not raise
# the number for a small radius. A ball of planck 1.5.0 (npm) rolls on all of them.
# Flinch: its balls are spheres, in its own solver and in ODE.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . matter-js@0.20.0 planck@1.5.0 >/dev/null
cat >roll.mjs <<'JS'
import matter from 'matter-js';
import { Box, Circle, Vec2, World } from 'planck';

const { Bodies, Composite, Engine } = matter;
// How many radii a ball has gone after 2 s on a slope, which is as steep to all sizes.
function byMatter(radius, slope) {
  const engine = Engine.create();
  engine.gravity.scale *= radius / 60;
  const ground = Bodies.rectangle(0, 0, 200 * radius, 2 * radius,
      { isStatic: true, angle: slope, friction: 1 });
  const ball = Bodies.circle(0, -2 * radius / Math.cos(slope), radius, { friction: 1, frictionAir: 0 });
  Composite.add(engine.world, [ground, ball]);
  for (let frame = 0; frame < 120; ++frame) Engine.update(engine, 1000 / 60);
  return ball.position.x / radius;
}
function byPlanck(slope) {
  const world = new World(new Vec2(0, 10));
  world.createBody({ angle: slope }).createFixture({ shape: new Box(100, 0.6), friction: 1 });
  const ball = world.createDynamicBody({ position: new Vec2(0, -1.2 / Math.cos(slope)) });
  ball.createFixture({ shape: new Circle(0.6), density: 1, friction: 1 });
  for (let frame = 0; frame < 120; ++frame) world.step(1 / 60);
  return ball.getPosition().x / 0.6;
}
for (const degrees of [4, 8, 12]) {
  const slope = degrees * Math.PI / 180;
  const tell = (radii) => (radii < 1 ? 'stays' : 'rolls');
  console.log(`${degrees} degrees: matter ${[10, 20, 60].map((radius) =>
    `radius ${radius} ${tell(byMatter(radius, slope))}`).join(', ')}; planck ${tell(byPlanck(slope))}`);
}
JS
node roll.mjs | tee seen
cmp -s - seen <<'TEXT' || {
4 degrees: matter radius 10 stays, radius 20 stays, radius 60 stays; planck rolls
8 degrees: matter radius 10 stays, radius 20 rolls, radius 60 rolls; planck rolls
12 degrees: matter radius 10 stays, radius 20 rolls, radius 60 rolls; planck rolls
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
