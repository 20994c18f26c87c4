#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An include in lib/ may only point down.

Each line below is a floor of the building in docs/design.md, from the ground
up; each group on a line is a column.  A file sees the floors below its own,
and its own column; columns on one floor do not see each other.

    layers.py LIB
"""
import pathlib
import re
import sys

FLOORS = [
    [{"pinned", "precision", "width"}],
    [{"sincos", "sine"}, {"motion", "number"}, {"version"}, {"status"},
     {"pair"}, {"outcome"}],
    [{"params", "state"}, {"frame"}],
    [{"stage"}, {"legendre"}],
    [{"stepper", "change", "carry", "march", "rk4", "dop8", "rk8", "lanes",
      "symplectic", "sundman", "advance"},
     {"energy"}, {"integrals"}, {"reaction"}, {"pose"}, {"rates"},
     {"steady", "steady_at", "steady_near"}],
    [{"run", "step", "batch", "method", "check", "max_dt"}, {"stability"}, {"wobble"},
     {"orbit", "orbit_at", "half", "series"}],
    [{"selftest"}, {"model"},
     {"losses", "lossy", "hold", "extrapolate", "rest", "settle",
      "quasisteady"}],
]
PLACE = {stem: (level, column) for level, floor in enumerate(FLOORS)
         for column, group in enumerate(floor) for stem in group}


def problems(lib):
    files = sorted([*lib.glob("*.[ch]"), *lib.glob("float/*.[ch]"),
                    *lib.glob("real/*.[ch]")])
    stems = {file.stem for file in files}
    yield from (f"{s}: not in the table of layers" for s in stems - set(PLACE))
    yield from (f"{s}: no such file" for s in set(PLACE) - stems)
    for file in files:
        for seen in re.findall(r'#include "(?:real/)?(\w+)\.h"', file.read_text()):
            here, there = PLACE.get(file.stem), PLACE.get(seen)
            if here and there and here != there and here[0] <= there[0]:
                yield f"{file.name} must not see {seen}.h"


found = list(problems(pathlib.Path(sys.argv[1])))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
