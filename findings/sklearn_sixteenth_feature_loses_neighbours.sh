#!/bin/sh
# SPDX-License-Identifier: MIT
# scikit-learn 1.2.1 (Debian python3-sklearn 1.2.1+dfsg-1): with one feature more, the exact nearest
# neighbours are others, at a distance of 0.
#
# Expected: NearestNeighbors with its defaults is exact, whichever algorithm "auto" takes. A column
# that is the same in all rows, such as a recording's time in seconds since 1970, does not change a
# distance.
# Seen: to 15 features "auto" takes a k-d tree, and the neighbours are right. From 16 on it takes
# brute force, which expands |a - b|^2 into |a|^2 - 2 a.b + |b|^2. With a column of 1.7e9 these are
# 3e18, of which a double keeps steps of 512: 199 of 200 neighbours are wrong and their distances 0.
# A classifier or regressor does the same. The manual says of euclidean_distances that it is not the
# most precise way; where it compares the neighbours' algorithms, it speaks of their speed.
# Flinch: searches scaled features by FLANN, which sums squared differences.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-sklearn=1.2.1+dfsg-1 python3-sklearn-lib=1.2.1+dfsg-1 python3-scipy \
  python3-numpy python3-joblib python3-threadpoolctl python3-decorator liblbfgsb0 libblas3 liblapack3 \
  libgfortran5 libquadmath0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >poses.py <<'PY'
import numpy
from sklearn.neighbors import NearestNeighbors

draw = numpy.random.default_rng(1)
for angles in 14, 15:
    poses = draw.normal(size=(1000, angles))
    asked = poses[:200] + 0.01 * draw.normal(size=(200, angles))
    poses, asked = (numpy.column_stack([x, numpy.full(len(x), 1.7e9)]) for x in (poses, asked))
    for algorithm in "auto", "kd_tree":
        search = NearestNeighbors(n_neighbors=1, algorithm=algorithm).fit(poses)
        distances, found = search.kneighbors(asked)
        wrong = (found[:, 0] != numpy.arange(200)).sum()
        print(f"{angles + 1} features, {algorithm}: {'some' if wrong else 'none'} of 200 wrong,",
              f"median distance {numpy.median(distances):.2f}")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 poses.py | tee seen
printf '%s\n' '15 features, auto: none of 200 wrong, median distance 0.04' \
  '15 features, kd_tree: none of 200 wrong, median distance 0.04' \
  '16 features, auto: some of 200 wrong, median distance 0.00' \
  '16 features, kd_tree: none of 200 wrong, median distance 0.04' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
