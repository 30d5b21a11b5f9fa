# SPDX-License-Identifier: MIT
"""Lets pip build the Python package by CMake (docs/python.md). The environment variable FLINCH_BUILD
names a configured build folder to use instead of build/python."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
BUILD = ROOT / "build/python"


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        build = os.environ.get("FLINCH_BUILD")
        if build is None:
            build = BUILD
            subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                            "-DFLINCH_BUILD_PYTHON=ON", "-DFLINCH_BUILD_TESTS=OFF",
                            f"-DFLINCH_PYTHON={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "flinch_python"], check=True)
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(Path(build, "bindings/python/package/flinch", target.name), target)


BUILD.mkdir(parents=True, exist_ok=True)
setup(
    version=re.search(r"project\(flinch VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1],
    ext_modules=[Extension("flinch._flinch", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": "build/python/setuptools"}, "egg_info": {"egg_base": "build/python"}},
)
