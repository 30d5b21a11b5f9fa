#!/bin/sh
# SPDX-License-Identifier: MIT
# Miller 6.6.0 (Debian miller 6.6.0-2+b3) and GNU datamash 1.7 (Debian datamash 1.7-2): the median of the same
# four numbers is 3 or 2.5.
#
# Expected: of an even count the median is halfway between the two in the middle, in both tools, as in R,
# NumPy and spreadsheets.
# Seen: mlr stats1 -a median, and p25, p75 and so on, give a value that is there: of 1 to 4 the median is 3,
# and p75 is 4, as p90 is. Of two takes the "median" is the worse one. With -i it interpolates, and all
# agree with datamash. Nothing in the names of the columns tells which it was.
# Flinch: its intervals interpolate. Who takes medians of its tables by mlr passes -i.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in miller=6.6.0-2+b3 datamash=1.7-2; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
printf '%s\n' pain 1 2 3 4 >pain.csv
{
  usr/bin/mlr --icsv --oxtab stats1 -a median,p25,p75,p90 -f pain pain.csv | tr -s ' \n' ' '
  echo
  usr/bin/mlr --icsv --oxtab stats1 -i -a median,p25,p75,p90 -f pain pain.csv | tr -s ' \n' ' '
  echo
  usr/bin/datamash --header-in median 1 q1 1 q3 1 perc:90 1 <pain.csv
} | sed 's/ $//' | tee seen
cmp -s - seen <<'TEXT' || {
pain_median 3 pain_p25 2 pain_p75 4 pain_p90 4
pain_median 2.5 pain_p25 1.75 pain_p75 3.25 pain_p90 3.7
2.5	1.75	3.25	3.7
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
