# SPDX-License-Identifier: MIT
"""pip_test.py CHECKOUT FOLDER: `pip install` of the checkout, without network, into FOLDER gives a
package that works alone. Environment: FLINCH_BUILD (a build folder to take the compiled part from),
SELECTOR."""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

missing = [name for name in ("pip", "setuptools", "wheel") if importlib.util.find_spec(name) is None]
if missing:
    sys.exit(print(f"skipped: there is no {', '.join(missing)}; scripts/setup --python installs it"))

checkout, folder = sys.argv[1:]
shutil.rmtree(folder, ignore_errors=True)
environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation",
                "--no-deps", "--target", folder, checkout], check=True, env=environment)
made = {path.name for path in pathlib.Path(folder, "flinch").iterdir()}
assert {"__init__.py", "_flinch.pyi", "frames.py", "py.typed"} <= made, made
done = subprocess.run([sys.executable, pathlib.Path(checkout, "examples/throw.py"), os.environ["SELECTOR"]],
                      check=True, env={**environment, "PYTHONPATH": folder}, capture_output=True, text=True)
assert done.stdout.startswith("ok "), done.stdout
where = subprocess.run([sys.executable, "-c", "import flinch; print(flinch.__file__)"], check=True,
                       env={**environment, "PYTHONPATH": folder}, capture_output=True, text=True).stdout
assert where.startswith(folder), where
