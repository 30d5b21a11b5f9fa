#!/bin/sh
# SPDX-License-Identifier: MIT
# Assimp 5.2.5 (Debian libassimp-dev 5.2.5~ds0-1+b1): a joint less than a centimetre from its parent, or
# turned by half a degree, is put into its parent when a .glb or .gltf is written.
#
# Expected: the exporter writes the transform of each node as it is.
# Seen: it leaves a transform out that is "identity", and that is each whose numbers are all within 0.01
# of it. glTF is in metres, so the last joints of fingers and toes, 9 mm long here, lie on each other,
# and a foot that is set at 0.46 degrees is straight. A file in centimetres keeps them, and the .x writer
# of the same version does too. Nothing says it.
# Flinch: writes its .glb itself.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libassimp-dev libassimp5; do
  apt-get -o APT::Sandbox::User=root download -q "$package=5.2.5~ds0-1+b1" >/dev/null
  dpkg-deb -x "$package"_5.2.5*.deb .
done
library=$(dirname "$(find . -name 'libassimp.so' | head -n 1)")
cat >hand.gltf <<'JSON'
{
  "asset": { "version": "2.0" },
  "scene": 0,
  "scenes": [{ "nodes": [0] }],
  "nodes": [
    { "name": "hand", "children": [1, 2, 3] },
    { "name": "thumb", "translation": [0.011, 0, 0] },
    { "name": "finger", "translation": [0.009, 0, 0] },
    { "name": "foot", "rotation": [0, 0, 0.004, 0.999992] }
  ]
}
JSON
cat >rewrite.cpp <<'CPP'
#include <assimp/scene.h>
#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>

void tell(const aiNode& node) {
  aiVector3D scale, place;
  aiQuaternion turn;
  node.mTransformation.Decompose(scale, turn, place);
  std::printf(" %s %g mm %.2f degrees", node.mName.C_Str(), std::round(1e4 * place.x) / 10,
              114.592 * turn.z);
  for (unsigned i = 0; i < node.mNumChildren; ++i) tell(*node.mChildren[i]);
}

int main() {
  const struct {
    const char* format;
    const char* file;
  } written[] = {{"", "hand.gltf"}, {"gltf2", "out.gltf"}, {"glb2", "out.glb"}, {"x", "out.x"}};
  Assimp::Importer importer;
  const aiScene* hand = importer.ReadFile("hand.gltf", 0);
  for (const auto& [format, file] : written) {
    if (*format) Assimp::Exporter().Export(hand, format, file);
    Assimp::Importer reader;
    const aiScene* scene = reader.ReadFile(file, 0);
    if (!scene) return std::puts(reader.GetErrorString()), 1;
    std::printf("%s:", file);
    tell(*scene->mRootNode->FindNode("hand"));
    std::puts("");
  }
}
CPP
g++ -std=c++17 -I usr/include rewrite.cpp -o rewrite -L "$library" -lassimp \
  -Wl,--unresolved-symbols=ignore-in-shared-libs
LD_LIBRARY_PATH=$library ./rewrite | tee seen
cmp -s - seen <<'TEXT' || {
hand.gltf: hand 0 mm 0.00 degrees thumb 11 mm 0.00 degrees finger 9 mm 0.00 degrees foot 0 mm 0.46 degrees
out.gltf: hand 0 mm 0.00 degrees thumb 11 mm 0.00 degrees finger 0 mm 0.00 degrees foot 0 mm 0.00 degrees
out.glb: hand 0 mm 0.00 degrees thumb 11 mm 0.00 degrees finger 0 mm 0.00 degrees foot 0 mm 0.00 degrees
out.x: hand 0 mm 0.00 degrees thumb 11 mm 0.00 degrees finger 9 mm 0.00 degrees foot 0 mm 0.46 degrees
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
