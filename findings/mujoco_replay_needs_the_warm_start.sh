#!/bin/sh
# SPDX-License-Identifier: MIT
# MuJoCo 2.2.2 (Debian libmujoco-dev 2.2.2-3): a run that is continued from its time, positions and
# velocities ends elsewhere.
#
# Expected: the state of a mechanical system without actuators is its time, qpos and qvel. Set those
# in a fresh mjData, and mj_step goes on with the same bits, since MuJoCo is deterministic.
# Seen: the solver starts from the accelerations of the step before, qacc_warmstart, and stops at a
# tolerance, so where it stops depends on them. Two boxes that fall on each other, continued for
# 200 steps from ten moments, end with other bits from half of them or more by each of the three
# solvers. Copying qacc_warmstart too makes all equal. So a keyframe, which has no such field, does not
# replay a run exactly.
# Flinch: looks ahead from whole copies of its solver's state.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libmujoco-dev libmujoco2.2.2; do
  apt-get -o APT::Sandbox::User=root download -q "$package=2.2.2-3" >/dev/null
done
for package in libccd2 liblodepng0 libqhull-r8.0 libtinyxml2-9; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
LD_LIBRARY_PATH=$(dirname "$(realpath "$(find . -name 'libmujoco.so' | head -n 1)")")
export LD_LIBRARY_PATH
cat >boxes.xml <<'XML'
<mujoco>
  <worldbody>
    <geom type="plane" size="5 5 1"/>
    <body pos="0 0 1"><freejoint/><geom type="box" size=".1 .3 .5"/></body>
    <body pos=".1 .1 2"><freejoint/><geom type="box" size=".1 .3 .5" euler="20 30 0"/></body>
  </worldbody>
</mujoco>
XML
cat >replay.c <<'C'
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <string.h>

static void step(const mjModel *model, mjData *data, int count) {
  while (count-- > 0) mj_step(model, data);
}
int main(void) {
  char error[200] = "";
  mjModel *const model = mj_loadXML("boxes.xml", NULL, error, sizeof error);
  if (!model) return puts(error), 1;
  const size_t positions = sizeof(mjtNum) * (size_t)model->nq;
  const size_t velocities = sizeof(mjtNum) * (size_t)model->nv;
  const char *const names[] = {"PGS", "CG", "Newton"};
  for (int solver = mjSOL_PGS; solver <= mjSOL_NEWTON; ++solver) {
    model->opt.solver = solver;
    int differ[2] = {0, 0};
    for (int moment = 200; moment < 700; moment += 50) {
      mjData *const run = mj_makeData(model);
      step(model, run, moment);
      for (int warm = 0; warm < 2; ++warm) {
        mjData *const original = mj_copyData(NULL, model, run);
        mjData *const replay = mj_makeData(model);
        replay->time = run->time;
        memcpy(replay->qpos, run->qpos, positions);
        memcpy(replay->qvel, run->qvel, velocities);
        if (warm) memcpy(replay->qacc_warmstart, run->qacc_warmstart, velocities);
        step(model, original, 200);
        step(model, replay, 200);
        differ[warm] += memcmp(original->qpos, replay->qpos, positions) != 0;
        mj_deleteData(original);
        mj_deleteData(replay);
      }
      mj_deleteData(run);
    }
    printf("%s: %d of 10 replays differ, %d with qacc_warmstart\n", names[solver], differ[0],
           differ[1]);
  }
  mj_deleteModel(model);
  return 0;
}
C
gcc -I usr/include replay.c -o replay -L "$LD_LIBRARY_PATH" -lmujoco \
  -Wl,--unresolved-symbols=ignore-in-shared-libs
./replay | tee seen
[ "$(grep -c 'replays differ, 0 with' seen)" = 3 ] && ! grep -q ': 0 of 10' seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
