#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An include in lib/ only points down, and docs/design.md draws lib/ as it is.

No includes lead in a circle, where NAME.c, NAME.h and NAME.t.h count as one.

FLOORS is its drawing: the folders of lib/, floor by floor from the top, each
with all that its files may include besides one another.

    layers.py LIB
"""
import fnmatch
import os
import pathlib
import re
import sys

FLOORS = [
    {"about": {"motion"}},
    {"float": {"motion", "observe"}},
    {"exact": {"motion", "step"}, "real": {"air", "motion", "step"}},
    {"air": {"motion"}, "step": {"motion"}, "observe": {"motion"}},
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


def stem(file):
    """The path of a file without its ending."""
    return re.sub(r"(\.t)?\.[ch]$", "", file)


def by_stem(seen):
    """The includes of files as those of their stems in one another."""
    found = {}
    for file, others in seen.items():
        found.setdefault(stem(file), set()).update(
            stem(other) for other in others if stem(other) != stem(file))
    return found


def circle(unit, seen, path=()):
    """The stems from one back to itself, if its includes lead there."""
    if unit in path:
        return path[path.index(unit):] + (unit,)
    return next(filter(None, (circle(to, seen, path + (unit,))
                              for to in sorted(seen.get(unit, ())))), None)


def drawn(page):
    """{room: the names of its files without their endings}, as drawn."""
    rooms, columns = {}, []
    for line in re.findall(r"^ +\d? *([|+].*[|+])$", page, re.M):
        if line[0] == "+":
            columns = []
            continue
        cells = line.strip("|").split("|")
        columns = columns or [[] for _ in cells]
        for cell, column in zip(cells, columns):
            words = cell.split()
            if words and words[0].endswith("/"):
                rooms[words.pop(0)[:-1]] = column
            column += words
    return rooms


def unlike(lib, page):
    """Where the drawing and the paths of the page differ from lib/."""
    rooms = drawn(page)
    for room in sorted(SEES):
        names = {stem(f.name) for f in (lib / room).iterdir()}
        for name in sorted(names):
            if not any(fnmatch.fnmatch(name, d) for d in rooms.get(room, ())):
                yield f"docs/design.md does not draw {room}/{name}"
        for name in rooms.get(room, ()):
            if not fnmatch.filter(names, name):
                yield f"docs/design.md draws {room}/{name}: there is none"
    for path in sorted(set(re.findall(r"`(\w+/[\w.]+\.[ch])`", page))):
        if path.split("/")[0] in SEES and not (lib / path).exists():
            yield f"docs/design.md: there is no {path}"


def problems(lib):
    yield from unlike(lib, (lib / "../docs/design.md").read_text())
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
    units = by_stem(seen)
    round_trip = next(filter(None, (circle(unit, units) for unit in units)), None)
    if round_trip:
        yield "a circle: " + " -> ".join(round_trip)
    print(f"{len(seen)} files, {sum(map(len, seen.values()))} includes")


found = list(problems(pathlib.Path(sys.argv[1])))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
