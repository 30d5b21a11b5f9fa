#!/bin/sh
# SPDX-License-Identifier: MIT
# Assimp 5.2.5 (Debian libassimp-dev 5.2.5~ds0-1+b1): an FBX node whose rotation order is "spheric XYZ"
# loses its rotation, and one whose rotations are switched off keeps its pre-rotation.
#
# Expected: a node that is turned by 40 degrees is turned by 40 degrees, or the file is refused: 6,
# spheric XYZ, is one of the seven orders that the property RotationOrder may have. And where
# RotationActive is 0, the order and the pre- and post-rotation do not count, as Blender's reader has it
# (io_scene_fbx, blen_read_object_transform_do).
# Seen: ReadFile succeeds and GetErrorString is empty. With order 6 the node's matrix is the identity,
# at rest and in keys; only the log, which a program must ask for, has a line on it. RotationActive is
# not looked at: the pre-rotation turns the node.
# Flinch: looks for both in the bytes of the file, refuses the first and notes the second.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libassimp-dev libassimp5; do
  apt-get -o APT::Sandbox::User=root download -q "$package=5.2.5~ds0-1+b1" >/dev/null
  dpkg-deb -x "$package"_5.2.5*.deb .
done
library=$(dirname "$(find . -name 'libassimp.so' | head -n 1)")
# write ORDER ACTIVE PRE: a limb turned by 40 degrees about X after PRE degrees.
write() {
  cat <<FBX
; FBX 7.4.0 project file
FBXHeaderExtension: { FBXVersion: 7400
}
Objects: {
  Model: 1, "Model::Limb", "LimbNode" {
    Properties70: {
      P: "RotationOrder", "enum", "", "", $1
      P: "RotationActive", "bool", "", "", $2
      P: "PreRotation", "Vector3D", "Vector", "", $3,0,0
      P: "Lcl Rotation", "Lcl Rotation", "", "A", 40,0,0
    }
  }
}
Connections: {
  C: "OO", 1, 0
}
FBX
}
cat >turn.cpp <<'CPP'
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>

int main() {
  for (const char* file : {"euler.fbx", "spheric.fbx", "off.fbx"}) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file, 0);
    if (!scene) return std::puts(importer.GetErrorString()), 1;
    aiMatrix4x4 turn;
    for (const aiNode* node = scene->mRootNode->FindNode("Limb"); node; node = node->mParent)
      turn = node->mTransformation * turn;
    const double degrees = std::atan2(turn.c2, turn.b2) * 180 / std::acos(-1);
    std::printf("%s: turned by %.0f degrees, error \"%s\"\n", file, degrees,
                importer.GetErrorString());
  }
}
CPP
g++ -I usr/include turn.cpp -o turn -L "$library" -lassimp \
  -Wl,--unresolved-symbols=ignore-in-shared-libs
write 0 1 0 >euler.fbx
write 6 1 0 >spheric.fbx
write 0 0 30 >off.fbx
LD_LIBRARY_PATH=$library ./turn | tee seen
printf '%s.fbx: turned by %s degrees, error ""\n' euler 40 spheric 0 off 70 | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
