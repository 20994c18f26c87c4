#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From atlas.csv to what gnuplot fills: for each panel a block per
outcome and one of what carries a warning.

    atlas.py OUT    (reads atlas.csv there)

Equal cells are joined to rectangles, and those of a block to one polygon that
goes from each to the next and back: a renderer leaves no gaps between parts of
one polygon.
"""
import math
import pathlib
import sys

import rungs

OUT = pathlib.Path(sys.argv[1])
OUTCOMES = "RPLGSX"
# First step and steps per decade: bench_atlas's ladders.
TOLERANCES = (-2, 2)
STEPS = {"pass": (0.5, 9)}


def rectangles(columns, wanted):
    """Of the cells that are wanted: columns from, to; rows from, to."""
    whole = []
    for i, cells in enumerate(columns):
        k = 0
        while k < len(cells):
            end = k
            while end < len(cells) and cells[end] in wanted:
                end += 1
            before = next((r for r in whole if r[1] == i and r[2:] == [k, end]),
                          None)
            if end > k and before:
                before[1] = i + 1
            elif end > k:
                whole.append([i, i + 1, k, end])
            k = max(end, k + 1)
    return whole


def polygon(boxes, x, y):
    """The corners of all, along a way that comes back as it went."""
    way = []
    for left, right, top, bottom in boxes:
        way += [(x(a), y(b)) for a, b in ((left, top), (right, top),
                (right, bottom), (left, bottom), (left, top))]
    way += [(x(b[0]), y(b[2])) for b in reversed(boxes)]
    return "\n".join(f"{a:.6g} {b:.6g}" for a, b in way) or "nan nan"


def panel(family, method, lines):
    """x from the places of the scenes, by ratios if they are so."""
    at = [float(l["x"]) for l in lines]
    ratio = abs(at[0] * at[2] - at[1] ** 2) < 1e-2 * at[1] ** 2 and at[0] > 0
    at = [math.log10(v) for v in at] if ratio else at
    step = (at[-1] - at[0]) / (len(at) - 1)
    cells = [l["outcomes"] for l in lines]
    first, by = STEPS.get(family, (0.5, 12))
    if "fixed" not in method and len(cells[0]) == 21:
        first, by = TOLERANCES

    def x(i):
        v = at[0] + (i - 0.5) * step
        return 10 ** v if ratio else v

    def y(k):
        return 10 ** (first - (k - 0.5) / by)

    blocks = [polygon(rectangles(cells, o + o.lower()), x, y)
              for o in OUTCOMES]
    blocks.append(polygon(rectangles(cells, OUTCOMES.lower()), x, y))
    (OUT / f"atlas_{family}_{method.replace(' ', '_')}.dat").write_text(
        "\n\n\n".join(blocks) + "\n")


panels = {}
for line in rungs.read(OUT / "atlas.csv"):
    panels.setdefault((line["family"], line["method"]), []).append(line)
for (family, method), lines in panels.items():
    panel(family, method, lines)
