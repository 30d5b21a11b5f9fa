#!/bin/sh
# SPDX-License-Identifier: MIT
# Assimp 5.2.5 (Debian libassimp-dev 5.2.5~ds0-1+b1): of the formats with skeletal animation that it
# writes, it reads one back as it was.
#
# Expected: a .bvh that Assimp reads, four frames at 30 per second (0.1 s), keeps its animation when
# Assimp writes it to .glb, .fbx (binary or text) or .dae and reads it again.
# Seen: .glb keeps it. Text .fbx lasts 3 s: the writer takes frame numbers for seconds and ignores the
# rate. Binary .fbx and .dae are refused by the reader of the same library. None of the writers
# returns an error.
# Flinch: imports .glb, .gltf and .fbx by Assimp but writes its own .glb; its tests of .fbx use files
# that were not written by Assimp.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libassimp-dev libassimp5; do
  apt-get -o APT::Sandbox::User=root download -q "$package=5.2.5~ds0-1+b1" >/dev/null
  dpkg-deb -x "$package"_5.2.5*.deb .
done
library=$(dirname "$(find . -name 'libassimp.so' | head -n 1)")
cat >figure.bvh <<'BVH'
HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine
  {
    OFFSET 0 10 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 10 0
    }
  }
}
MOTION
Frames: 4
Frame Time: 0.0333333
0 90 0 0 0 0 10 0 0
0 90 0 0 0 0 20 0 0
0 90 0 0 0 0 30 0 0
0 90 0 0 0 0 40 0 0
BVH
cat >round_trip.cpp <<'CPP'
#include <assimp/scene.h>
#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <cstdio>
#include <string>

int main() {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile("figure.bvh", 0);
  const struct {
    const char* format;
    const char* file;
  } formats[] = {{"glb2", "binary.glb"}, {"fbxa", "text.fbx"}, {"fbx", "binary.fbx"},
                 {"collada", "text.dae"}};
  for (const auto& [format, file] : formats) {
    Assimp::Exporter exporter;
    const bool written = exporter.Export(scene, format, file) == aiReturn_SUCCESS;
    Assimp::Importer reader;
    const aiScene* read = reader.ReadFile(file, 0);
    std::printf("%s: %s, ", file, written ? "written" : "not written");
    if (read && read->HasAnimations()) {
      const aiAnimation& animation = *read->mAnimations[0];
      std::printf("read back with %.1f s\n", animation.mDuration / animation.mTicksPerSecond);
    } else {
      std::printf("not read back: %s\n", reader.GetErrorString());
    }
  }
}
CPP
g++ -std=c++17 -I usr/include round_trip.cpp -o round_trip -L "$library" -lassimp \
  -Wl,--unresolved-symbols=ignore-in-shared-libs
LD_LIBRARY_PATH=$library ./round_trip 2>/dev/null | tee seen
grep -qx 'binary.glb: written, read back with 0.1 s' seen &&
  grep -qx 'text.fbx: written, read back with 3.0 s' seen &&
  grep -q '^binary.fbx: written, not read back' seen &&
  grep -q '^text.dae: written, not read back' seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
