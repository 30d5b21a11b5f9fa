#!/bin/sh
# SPDX-License-Identifier: MIT
# Commons Math 3.6.1 (Debian libcommons-math3-java 3.6.1-3): a quaternion turns the other way as a Rotation than as
# a Quaternion, and DBSCAN does not count a point among its own neighbours.
#
# Expected: new Rotation(w, x, y, z, false).applyTo(v) is q v q*, as it is with the Quaternion of the same
# library, and with three.js, Eigen and SciPy 1.10.1. A point is a core of a cluster if minPts points are
# within reach, itself among them, as in the paper of DBSCAN, in scikit-learn and in R's dbscan.
# Seen: (0.707, 0, 0, 0.707) turns X to Y by Quaternion and to -Y by Rotation, whose getQ3() of a turn to Y
# by VECTOR_OPERATOR is -0.707. So each quaternion of another program that goes in by this constructor, or
# comes out by getQ0() to getQ3(), turns backward. Of points that stand in a row, each with one on either
# side, none is a core of minPts 3: there are no clusters where others find two.
# Flinch: turns by Eigen, and has no clusters.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libcommons-math3-java=3.6.1-3 openjdk-17-jre-headless libbsh-java; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >turn.bsh <<'BSH'
import org.apache.commons.math3.complex.Quaternion;
import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.ml.clustering.DBSCANClusterer;
import org.apache.commons.math3.ml.clustering.DoublePoint;

half = Math.sqrt(0.5);
q = new Quaternion(half, 0, 0, half);
turned = q.multiply(new Quaternion(0, 1, 0, 0)).multiply(q.getConjugate()).getVectorPart();
print("X by the Quaternion: " + Math.round(turned[0]) + ", " + Math.round(turned[1]));
other = new Rotation(half, 0, 0, half, false).applyTo(Vector3D.PLUS_I);
print("X by the Rotation: " + Math.round(other.getX()) + ", " + Math.round(other.getY()));
z = new Rotation(Vector3D.PLUS_K, Math.PI / 2, RotationConvention.VECTOR_OPERATOR);
there = z.applyTo(Vector3D.PLUS_I);
print("sign of Q3 of the turn from X to " + Math.round(there.getX()) + ", " + Math.round(there.getY())
    + ": " + Math.signum(z.getQ3()));
points = new ArrayList();
for (x : new double[] {0, 0.5, 1, 1.5, 5, 5.5, 6, 6.5}) {
  points.add(new DoublePoint(new double[] {x}));
}
for (least : new int[] {2, 3}) {
  print("clusters, minPts " + least + ": " + new DBSCANClusterer(0.6, least).cluster(points).size());
}
BSH
usr/lib/jvm/java-17-openjdk-amd64/bin/java -cp usr/share/java/commons-math3.jar:usr/share/java/bsh.jar \
  bsh.Interpreter turn.bsh | tee seen
cmp -s - seen <<'TEXT' || {
X by the Quaternion: 0, 1
X by the Rotation: 0, -1
sign of Q3 of the turn from X to 0, 1: -1.0
clusters, minPts 2: 2
clusters, minPts 3: 0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
