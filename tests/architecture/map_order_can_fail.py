#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shows that a map which is itself out of order is reported."""

import sys

import check_map
from check_map import OFFLINE, RUN_TIME, Folder

check_map.MAP = {
    "below": Folder(RUN_TIME, ["above"], []),
    "above": Folder(OFFLINE, [], []),
    "game": Folder(RUN_TIME, ["above"], []),
}
expected = ["the map: below/ names above, which is not above it",
            "the map: game/, which games link, uses offline code of above"]
found = list(check_map.check_order())
print("\n".join(found))
sys.exit(0 if found == expected else 1)
