# SPDX-License-Identifier: MIT
"""notebook_test.py NOTEBOOK FOLDER: runs the notebook's cells in FOLDER and compares what it ends in
with the program's. Environment: FLINCH (the program)."""

import json
import os
import pathlib
import shutil
import subprocess
import sys

try:
    import matplotlib
    import pandas  # noqa: F401
except ImportError as missing:
    sys.exit(print(f"skipped: {missing}; scripts/setup --python installs it"))

notebook, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
os.chdir(folder)
matplotlib.use("Agg")
cells = [cell for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]
         if cell["cell_type"] == "code"]
assert all(not cell["outputs"] for cell in cells), "clear the outputs before committing"
names = {}
for number, cell in enumerate(cells, 1):
    exec(compile("".join(cell["source"]), f"{notebook.name}, code cell {number}", "exec"), names)

figures = names["plt"].get_fignums()
assert len(figures) == 2, f"{len(figures)} figures"
for figure in figures:
    names["plt"].figure(figure).savefig(f"{figure}.png")
done = subprocess.run([os.environ["FLINCH"], "compare", str(names["training_file"]), "--test",
                       str(names["test_file"]), "--models", "svm,knn", "--json"],
                      capture_output=True, text=True, check=True)
rows = {row["name"]: row for row in json.loads(done.stdout)["rows"]}
for model, numbers in names["mine"].items():
    for name, value in numbers.items():
        assert abs(value - rows[model][name]) <= 1e-12 * abs(value), (model, name, value, rows[model])
        print(f"{model} {name} {value:.6g}")
assert len(names["mine"]) == 2
