#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An include in lib/ only points down.

FLOORS is the drawing of docs/design.md: the folders of lib/, floor by floor
from the top, each with all that its files may include besides one another.

    layers.py LIB
"""
import os
import pathlib
import re
import sys

FLOORS = [
    {"about": {"motion"}},
    {"float": {"motion", "observe", "real", "step/batch.h"}},
    {"exact": {"motion", "step"}, "real": {"motion", "step"}},
    {"step": {"motion"}, "observe": {"motion"}},
    {"motion": set()},
]
SEES = {room: seen for floor in FLOORS for room, seen in floor.items()}


def includes(lib):
    """{file: the files that it includes}, by their paths below lib."""
    found = {}
    for file in sorted(lib.glob("**/*.[ch]")):
        here = str(file.relative_to(lib))
        found[here] = {
            os.path.normpath(os.path.join(os.path.dirname(here), name))
            for name in re.findall(r'#include "([^"]+)"', file.read_text())}
    return found


def circle(file, seen, path=()):
    """The files from one back to itself, if its includes lead there."""
    if file in path:
        return path[path.index(file):] + (file,)
    return next(filter(None, (circle(to, seen, path + (file,))
                              for to in sorted(seen.get(file, ())))), None)


def problems(lib):
    for k, floor in enumerate(FLOORS):
        below = {room for lower in FLOORS[k + 1:] for room in lower}
        for room, seen in floor.items():
            for up in sorted({s.split("/")[0] for s in seen} - below):
                yield f"{room} is not above {up}"
    seen = includes(lib)
    for file, others in seen.items():
        room = file.split("/")[0]
        if room not in SEES:
            yield f"{file}: {room} is on no floor"
            continue
        for other in sorted(others):
            if other not in seen:
                yield f"{file}: there is no {other}"
            elif not {other, other.split("/")[0]} & (SEES[room] | {room}):
                yield f"{file} must not see {other}"
    round_trip = next(filter(None, (circle(file, seen) for file in seen)), None)
    if round_trip:
        yield "a circle: " + " -> ".join(round_trip)
    print(f"{len(seen)} files, {sum(map(len, seen.values()))} includes")


found = list(problems(pathlib.Path(sys.argv[1])))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
