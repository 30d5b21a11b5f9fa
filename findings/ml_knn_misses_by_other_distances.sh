#!/bin/sh
# SPDX-License-Identifier: MIT
# ml-knn 3.0.0 (npm): with a distance function of one's own, the neighbours are not the nearest.
#
# Expected: KNN's option "distance" is a function of two points, and the neighbours are those that
# it says are nearest. There is no word of approximation.
# Seen: the points are in a k-d tree, which leaves a branch out where the distance to the splitting
# plane, along one axis, is greater than the best so far. That bounds a Euclidean distance from
# below, but not others. By the cosine of the angle 30 of 200 answers are not the nearest of 300
# points, and by a Mahalanobis distance 11. Nothing tells them from the right ones. The README says
# no more of the option than that its default is Euclidean.
# Flinch: does not use it. Its kd-tree has the Euclidean distance only.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . ml-knn@3.0.0 >/dev/null
cat >nearest.mjs <<'JS'
import KNN from 'ml-knn';

let state = 1;
const draw = () => (state = (state * 1664525 + 1013904223) % 2 ** 32) / 2 ** 32 - 0.5;
const point = () => [draw(), draw(), draw()];
const points = Array.from({ length: 300 }, point);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const less = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const distances = {
  Euclidean: (a, b) => Math.sqrt(dot(less(a, b), less(a, b))),
  cosine: (a, b) => 1 - dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b)),
  Mahalanobis(a, b) {
    const way = less(a, b);
    return Math.sqrt(dot(way, way) + 1.8 * way[0] * way[1]);
  },
};
for (const [name, distance] of Object.entries(distances)) {
  const knn = new KNN(points, points.map((_, number) => number), { k: 1, distance });
  const asked = Array.from({ length: 200 }, point);
  const missed = asked.filter((one) => {
    const found = points[knn.predict([one])[0]];
    return distance(one, found) > Math.min(...points.map((other) => distance(one, other)));
  });
  console.log(`${name}: ${missed.length} of 200 are not the nearest`);
}
JS
node nearest.mjs | tee seen
printf '%s of 200 are not the nearest\n' 'Euclidean: 0' 'cosine: 30' 'Mahalanobis: 11' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
