#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The lists by which floats and vectors get names of their own hold no name
that is not used, and that of floats is complete: no object of floats defines or
calls a function of doubles.

    names.py SRC CC OUT
"""
import pathlib
import re
import subprocess
import sys


def listed(file):
    """The names that a list renames, as they are after that."""
    text = file.read_text()
    pairs = re.findall(r"^#define (coin_\w+) (?:(coinf_\w+)|COIN_PRIV_NAME)",
                       text, re.M)
    return {new or old.replace("coin_priv_", "") for old, new in pairs}


def words(src, compiler, pattern):
    """The identifiers that the compiler sees in files of lib/."""
    found = set()
    for file in sorted(src.glob(pattern)):
        text = subprocess.run([compiler, "-E", "-P", f"-I{src}/include", file],
                              capture_output=True, text=True, check=True).stdout
        found |= set(re.findall(r"\w+", text))
    return found


def of_doubles(out):
    """The names of doubles among the global symbols of the objects of floats."""
    objects = sorted(out.glob("objects/coinf_*.o"))
    text = subprocess.run(["nm", "-g", "-j", *objects],
                          capture_output=True, text=True, check=True).stdout
    assert "coinf_step" in text.split()
    return set(re.findall(r"^coin_\w+$", text, re.M))


def main(src, compiler, out):
    floats = words(src, compiler, "lib/float/*.c")
    for name in sorted(of_doubles(out)):
        yield f"lib/float/floats.h lacks {name}"
    for name in sorted(listed(src / "lib/float/floats.h") - floats):
        yield f"lib/float/floats.h: no float uses {name}"
    vectors = words(src, compiler, "lib/step/lanes.c")
    for name in sorted(listed(src / "lib/motion/vector_names.h")):
        if not {f"coin_lanes_{name}", f"coin_pair_{name}"} & vectors:
            yield f"lib/motion/vector_names.h: no vector uses {name}"


if __name__ == "__main__":
    src, compiler, out = sys.argv[1:]
    errors = list(main(pathlib.Path(src), compiler, pathlib.Path(out)))
    print(*errors, sep="\n", end="\n" if errors else "")
    sys.exit(bool(errors))
