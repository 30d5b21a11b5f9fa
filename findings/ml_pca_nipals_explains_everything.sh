#!/bin/sh
# SPDX-License-Identifier: MIT
# ml-pca 4.1.1 (npm): by NIPALS, the components that are kept always explain all of the variance.
#
# Expected: getExplainedVariance() of one component out of three, on data that spread alike in all three,
# is about a third, as it is by the default method, and getEigenvalues() are variances by both methods.
# Seen: by NIPALS the shares are of the kept components' sum, so one component explains 1, and two explain
# 0.50 and 0.50. Who adds components until 95 % is explained stops at the first. The eigenvalues
# are sums of squares: n - 1 times the variances, 199 times for 200 rows.
# Flinch: makes its principal components by Eigen, and their number is fixed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . ml-pca@4.1.1 >/dev/null
cat >explained.mjs <<'JS'
import { PCA } from 'ml-pca';

const rows = Array.from({ length: 200 }, (_, i) =>
  [Math.sin(1.3 * i), Math.sin(2.9 * i + 1), Math.sin(4.1 * i + 2)]);
const shares = (pca) => pca.getExplainedVariance().map((share) => share.toFixed(2)).join(' ');
const svd = new PCA(rows);
const nipals = (n) => new PCA(rows, { method: 'NIPALS', nCompNIPALS: n });
console.log(`SVD: ${shares(svd)}`);
console.log(`NIPALS, 1 component: ${shares(nipals(1))}; 2: ${shares(nipals(2))}`);
const ratio = nipals(1).getEigenvalues()[0] / svd.getEigenvalues()[0];
console.log(`first eigenvalue by NIPALS over that by SVD: ${Math.round(ratio)}`);
JS
node explained.mjs | tee seen
printf '%s\n' 'SVD: 0.34 0.33 0.33' 'NIPALS, 1 component: 1.00; 2: 0.50 0.50' \
  'first eigenvalue by NIPALS over that by SVD: 199' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
