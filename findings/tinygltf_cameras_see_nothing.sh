#!/bin/sh
# SPDX-License-Identifier: MIT
# tinygltf 2.7.0 (Debian libtinygltf-dev 2.7.0+dfsg-2): a camera that sees to infinity sees nothing in the
# file that it writes, and a channel of KHR_animation_pointer is gone, while both functions return true.
#
# Expected: LoadASCIIFromFile() and WriteGltfSceneToFile() keep what a valid file has, or return false.
# Seen: without zfar, which glTF 2.0 allows for a perspective of infinite depth, the written camera has a
# zfar of 0, which glTF forbids: it lies before the camera's near plane. A channel without a node, as
# Khronos' extension KHR_animation_pointer has it, is dropped; the string of errors says so, the result is
# true all the same. Where an animation has no other channel, all of "animations" is null.
# Flinch: writes its .glb itself, and imports by Assimp.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libtinygltf-dev=2.7.0+dfsg-2 nlohmann-json3-dev; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >write.py <<'PY'
import base64
import json
import struct

binary = struct.pack("<8f", 0, 1, 0, 0, 0, 1, 2, 3)
channel = {"sampler": 0, "target": {"node": 0, "path": "translation"}}
pointer = {"sampler": 0, "target": {"path": "pointer", "extensions": {
    "KHR_animation_pointer": {"pointer": "/nodes/1/translation"}}}}
for name, channels in ("one.gltf", [pointer]), ("two.gltf", [channel, pointer]):
    with open(name, "w") as file:
        json.dump({
            "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_animation_pointer"],
            "scenes": [{"nodes": [0, 1]}], "nodes": [{"camera": 0}, {}],
            "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
            "animations": [{"samplers": [{"input": 0, "output": 1}], "channels": channels}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR",
                           "min": [0], "max": [1]},
                          {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 8},
                            {"buffer": 0, "byteOffset": 8, "byteLength": 24}],
            "buffers": [{"byteLength": 32, "uri": "data:application/octet-stream;base64,"
                         + base64.b64encode(binary).decode()}]}, file)
PY
/usr/bin/python3 write.py
cat >read.py <<'PY'
import json

for name in "one", "two":
    with open(name + "_again.gltf") as file:
        written = json.load(file)
    animations = written["animations"]
    print(f"{name}: camera {written['cameras'][0]['perspective']}, "
          f"channels {animations and len(animations[0]['channels'])}")
PY
cat >again.cpp <<'CPP'
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <cstdio>
#include <string>
#include <tiny_gltf.h>

int main() {
  for (const std::string name : {"one", "two"}) {
    tinygltf::TinyGLTF gltf;
    tinygltf::Model model;
    std::string errors;
    std::string warnings;
    const bool read = gltf.LoadASCIIFromFile(&model, &errors, &warnings, name + ".gltf");
    const bool written = gltf.WriteGltfSceneToFile(&model, name + "_again.gltf", true, true, true, false);
    std::printf("%s: %s, %s\n", name.c_str(), read ? "read" : "not read",
                written ? "written" : "not written");
  }
}
CPP
g++ -std=c++17 -O0 -w -I usr/include again.cpp -o again
{
  ./again
  /usr/bin/python3 read.py
} | tee seen
cmp -s - seen <<'TEXT' || {
one: read, written
two: read, written
one: camera {'yfov': 1.0, 'zfar': 0.0, 'znear': 0.1}, channels None
two: camera {'yfov': 1.0, 'zfar': 0.0, 'znear': 0.1}, channels 1
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
