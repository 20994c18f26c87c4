#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The C sources stay easy to read: lines per function, columns per line.

    sizes.py SRC
"""
import pathlib
import statistics
import sys

from functions import functions

FUNCTION_LINES = 60
LIB_FUNCTION_LINES = 45
LIB_MEDIAN_LINES = 12
COLUMNS = 80


def problems(src):
    files = [f for d in ("include", "lib", "tests", "docs/examples", "docs/page")
             for f in sorted((src / d).rglob("*.[ch]"))]
    lib = []
    for file in files:
        text = file.read_text()
        for number, line in enumerate(text.splitlines(), 1):
            if len(line) > COLUMNS:
                yield f"{file}:{number}: {len(line)} columns"
        in_lib = src / "lib" in file.parents
        most = LIB_FUNCTION_LINES if in_lib else FUNCTION_LINES
        for name, first, last in functions(text):
            if last - first + 1 > most:
                yield (f"{file}: {name} has {last - first + 1} lines, "
                       f"at most {most}")
            if in_lib:
                lib.append(last - first + 1)
    median = statistics.median(lib)
    print(f"{len(lib)} functions in lib/, median {median:g} lines")
    if median > LIB_MEDIAN_LINES:
        yield f"lib/: more than {LIB_MEDIAN_LINES} lines in the median function"


found = list(problems(pathlib.Path(sys.argv[1])))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
