#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Each equation has one home: one function of lib/ computes it.

A statement that computes an equation of docs/physics.md ends with its number,
/* (14) */; of a function that does nothing else, the comment above it does.
/* from (14) */ is a consequence: solved for another variable, or a part.  A
function that writes an equation in another form stands below, with the reason
and the test that holds its answers against another route.

    homes.py SRC
"""
import pathlib
import re
import sys

from functions import functions

OTHER_FORMS = {
    "equations.h coin_priv_drift_slopes_of": ("test_drift",
        "a drift holds wX, by which (15) is divided"),
    "series.c lean_power": ("test_series",
        "one power of a power series of the motion"),
    "series.c coin_priv_series_expand_path": ("test_series",
        "the same, for the path"),
    "coinf_step.c coinf_priv_slope_at": ("test_float_run",
        "has the remainder of phi' give that of psi'"),
    "symplectic.c modified_kick": ("test_symplectic",
        "(50) has two kicks"),
}


def tags(file):
    """(function, equation) for each number at the end of a statement, or of the
    comment above a function."""
    text = file.read_text()
    lines = text.split("\n")
    for name, first, last in functions(text):
        above = re.search(r"\((\d+)\)\.? \*/$", lines[first - 2])
        if above:
            yield name, int(above[1])
        for line in lines[first - 1:last]:
            tag = re.search(r"\S.*/\*((?:(?!from)[^*])*)\*/$", line)
            for number in re.findall(r"\((\d+)\)", tag[1] if tag else ""):
                yield name, int(number)


def homes(src):
    """{equation: the functions that compute it}"""
    found = {}
    for file in sorted(src.glob("lib/*/*.[ch]")):
        for name, equation in tags(file):
            found.setdefault(equation, set()).add(f"{file.name} {name}")
    return found


def problems(src):
    found = homes(src)
    physics = (src / "docs/physics.md").read_text()
    coded = {int(n) for n in re.findall(r"\*\*\((\d+)\)\*\* \[code\]", physics)}
    for equation in sorted(coded - set(found)):
        yield f"({equation}) is marked as code, and no function computes it"
    for equation, functions_of in sorted(found.items()):
        at_home = functions_of - set(OTHER_FORMS)
        if len(functions_of) > 1 and len(at_home) != 1:
            yield f"({equation}) is computed by {', '.join(sorted(at_home))}"
    shared = set().union(*(f for f in found.values() if len(f) > 1))
    for function in sorted(set(OTHER_FORMS) - shared):
        yield f"{function}: computes no equation of another function"
    for test in sorted({test for test, _ in OTHER_FORMS.values()}):
        if not (src / f"tests/{test}.c").exists():
            yield f"there is no tests/{test}.c"
    print(f"{len(found)} equations, {len(OTHER_FORMS)} functions with a form of "
          "their own")


if __name__ == "__main__":
    errors = list(problems(pathlib.Path(sys.argv[1])))
    print(*errors, sep="\n", end="\n" if errors else "")
    sys.exit(bool(errors))
