#!/bin/sh
# SPDX-License-Identifier: MIT
# XGBoost 1.7.4 (Debian python3-xgboost 1.7.4-1): the same rows get other answers as a sparse matrix or as a
# file in libsvm's format.
#
# Expected: in SciPy's sparse matrices, and in files of the format "label index:value", what is not there
# is 0. libsvm, liblinear and scikit-learn take it so.
# Seen: what is not there is missing, and goes down the branch of missing values, which a model from an
# array without gaps never learned. A model that knows all 400 rows names half of them rightly when the
# same rows come as a CSR matrix, or from a file whose zeros are left out, as svm-scale and
# dump_svmlight_file leave them out. There is no warning. Fitted on a sparse form it is right on all.
# Flinch: the .libsvm files that it exports have every feature in every row, zeros too.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-xgboost=1.7.4-1 libxgboost0=1.7.4-1 libdmlc0 libgomp1 python3-sklearn=1.2.1+dfsg-1 \
  python3-sklearn-lib=1.2.1+dfsg-1 python3-scipy=1.10.1-2 python3-numpy python3-joblib \
  python3-threadpoolctl python3-decorator liblbfgsb0 libblas3 liblapack3 libgfortran5 libquadmath0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >zeros.py <<'PY'
import numpy
import scipy.sparse
import xgboost
from sklearn.datasets import dump_svmlight_file

draw = numpy.random.default_rng(1)
rows = draw.normal(size=(400, 3))
rows[draw.random(400) < 0.5, 0] = 0
hit = (rows[:, 0] > -0.3).astype(int)
dump_svmlight_file(rows, hit, "rows.libsvm")
forms = {"array": xgboost.DMatrix(rows, hit),
         "CSR matrix": xgboost.DMatrix(scipy.sparse.csr_matrix(rows), hit),
         "libsvm file": xgboost.DMatrix("rows.libsvm?format=libsvm")}
options = {"objective": "binary:logistic", "max_depth": 2, "nthread": 1}
for fitted in "array", "CSR matrix":
    model = xgboost.train(options, forms[fitted], 20)
    for asked, form in forms.items():
        right = ((model.predict(form) > 0.5) == hit).sum()
        print(f"fitted on {fitted}, asked by {asked}: {right} of 400 right")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 zeros.py 2>/dev/null | tee seen
cmp -s - seen <<'TEXT' || {
fitted on array, asked by array: 400 of 400 right
fitted on array, asked by CSR matrix: 196 of 400 right
fitted on array, asked by libsvm file: 196 of 400 right
fitted on CSR matrix, asked by array: 400 of 400 right
fitted on CSR matrix, asked by CSR matrix: 400 of 400 right
fitted on CSR matrix, asked by libsvm file: 400 of 400 right
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
