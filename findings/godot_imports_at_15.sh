#!/bin/sh
# SPDX-License-Identifier: MIT
# Godot 3.2.3 (Debian godot3-server 3.2.3-stable-1+b3): a blow of one frame at 60 per second is not in the
# scene that it imports from a .glb.
#
# Expected: the keys of a .glb become the keys of the animation: format and engine both have keys at any
# time.
# Seen: the importer samples each track 15 times per second and drops the keys, without a word. A ball that
# lies at 0, is at 1 m after 31 frames and back at 0 after 32, lies at 0 all the time. With
# animation/fps=60 and animation/optimizer/enabled=false in the file NAME.glb.import it moves.
# Flinch: docs/exporting.md says so and has such a file, and a test imports by it.
set -eu
folder=$(mktemp -d)
editor=
trap 'test -z "$editor" || kill "$editor" 2>/dev/null || :; rm -rf "$folder"' EXIT
cd "$folder"
for package in godot3-server=3.2.3-stable-1+b3 libenet7 libfreetype6 libogg0 libopus0 libpcre2-32-0 \
  libpng16-16 libsquish0 libtheora0 libvorbis0a libvpx7 libwebp7 libbrotli1; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
HOME=$folder
LD_LIBRARY_PATH=$folder/usr/lib/x86_64-linux-gnu
export HOME LD_LIBRARY_PATH
mkdir project
cd project
cat >write.py <<'PY'
import json
import struct

times = [frame / 60 for frame in range(61)]
places = [(1.0 if frame == 31 else 0.0, 0.0, 0.0) for frame in range(61)]
binary = struct.pack("<61f", *times) + b"".join(struct.pack("<3f", *place) for place in places)
text = json.dumps({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "Ball"}],
    "buffers": [{"byteLength": len(binary)}],
    "bufferViews": [{"buffer": 0, "byteLength": 244},
                    {"buffer": 0, "byteOffset": 244, "byteLength": 732}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 61, "type": "SCALAR",
                   "min": [0], "max": [1]},
                  {"bufferView": 1, "componentType": 5126, "count": 61, "type": "VEC3"}],
    "animations": [{"name": "blow", "samplers": [{"input": 0, "output": 1}],
                    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]})
text += " " * (-len(text) % 4)
for name in "plain.glb", "told.glb":
    with open(name, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text.encode())
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)
PY
/usr/bin/python3 write.py
cat >told.glb.import <<'TEXT'
[remap]

importer="scene"
type="PackedScene"

[params]

animation/fps=60
animation/optimizer/enabled=false
TEXT
printf '%s\n' config_version=4 '' '[application]' '' 'config/name="Blow"' >project.godot
cat >blow.gd <<'GD'
extends SceneTree


func _initialize():
	for name in ["plain", "told"]:
		var scene = load("res://%s.glb" % name).instance()
		root.add_child(scene)
		var player = scene.find_node("AnimationPlayer", true, false)
		player.play("blow")
		var farthest = 0.0
		for step in range(241):
			player.seek(step / 240.0, true)
			farthest = max(farthest, scene.find_node("Ball", true, false).translation.x)
		print("%s: the ball comes to %.2f m" % [name, farthest])
	quit()
GD
../usr/bin/godot3-server --path . --editor --quit >/dev/null 2>&1 &
editor=$!
tries=0
while [ "$(find .import -name '*.md5' 2>/dev/null | wc -l)" -lt 2 ] && [ "$tries" -lt 300 ]; do
  sleep 0.2
  tries=$((tries + 1))
done
kill -9 "$editor" 2>/dev/null || :
editor=
../usr/bin/godot3-server --path . --script blow.gd 2>/dev/null | grep ' m$' | tee seen
cmp -s - seen <<'TEXT' || {
plain: the ball comes to 0.00 m
told: the ball comes to 1.00 m
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
