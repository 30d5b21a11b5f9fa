#!/bin/sh
# SPDX-License-Identifier: MIT
# scikit-learn 1.2.1 (Debian python3-sklearn 1.2.1+dfsg-1): StratifiedGroupKFold with shuffle=True does not
# stratify, and makes folds of other sizes.
#
# Expected: takes stay whole, and each of five folds has about the same share of hits, with shuffle=True as
# without. The documentation says that only groups of about the same distribution are shuffled.
# Seen: the counts of classes are shuffled, but not the numbers of the groups that they belong to, so a
# fold is filled by the counts of other groups. Of 40 takes with 16 % of hits, folds have 12 to 21 %
# without a shuffle, and 0 to 47 % with seed 3; a fold without a hit measures nothing. The folds' sizes
# go from 179 to 282 frames, in place of 232 to 256. Pull request 32540 of scikit-learn mends it.
# Flinch: draws its folds itself.
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
cat >folds.py <<'PY'
import numpy
from sklearn.model_selection import StratifiedGroupKFold

draw = numpy.random.default_rng(1)
takes, hits = [], []
for take in range(40):
    frames = draw.integers(5, 60)
    hit = draw.random() < 0.25
    takes += [take] * frames
    hits += [int(hit)] * frames
takes, hits = numpy.array(takes), numpy.array(hits)
for options in ({}, {"shuffle": True, "random_state": 0}, {"shuffle": True, "random_state": 3}):
    folds = [fold for _, fold in StratifiedGroupKFold(5, **options).split(hits, hits, takes)]
    shares = ", ".join(f"{100 * hits[fold].mean():.0f}" for fold in folds)
    sizes = ", ".join(str(len(fold)) for fold in folds)
    print(f"{options or 'no shuffle'}: {shares} % of hits in {sizes} frames")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 folds.py | tee seen
cmp -s - seen <<'TEXT' || {
no shuffle: 12, 14, 15, 18, 21 % of hits in 232, 239, 241, 250, 256 frames
{'shuffle': True, 'random_state': 0}: 20, 10, 22, 34, 0 % of hits in 230, 294, 252, 202, 240 frames
{'shuffle': True, 'random_state': 3}: 16, 47, 0, 4, 23 % of hits in 280, 179, 233, 282, 244 frames
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
