#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_reference.py FOLDER HEADER...: makes the reference of these headers into FOLDER. Fails for a
warning of Doxygen and for a function or struct that it does not describe. Run it where the headers'
paths start."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml


def text_of(element):
    return "".join(part.strip() for part in element.itertext()) if element is not None else ""


def described(definition):
    return bool(text_of(definition.find("briefdescription")) + text_of(definition.find("detaileddescription")))


def declared_functions(header):
    """The functions of the C interface, whose comments Doxygen sees through docs/doxygen_filter."""
    return set(re.findall(r"^FLINCH_API [^(]*?(flinch_\w+)\(", pathlib.Path(header).read_text(), re.MULTILINE))


def main():
    folder, *headers = sys.argv[1:]
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    subprocess.run(["doxygen", "docs/Doxyfile"], check=True,
                   env={**os.environ, "FLINCH_REFERENCE": folder, "FLINCH_HEADERS": " ".join(headers)})
    functions, types, silent = set(), set(), []
    for file in pathlib.Path(folder, "xml").glob("*.xml"):
        for compound in xml.parse(file).getroot().findall("compounddef"):
            if compound.get("kind") in ("struct", "class") and compound.get("prot") == "public":
                types.add(compound.findtext("compoundname"))
                if not described(compound):
                    silent.append(compound.findtext("compoundname"))
            if compound.get("kind") in ("file", "namespace"):
                for function in compound.iter("memberdef"):
                    if function.get("kind") == "function":
                        functions.add(function.findtext("name"))
                        if not described(function) and "operator" not in function.findtext("name"):
                            silent.append(function.findtext("name"))
    wanted = set().union(*map(declared_functions, headers))
    silent += sorted(wanted - functions)
    pages = list(pathlib.Path(folder, "html").glob("*_8h.html"))
    if len(pages) != len(headers):
        silent.append(f"{len(headers) - len(pages)} headers")
    print(f"{len(pages)} headers, {len(functions)} functions, {len(wanted)} of them C, {len(types)} types; "
          f"not described: {', '.join(sorted(set(silent))) or 'none'}")
    sys.exit(1 if silent or len(wanted) < 40 else 0)


main()
