# SPDX-License-Identifier: MIT
"""The type stubs have what the module has: names, arguments and defaults."""

import ast
import pathlib
import re
import subprocess
import sys
import tempfile

import flinch

try:
    import mypy  # noqa: F401
except ImportError:
    sys.exit(print("skipped: mypy is missing; scripts/setup --python installs it"))

ROOT = pathlib.Path(__file__).resolve().parents[2]
STUB = ROOT / "bindings/python/flinch/_flinch.pyi"
# Classes of pybind11 have its metaclass, and Selector no constructor.
ALLOWED = r"""flinch\._flinch\.[A-Z]\w+
flinch\._flinch\.Selector\.__init__
"""


def arguments_of(doc):
    """The names and defaults of the arguments in a line that pybind11 writes: name(a: int, b: str = '')."""
    listed, depth = [""], 0
    for character in doc[doc.index("(") + 1:]:
        depth += (character in "([{") - (character in ")]}")
        if depth < 0:
            break
        if character == "," and depth == 0:
            listed.append("")
        else:
            listed[-1] += character
    return [re.match(r"\s*(\w+)", argument)[1] + ("=" if " = " in argument else "")
            for argument in listed if argument.strip() != "*"]


def stub_arguments(function):
    given = function.args
    names = [argument.arg for argument in given.args]
    for i in range(1, len(given.defaults) + 1):
        names[-i] += "="
    return names + [a.arg + ("=" if d is not None else "") for a, d in zip(given.kwonlyargs, given.kw_defaults)]


def compared_signatures():
    """stubtest cannot see the arguments of compiled functions; their documentation tells them."""
    for node in ast.parse(STUB.read_text(encoding="utf-8")).body:
        functions = [node] if isinstance(node, ast.FunctionDef) else getattr(node, "body", [])
        for function in functions:
            if not isinstance(function, ast.FunctionDef) or function.decorator_list and not any(
                    getattr(d, "id", "") in ("staticmethod", "overload") for d in function.decorator_list):
                continue
            holder = getattr(flinch, node.name) if isinstance(node, ast.ClassDef) else flinch._flinch
            doc = getattr(holder, function.name).__doc__
            lines = [line for line in doc.splitlines() if re.match(rf"(\d\. )?{function.name}\(", line)]
            told = stub_arguments(function)
            checked = [arguments_of(line) for line in lines if "*args" not in line]
            yield f"{node.name}.{function.name}", "" if told in checked else f"{told}, not one of {checked}"


signatures = list(compared_signatures())
wrong = [f"{name}: {what}" for name, what in signatures if what]
print("\n".join([*wrong, f"{len(signatures)} signatures, {len(wrong)} wrong"]))
assert not wrong and len(signatures) > 40
with tempfile.NamedTemporaryFile("w", suffix=".txt") as allowed:
    allowed.write(ALLOWED)
    allowed.flush()
    subprocess.run([sys.executable, "-m", "mypy.stubtest", "--allowlist", allowed.name, "flinch._flinch"],
                   check=True)
