#!/bin/sh
# SPDX-License-Identifier: MIT
# csvkit 1.0.7 (Debian csvkit 1.0.7-1): a column of 0 and 1 becomes True and False, a clip called "sat" the
# sixth of January of the year 1, and a clip called 3d three days.
#
# Expected: csvsort orders the rows and leaves their values as they are, and csvstat gives the mean of a
# column of hits, which is their rate.
# Seen: each column gets the first type that all of its values fit: truth before number, then time spans,
# dates, text. Hits of 0 and 1 are written as True and False and have no mean, until a row has a 2. Clips
# whose names all read as weekdays, or as spans, become these. csvstat prints a pain of 1e-7
# as 0. csvsort -I keeps the values; csvstat has no such switch.
# Flinch: exports tables with columns of 0 and 1. Who orders one by csvsort passes -I, with which values
# stay as they are.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in csvkit=1.0.7-1 python3-csvkit=1.0.7-1 python3-agate python3-agatedbf python3-agateexcel \
  python3-agatesql python3-babel python-babel-localedata python3-isodate python3-leather \
  python3-parsedatetime python3-pytimeparse python3-six python3-slugify python3-text-unidecode \
  python3-sqlalchemy python3-greenlet python3-dbfread python3-openpyxl python3-olefile python3-xlrd \
  python3-tz; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
PYTHONPATH=$PWD/usr/lib/python3/dist-packages
export PYTHONPATH
printf '%s\n' clip,hit,pain sat,1,1e-7 mon,0,0.25 >weekdays.csv
printf '%s\n' clip,hit,pain 3d,1,1e-7 2d,2,0.25 >spans.csv
for table in weekdays spans; do
  echo "$table:"
  /usr/bin/python3 usr/bin/csvsort -c pain "$table.csv"
  /usr/bin/python3 usr/bin/csvstat -c hit --mean "$table.csv" 2>&1
  /usr/bin/python3 usr/bin/csvstat -c pain --min "$table.csv"
done | tee seen
cmp -s - seen <<'TEXT' || {
weekdays:
clip,hit,pain
0001-01-06,True,1E-7
0001-01-08,False,0.25
None
0
spans:
clip,hit,pain
"3 days, 0:00:00",1,1E-7
"2 days, 0:00:00",2,0.25
1.5
0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
