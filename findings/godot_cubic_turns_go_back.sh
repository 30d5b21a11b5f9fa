#!/bin/sh
# SPDX-License-Identifier: MIT
# Godot 3.2.3 (Debian godot3-server 3.2.3-stable-1+b3): with cubic interpolation, a figure that turns evenly
# turns back after each key, and moves evenly.
#
# Expected: a transform track with keys at 0, 1, 2 s and so on, each a metre on and turned by 0.5 rad more,
# is an even walk along a bend: halfway between keys at the half, a quarter after a key at the quarter.
# Seen: the places are so. The turns go back first: an eighth of a second after the key at 1.00 rad it is
# at 0.98, in the middle at 1.25, and before the key at 1.50 at 1.52. Quat.cubic_slerp mixes the turn
# between the two keys with that between their neighbours as if the latter began at the key before; in
# the middle the two agree. With INTERPOLATION_LINEAR the turns are even.
# Flinch: its .glb has a key on every frame and linear interpolation.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in godot3-server=3.2.3-stable-1+b3 libenet7 libfreetype6 libogg0 libopus0 libpcre2-32-0 \
  libpng16-16 libsquish0 libtheora0 libvorbis0a libvpx7 libwebp7 libbrotli1; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >walk.gd <<'GD'
extends SceneTree

func _init():
	for type in [Animation.INTERPOLATION_LINEAR, Animation.INTERPOLATION_CUBIC]:
		var walk = Animation.new()
		walk.length = 5
		var track = walk.add_track(Animation.TYPE_TRANSFORM)
		walk.track_set_interpolation_type(track, type)
		for key in range(6):
			walk.transform_track_insert_key(track, key, Vector3(key, 0, 0),
					Quat(Vector3.UP, 0.5 * key), Vector3.ONE)
		for eighth in [0, 1, 2, 4, 6, 7, 8]:
			var pose = walk.transform_track_interpolate(track, 2 + eighth / 8.0)
			print("%s, %.3f s: %.3f m, %.2f rad" % ["cubic" if type == Animation.INTERPOLATION_CUBIC
					else "linear", 2 + eighth / 8.0, pose[0].x, 2 * atan2(pose[1].y, pose[1].w)])
	quit()
GD
HOME=$folder LD_LIBRARY_PATH=usr/lib/x86_64-linux-gnu \
  usr/bin/godot3-server --no-window -s walk.gd 2>/dev/null |
  grep ' rad$' | tee seen
cmp -s - seen <<'TEXT' || {
linear, 2.000 s: 2.000 m, 1.00 rad
linear, 2.125 s: 2.125 m, 1.06 rad
linear, 2.250 s: 2.250 m, 1.12 rad
linear, 2.500 s: 2.500 m, 1.25 rad
linear, 2.750 s: 2.750 m, 1.37 rad
linear, 2.875 s: 2.875 m, 1.44 rad
linear, 3.000 s: 3.000 m, 1.50 rad
cubic, 2.000 s: 2.000 m, 1.00 rad
cubic, 2.125 s: 2.125 m, 0.98 rad
cubic, 2.250 s: 2.250 m, 1.03 rad
cubic, 2.500 s: 2.500 m, 1.25 rad
cubic, 2.750 s: 2.750 m, 1.47 rad
cubic, 2.875 s: 2.875 m, 1.52 rad
cubic, 3.000 s: 3.000 m, 1.50 rad
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
