#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""make_copyright.py OUTPUT: writes our licence and those of all that becomes part of what is
installed: libraries of headers, and what the pages are built of. Other libraries are linked and bring
their own. Fails where a licence cannot be found."""

import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = ["libeigen3-dev", "libflatbuffers-dev", "libcli11-dev", "nlohmann-json3-dev", "libtomlplusplus-dev",
           "libflann-dev", "libspdlog-dev", "libfmt-dev"]


def licence_of(folder):
    files = sorted(file for file in folder.iterdir() if file.name.upper().startswith(("LICENSE", "LICENCE", "COPYING")))
    if not files:
        sys.exit(f"{folder}: there is no licence")
    return files[0].read_text(encoding="utf-8", errors="replace")


def page_packages():
    """The packages of the pages that are not only needed to build them, if they were fetched."""
    installed = ROOT / "viewer/node_modules"
    if not installed.is_dir():
        return
    lock = json.loads((ROOT / "viewer/package-lock.json").read_text(encoding="utf-8"))
    for path, package in lock["packages"].items():
        if path and not package.get("dev"):
            yield f"{path.removeprefix('node_modules/')} {package['version']}", ROOT / "viewer" / path


def main():
    parts = [("Flinch", (ROOT / "LICENSE").read_text(encoding="utf-8"))]
    for package in HEADERS:
        parts.append((package, pathlib.Path("/usr/share/doc", package, "copyright").read_text(encoding="utf-8")))
    parts += [(name, licence_of(folder)) for name, folder in page_packages()]
    text = "".join(f"{'=' * 78}\n{name}\n{'=' * 78}\n\n{licence.strip()}\n\n" for name, licence in parts)
    pathlib.Path(sys.argv[1]).write_text(text, encoding="utf-8")


main()
