#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The C sources stay small enough to read: lines per file and per function.

    sizes.py SRC
"""
import json
import pathlib
import statistics
import subprocess
import sys

FILE_LINES = 400  # coin.h, which is the manual, excepted
FUNCTION_LINES = 60
MEDIAN_LINES = 15  # of the functions of lib/
COLUMNS = 80


def functions(files):
    """(file, name, lines) of each function, by universal-ctags."""
    tags = subprocess.run(
        ["ctags", "--output-format=json", "--languages=C", "--langmap=C:.c.h",
         "--kinds-C=f", "--fields=neFN", "-f", "-", *map(str, files)],
        check=True, capture_output=True, text=True).stdout
    for line in tags.splitlines():
        tag = json.loads(line)
        yield (pathlib.Path(tag["path"]), tag["name"],
               tag["end"] - tag["line"] + 1)


def problems(src):
    files = [f for d in ("include", "lib", "tests", "docs/examples")
             for f in sorted((src / d).rglob("*.[ch]"))]
    for file in files:
        lines = file.read_text().splitlines()
        if len(lines) > FILE_LINES and file.name != "coin.h":
            yield f"{file}: {len(lines)} lines, at most {FILE_LINES}"
        for number, line in enumerate(lines, 1):
            if len(line) > COLUMNS:
                yield f"{file}:{number}: {len(line)} columns"
    sizes = list(functions(files))
    for file, name, lines in sizes:
        if lines > FUNCTION_LINES:
            yield f"{file}: {name} has {lines} lines, at most {FUNCTION_LINES}"
    lib = [n for file, _, n in sizes if src / "lib" in file.parents]
    median = statistics.median(lib)
    print(f"{len(lib)} functions in lib/, median {median:g} lines")
    if median > MEDIAN_LINES:
        yield f"lib/: more than {MEDIAN_LINES} lines in the median function"


found = list(problems(pathlib.Path(sys.argv[1])))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
