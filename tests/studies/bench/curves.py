#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From the kept CSV to what gnuplot draws: one block per curve, marks, and where
each curve's label goes.

    curves.py RESULTS OUT

Work against precision is that of the portable build.  A curve leaves out the
rungs that a cheaper one beats, as all do below the floor of rounding; the CSV
has them.  Of several methods in one curve the cheapest counts at each error.
"""
import math
import pathlib
import sys

import labels
import rungs

RESULTS, OUT = map(pathlib.Path, sys.argv[1:])
CURVES, NS = rungs.curves(RESULTS / "accuracy.csv")
OURS = ("rk4", "rk8", "coin_advance")
PEERS = ("GSL rk8pd", "odeint rkf78", "odeint dopri5", "odeint rkf78 fixed",
         "CVODE Adams", "heyoka")
FREE = ("sine-free GSL rk8pd", "sine-free odeint rkf78 fixed")
ENGINES = ("ODE rim contact", "MuJoCo ellipsoid")

# What a curve is called, its line of style.gpi, and whose it is.  accuracy.gp
# has a key of the first.
SOLVERS = (("textbook RK4", 1, ("textbook RK4",)), ("rk4", 2, ("rk4",)),
           ("rk8", 3, ("rk8",)), ("coin_advance", 4, ("coin_advance",)),
           ("best other solver", 7, PEERS), ("with our equations", 8, FREE),
           ("orbit", 14, ("orbit",)))
BESIDE_ENGINES = (("textbook RK4", 1, ("textbook RK4",)),
                  ("coin_advance", 4, ("coin_advance",)),
                  ("ODE", 12, ENGINES[:1]), ("MuJoCo", 13, ENGINES[1:]))
SECOND = (("rollcoin", 4, OURS), ("a textbook's RK4", 1, ("textbook RK4",)),
          ("the best other solver", 7, PEERS),
          ("the better of two engines", 12, ENGINES))
CALLS = {"textbook RK4": 1, "coin_step": 2, "one step of RK8": 3,
         "coin_advance 1e-6": 4, "coin_orbit_at": 14, "coin_move 1e-6": 17,
         "coin_settle 1e-6": 18}

# The panels of accuracy.gp: pixels, and (from, to) of each axis.
PANELS = {"scene": labels.Panel(400, 330, (1e-15, 1), (20, 1e7), 12),
          "second": labels.Panel(690, 440, (1e-14, 1), (1e3, 1e9), 13),
          "frame_ns": labels.Panel(310, 330, (50, 1200), (40, 3000), 12),
          "frame_error": labels.Panel(310, 330, (50, 1200), (1e-15, 0.1), 12)}
QUARTER = 0.0351704 # its natural unit of time [s]

# Points drawn are at least these pixels apart: a line then bends within two
# pixels of where it should.
LINE_GAP = 5

# A line of text, in parts of the height of the long runs' charts.
LINE = 0.052

# Lines of style.gpi for the methods of the long runs.
COLOURS = {"rk4": 2, "rk8": 3, "order 14 in tau": 4, "symplectic2": 5,
           "symplectic4": 6}


def number(text):
    return float(text) if text else math.nan


def rows(name):
    return rungs.read(RESULTS / f"{name}.csv")


def thinned(points, gap, panel):
    """The points without those nearer than gap to the last one kept; the ends
    stay."""
    kept = points[:1]
    for point in points[1:-1]:
        if math.dist(panel.pixel(*point), panel.pixel(*kept[-1])) >= gap:
            kept.append(point)
    return kept + points[1:][-1:]


def cheapest(scene, methods):
    """(error, cost) of the front of several methods, without the rungs that
    gain next to nothing."""
    fronts = [rungs.front(CURVES.get(("portable", scene, m), []))
              for m in methods]
    ends = [math.log10(error) for front in fronts for error, _ in front]
    line = fronts[0]
    if len(methods) > 1 and ends:
        grid = [10**(k/8) for k in range(math.floor(8*max(ends)),
                                         math.floor(8*min(ends)) - 1, -1)]
        costs = [[rungs.cost_at(f, e) for f in fronts] for e in grid]
        line = [(e, min(filter(None, c))) for e, c in zip(grid, costs) if any(c)]
    kept = line[:1]
    for error, cost in line[1:]:
        if error < 0.8 * kept[-1][0]:
            kept.append((error, cost))
    return kept


def block(points):
    return "\n".join(f"{x:g} {y:g}" for x, y in points) or "nan nan"


def write(name, panel, lines, style, marks=(), labelled=True):
    """What is drawn in a panel: curves {name: points} in their order, marks
    (name, point, style), and labels with leaders; style by name."""
    stem = OUT / name
    (OUT / f"{name}.dat").write_text("\n\n\n".join(
        block(thinned(line, LINE_GAP, panel)) for line in lines.values()) + "\n")
    (OUT / f"{name}.styles").write_text(
        " ".join(str(style[n]) for n in lines) + "\n")
    (OUT / f"{name}.marks").write_text("".join(
        f"{x:g} {y:g} {k}\n" for _, (x, y), k in marks) or "nan nan 1\n")
    named = lines | {n: [point] for n, point, _ in marks} if labelled else {}
    style = style | {n: k for n, _, k in marks}
    places = labels.place(panel, named, math.inf)
    missing = [n for n, line in named.items() if line and n not in places]
    if missing:
        print(f"{name}: no room for", *missing, file=sys.stderr)
    stem.with_suffix(".labels").write_text("".join(
        f'{x:g} {y:g} "{n}" {style[n]}\n'
        for n, (x, y, _) in places.items()) or '1 1 " " 1\n')
    stem.with_suffix(".leaders").write_text("".join(
        f"{a:g} {b:g}\n{c:g} {d:g}\n\n"
        for a, b, c, d in (l for *_, l in places.values() if l)) or "nan nan\n")


def within(points, panel):
    """Those inside a panel."""
    return [p for p in points
            if all(0 <= v <= most for v, most in zip(
                panel.pixel(*p), (panel.width, panel.height)))]


def solvers(name, scene, shown, panel, scale, marks=(), labelled=True):
    lines = {n: within([(e, c * scale) for e, c in cheapest(scene, methods)],
                       panel) for n, _, methods in shown}
    write(name, panel, lines, {n: k for n, k, _ in shown}, marks, labelled)


def python():
    """A second of the quarter from Python."""
    return [(r["method"], (number(r["error"]), number(r["ns"])), style)
            for r, style in zip(rows("python"), (7, 4))]


def frame_loop():
    """One call per frame: what it takes, and the error after a second, against
    the frame rate."""
    for column in ("ns", "error"):
        curves = {name: [(number(r["rate"]), number(r[column]))
                         for r in rows("frames") if r["call"] == name]
                  for name in CALLS}
        if column == "error":  # coin_step's errors are the textbook's
            del curves["textbook RK4"]
        write(f"frame_{column}", PANELS[f"frame_{column}"], curves, CALLS)


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
for name in ("wobble", "generic", "tumble", "ring", "quarter", "nearflat"):
    solvers(f"ns_{name}", name, SOLVERS, PANELS["scene"], NS["portable", name],
            labelled=False)
solvers("ns_engines", "quarter", BESIDE_ENGINES, PANELS["scene"],
        NS["portable", "quarter"])
solvers("second", "quarter", SECOND, PANELS["second"],
        NS["portable", "quarter"] / QUARTER, python())
frame_loop()
drifts = rows("longrun")
chart("energy", by_run(drifts, "energy_rms"), -17, 0)
chart("integrals", by_run(drifts, "KY_rms", "KZ_rms"), -17, 0)
chart("phase", by_run(drifts, "phase_rms"), -15, 5)
chart("damping", by_run(rows("damping"), "swing"), 0, 0.7, float, float)
