#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From the kept CSV to what gnuplot draws: one block per curve, the marks of
failed runs, and where each curve's label goes.

    curves.py RESULTS OUT

Work against precision is that of the portable build.  A curve leaves out the
rungs that a cheaper one beats, as all do below the floor of rounding; the CSV
has them.
"""
import csv
import math
import pathlib
import sys

import rungs

RESULTS, OUT = map(pathlib.Path, sys.argv[1:])
CURVES, NS = rungs.curves(RESULTS / "accuracy.csv")
SCENES = ("wobble", "generic", "tumble", "ring", "quarter", "nearflat")
METHODS = ("textbook RK4", "rk4", "rk8", "coin_advance", "symplectic2",
           "symplectic4", "GSL rk8pd", "odeint rkf78", "odeint dopri5",
           "odeint rkf78 fixed", "CVODE Adams", "ODE rim contact",
           "MuJoCo ellipsoid")
LABELS = {"odeint rkf78 fixed": "rkf78 fixed", "odeint rkf78": "rkf78",
          "odeint dopri5": "dopri5", "ODE rim contact": "ODE",
          "MuJoCo ellipsoid": "MuJoCo", "CVODE Adams": "CVODE"}
# The axes, which accuracy.gp draws: decades of cost and of error in a panel,
# and which part of its height a line of text takes.
DECADES = {"ns": (1.7, 8), "slopes": (0, 6)}
ERROR_DECADES = 22
LINE = 0.052

# Points drawn are at least these parts of a panel apart: a line then bends
# within two pixels of where it should, and the marks of failures stay apart.
LINE_GAP = 0.013
MARK_GAP = 0.03

# Lines of style.gpi for the methods of the long runs.
COLOURS = {"rk4": 2, "rk8": 3, "rk8 in tau": 4, "symplectic2": 5,
           "symplectic4": 6}


def rows(name):
    lines = (RESULTS / f"{name}.csv").read_text().splitlines()
    return list(csv.DictReader(l for l in lines if not l.startswith("#")))


def number(text):
    return float(text) if text else math.nan


def thinned(points, gap, decades):
    """The points (error, cost) without those nearer than gap to the last one
    kept; the ends stay."""
    kept = points[:1]
    for error, cost in points[1:-1]:
        across = math.log10(error / kept[-1][0]) / ERROR_DECADES
        up = math.log10(cost / kept[-1][1]) / decades
        if math.hypot(across, up) >= gap:
            kept.append((error, cost))
    return kept + points[1:][-1:]


def block(points):
    return "\n".join(f"{x:g} {y:g}" for x, y in points) or "nan nan"


def spread(labels, low, high):
    """Moves labels (y, text), y in decades, apart, and keeps their order."""
    gap = LINE * (high - low)
    labels = sorted(labels)
    for _ in range(200):
        for i in range(len(labels) - 1):
            close = gap - (labels[i + 1][0] - labels[i][0])
            if close > 1e-9:
                labels[i] = (labels[i][0] - close / 2, *labels[i][1:])
                labels[i + 1] = (labels[i + 1][0] + close / 2,
                                 *labels[i + 1][1:])
        labels = [(min(max(y, low + gap / 2), high - gap / 2), *rest)
                  for y, *rest in labels]
    return labels


def panel(scene, measure):
    low, high = DECADES[measure]
    decades = high - low
    step = NS["portable", scene] if measure == "ns" else 1
    what = "cost" if measure == "ns" else "slopes"
    lines, labels, failures = [], [], []
    for k, method in enumerate(METHODS, 1):
        mine = CURVES.get(("portable", scene, method), [])
        if measure == "slopes" and k > 11:
            mine = []  # an engine has no right-hand side
        good = [r for r in mine if r["status"] == "ok"]
        per_slope = min((r[what] / r["slopes"] for r in good), default=math.nan)
        failed = sorted((1, r["slopes"] * per_slope * step) for r in mine
                        if r["status"] != "ok")
        failures += [(cost, k) for _, cost in thinned(failed, MARK_GAP, decades)]
        line = [(error, cost * step) for error, cost in rungs.front(mine, what)]
        lines.append(block(thinned(line, LINE_GAP, decades)))
        if line:
            error, cost = line[-1]
            labels.append((math.log10(cost), LABELS.get(method, method), k,
                           error, cost))
    stem = OUT / f"{measure}_{scene}"
    stem.with_suffix(".dat").write_text("\n\n\n".join(lines) + "\n")
    stem.with_suffix(".failed").write_text(
        "".join(f"{c:g} {k}\n" for c, k in failures) or "nan 1\n")
    stem.with_suffix(".labels").write_text("".join(
        f'{10 ** y:g} "{text}" {k} {error:g} {cost:g}\n'
        for y, text, k, error, cost in spread(labels, low, high)))


def chart(name, data, low, high, scale=math.log10, back=lambda v: 10 ** v):
    """data: {(method, h): [(t, y), ...]}; labels go to the ends, right.  scale
    and back: from y to the axis, which ends at low and high, and back."""
    blocks, labels = [], []
    for (method, h), points in data.items():
        points = [(t, y) for t, y in points if y > 0]
        blocks.append(block(points))
        if points:
            t, y = points[-1]
            labels.append((scale(y), f"{method}, {h}", COLOURS[method], t, y))
    (OUT / f"{name}.dat").write_text("\n\n\n".join(blocks) + "\n")
    (OUT / f"{name}.labels").write_text("".join(
        f'{back(y):g} "{text}" {k} {t:g} {end:g}\n'
        for y, text, k, t, end in spread(labels, low, high)))


def by_run(data, *columns):
    """The largest of the columns against t, for each method and step."""
    runs = {}
    for r in data:
        runs.setdefault((r["method"], r["h"]), []).append(
            (number(r["t"]), max(number(r[c]) for c in columns)))
    return runs


OUT.mkdir(parents=True, exist_ok=True)
for name in SCENES:
    panel(name, "ns")
    panel(name, "slopes")
drifts = rows("longrun")
chart("energy", by_run(drifts, "energy_rms"), -17, 0)
chart("integrals", by_run(drifts, "KY_rms", "KZ_rms"), -17, 0)
chart("phase", by_run(drifts, "phase_rms"), -15, 5)
chart("damping", by_run(rows("damping"), "swing"), 0, 0.7, float, float)
