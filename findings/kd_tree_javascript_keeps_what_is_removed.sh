#!/bin/sh
# SPDX-License-Identifier: MIT
# kd-tree-javascript 1.0.3 (npm): remove() leaves points in the tree that share a coordinate with
# others.
#
# Expected: after remove(point) no search finds that point.
# Seen: of 50 points removed from 200 on a grid of 10 by 10, 37 are still found, without an error. The
# constructor sorts and takes the middle, so points that are equal to it in that coordinate stand on
# both sides; remove looks only on the side of the larger ones. Where all coordinates differ it
# removes all 50. Points on a grid, angles in whole degrees and poses of one clip share coordinates.
# Flinch: searches by FLANN and removes nothing from an index.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . kd-tree-javascript@1.0.3 >/dev/null
cat >remove.cjs <<'JS'
const { kdTree } = require('kd-tree-javascript');

let state = 7;
const draw = () => (state = (state * 1103515245 + 12345) % 2147483648) / 2147483648;
for (const cells of [10, 1e6]) {
  const points = Array.from({ length: 200 },
      () => ({ x: Math.floor(draw() * cells), y: Math.floor(draw() * cells) }));
  const tree = new kdTree([...points], (a, b) => Math.hypot(a.x - b.x, a.y - b.y), ['x', 'y']);
  const removed = points.slice(0, 50);
  for (const point of removed) tree.remove(point);
  const found = new Set(tree.nearest({ x: 0, y: 0 }, 1000).map(([point]) => point));
  const still = removed.filter((point) => found.has(point)).length;
  console.log(`grid of ${cells}: ${still} of 50 removed points are still found`);
}
JS
node remove.cjs | tee seen
printf '%s\n' 'grid of 10: 37 of 50 removed points are still found' \
  'grid of 1000000: 0 of 50 removed points are still found' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
