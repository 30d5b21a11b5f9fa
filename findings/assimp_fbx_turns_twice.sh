#!/bin/sh
# SPDX-License-Identifier: MIT
# Assimp 5.2.5 (Debian libassimp-dev 5.2.5~ds0-1+b1): an animated FBX limb with a pre-rotation is turned
# by it twice, and without helper nodes a post-rotation turns the wrong way.
#
# Expected: keys that say what the rest pose says leave a figure as it is. As aiNodeAnim documents,
# a channel's keys take the place of its node's transformation.
# Seen: for a node "Limb" with a pre-rotation of 90 degrees, Assimp makes nodes
# Limb_$AssimpFbx$_PreRotation and _Rotation above "Limb", and a channel for "Limb" alone. Its keys
# hold the whole product, pre-rotation included, while the nodes above still hold theirs, so keys equal
# to the rest pose move the limb by 90 degrees. With AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS off the nodes
# are one, and keys fit them. But FBX multiplies by the inverse of the post-rotation, as the helper
# nodes do, and the single node does not invert it: of one file the two options give rest poses that
# are 180 degrees apart for a post-rotation of 90. Joint orientations of Maya are pre-rotations.
# Flinch: keeps the helper nodes, and lets the keys stand for their product, with the post-rotation
# inverted.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libassimp-dev libassimp5; do
  apt-get -o APT::Sandbox::User=root download -q "$package=5.2.5~ds0-1+b1" >/dev/null
  dpkg-deb -x "$package"_5.2.5*.deb .
done
library=$(dirname "$(find . -name 'libassimp.so' | head -n 1)")
# write PRE POST: a limb turned by 10 degrees about X, at rest and by its one curve, at 0 s and 1 s.
write() {
  cat <<FBX
; FBX 7.4.0 project file
FBXHeaderExtension: { FBXVersion: 7400
}
Objects: {
  Model: 1, "Model::Limb", "LimbNode" {
    Properties70: {
      P: "RotationActive", "bool", "", "", 1
      P: "PreRotation", "Vector3D", "Vector", "", 0,0,$1
      P: "PostRotation", "Vector3D", "Vector", "", 0,0,$2
      P: "Lcl Rotation", "Lcl Rotation", "", "A", 10,0,0
    }
  }
  AnimationStack: 2, "AnimStack::Take", "" {
  }
  AnimationLayer: 3, "AnimLayer::Base", "" {
  }
  AnimationCurveNode: 4, "AnimCurveNode::R", "" {
    Properties70: {
      P: "d|X", "Number", "", "A", 10
    }
  }
  AnimationCurve: 5, "AnimCurve::", "" {
    KeyTime: *2 { a: 0,46186158000
    }
    KeyValueFloat: *2 { a: 10,10
    }
  }
}
Connections: {
  C: "OO", 1, 0
  C: "OO", 3, 2
  C: "OO", 4, 3
  C: "OP", 4, 1, "Lcl Rotation"
  C: "OP", 5, 4, "d|X"
}
FBX
}
cat >turn.cpp <<'CPP'
#include <assimp/config.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>

struct Limb {
  aiMatrix4x4 at_rest;   // in the world
  aiMatrix4x4 animated;  // in the world, by the first key
};

Limb read(const char* file, bool helpers) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, helpers);
  const aiScene* scene = importer.ReadFile(file, 0);
  if (!scene) return std::puts(importer.GetErrorString()), Limb{};
  const aiNodeAnim& channel = *scene->mAnimations[0]->mChannels[0];
  Limb limb;
  for (const aiNode* node = scene->mRootNode->FindNode("Limb"); node; node = node->mParent) {
    const aiMatrix4x4 key(channel.mRotationKeys[0].mValue.GetMatrix());
    limb.at_rest = node->mTransformation * limb.at_rest;
    limb.animated = (node->mName == channel.mNodeName ? key : node->mTransformation) * limb.animated;
  }
  return limb;
}

double degrees_between(aiMatrix4x4 a, const aiMatrix4x4& b) {
  const aiMatrix4x4 turn = a.Inverse() * b;
  const double cosine = (turn.a1 + turn.b2 + turn.c3 - 1) / 2.0;
  return std::acos(std::fmin(1, std::fmax(-1, cosine))) * 180 / std::acos(-1);
}

int main() {
  for (const char* file : {"plain.fbx", "pre.fbx", "post.fbx"}) {
    const Limb helpers = read(file, true);
    const Limb single = read(file, false);
    std::printf("%s: keys of the rest pose turn it by %.0f, without helpers by %.0f; "
                "rest poses are %.0f degrees apart\n",
                file, degrees_between(helpers.at_rest, helpers.animated),
                degrees_between(single.at_rest, single.animated),
                degrees_between(helpers.at_rest, single.at_rest));
  }
}
CPP
g++ -I usr/include turn.cpp -o turn -L "$library" -lassimp \
  -Wl,--unresolved-symbols=ignore-in-shared-libs
write 0 0 >plain.fbx
write 90 0 >pre.fbx
write 0 90 >post.fbx
LD_LIBRARY_PATH=$library ./turn | tee seen
printf '%s: keys of the rest pose turn it by %s, without helpers by %s; rest poses are %s degrees apart\n' \
  plain.fbx 0 0 0 pre.fbx 90 0 0 post.fbx 90 0 180 | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
