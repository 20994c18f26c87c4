#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Each equation has one home: one function of lib/ computes it.

A statement that computes an equation of docs/physics.md ends with its number,
/* (14) */; of a function that does nothing else, the comment above it does.  A
function that writes an equation in another form stands below, with the test
that holds its answers against another route.

    homes.py SRC
"""
import pathlib
import re
import sys

from functions import functions

OTHER_FORMS = {
    "equations.h drift_slopes_of": "test_drift",
    "equations.t.h path_rates": "test_run",
    "equations.t.h sundman_pose_slopes": "test_sundman",
    "extrapolation.c add_slope": "test_extrapolation",
    "orbit.c conditioning_of": "test_orbit",
    "orbit.c is_steady": "test_orbit",
    "orbit.c set_steady": "test_orbit",
    "orbit.h coin_priv_spin_rates": "test_orbit_at",
    "orbit_at.c set_place": "test_orbit_at",
    "pose.c angles_of": "test_pose",
    "pose.c coin_angular_velocity": "test_pose",
    "pose.c coin_state_from_motion": "test_pose",
    "series.c coin_priv_series_expand_path": "test_series",
    "series.c lean_power": "test_series",
    "stability.c coin_priv_stability": "test_stability",
    "steady_at.c coin_priv_steady_rates": "test_steady_at",
    "step.h coinf_priv_left_out": "test_float_run",
    "step.h coinf_priv_slope_at": "test_float_run",
    "symplectic.c drift": "test_symplectic",
    "symplectic.c modified_kick": "test_symplectic",
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
            tag = re.search(r"\S.*/\*([^*]*)\*/$", line)
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
    for test in sorted(set(OTHER_FORMS.values())):
        if not (src / f"tests/{test}.c").exists():
            yield f"there is no tests/{test}.c"
    print(f"{len(found)} equations, {len(OTHER_FORMS)} functions with a form of "
          "their own")


if __name__ == "__main__":
    errors = list(problems(pathlib.Path(sys.argv[1])))
    print(*errors, sep="\n", end="\n" if errors else "")
    sys.exit(bool(errors))
