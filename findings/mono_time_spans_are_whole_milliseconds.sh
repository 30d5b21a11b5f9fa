#!/bin/sh
# SPDX-License-Identifier: MIT
# Mono 6.8.0.105 (Debian mono-mcs 6.8.0.105+dfsg-3.3+deb12u1): a time span of a sixtieth of a second is
# 17 ms, and half of all floats do not read back what ToString() writes.
#
# Expected: TimeSpan counts in units of 100 ns, so FromSeconds(1 / 60.0) is 16.6667 ms, as in .NET since Core
# 3.0; and a float that is written and parsed is itself, as there.
# Seen: FromSeconds() and FromMilliseconds() round to whole milliseconds. A game that steps by
# FromSeconds(1 / 60.0).TotalSeconds runs 2 % fast, one at 144 frames per second 0.8 % fast, one at 240
# 4 % slow. TimeSpan.FromTicks() keeps them. Of 10000 floats 5574, and of 10000 doubles 9205, are others
# after ToString() and Parse(): it writes 7 and 15 digits. ToString("R") keeps all. So tables that the same
# program writes under Mono and under .NET differ.
# Flinch: its C# binding takes seconds as a number; docs/csharp.md tells of it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=6.8.0.105+dfsg-3.3+deb12u1
for package in mono-mcs mono-runtime-sgen mono-runtime-common libmono-corlib4.5-dll libmono-corlib4.5-cil \
  libmono-system-core4.0-cil libmono-system4.0-cil libmono-system-xml4.0-cil libmono-security4.0-cil \
  libmono-system-configuration4.0-cil libmono-system-security4.0-cil libmono-system-numerics4.0-cil \
  libmono-microsoft-csharp4.0-cil; do
  apt-get -o APT::Sandbox::User=root download -q "$package=$version" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
# The libraries of Mono itself are those of this folder.
sed 's|\$mono_libdir/||g' etc/mono/config >config
MONO_CONFIG=$folder/config
MONO_CFG_DIR=$folder/etc
MONO_PATH=$folder/usr/lib/mono/4.5
LD_LIBRARY_PATH=$folder/usr/lib
export MONO_CONFIG MONO_CFG_DIR MONO_PATH LD_LIBRARY_PATH
cat >spans.cs <<'CS'
using System;
using System.Globalization;

class Spans {
  static void Main() {
    CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
    foreach (int rate in new[] {30, 60, 144, 240})
      Console.WriteLine("1/{0} s: {1} s, by ticks {2:F7} s", rate,
                        TimeSpan.FromSeconds(1.0 / rate).TotalSeconds,
                        TimeSpan.FromTicks(10000000 / rate).TotalSeconds);
    Console.WriteLine("16.7 ms: {0} ms", TimeSpan.FromMilliseconds(16.7).TotalMilliseconds);
    var draw = new Random(1);
    int floats = 0;
    int doubles = 0;
    int exact = 0;
    for (int i = 0; i < 10000; ++i) {
      float single = (float)draw.NextDouble();
      if (float.Parse(single.ToString()) != single) ++floats;
    }
    for (int i = 0; i < 10000; ++i) {
      double number = draw.NextDouble();
      if (double.Parse(number.ToString()) != number) ++doubles;
      if (double.Parse(number.ToString("R")) != number) ++exact;
    }
    Console.WriteLine("of 10000 {0} floats and {1} doubles are others, by R {2}", floats, doubles, exact);
  }
}
CS
usr/bin/mono-sgen usr/lib/mono/4.5/mcs.exe spans.cs
usr/bin/mono-sgen spans.exe | tee seen
cmp -s - seen <<'TEXT' || {
1/30 s: 0.033 s, by ticks 0.0333333 s
1/60 s: 0.017 s, by ticks 0.0166666 s
1/144 s: 0.007 s, by ticks 0.0069444 s
1/240 s: 0.004 s, by ticks 0.0041666 s
16.7 ms: 17 ms
of 10000 5574 floats and 9205 doubles are others, by R 0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
