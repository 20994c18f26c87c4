#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From the kept CSV to what gnuplot draws: one block per curve, the marks of
failed runs, and where each curve's label goes.

    curves.py RESULTS OUT

Work against precision is that of the portable build.  A curve leaves out the
rungs that a cheaper one beats, as all do below the floor of rounding; the CSV
has them.  Of several methods in one curve the cheapest counts at each error.
"""
import csv
import math
import pathlib
import sys

import labels
import rungs

RESULTS, OUT = map(pathlib.Path, sys.argv[1:])
CURVES, NS = rungs.curves(RESULTS / "accuracy.csv")
SCENES = ("wobble", "generic", "tumble", "ring", "quarter", "nearflat")
PEERS = ("GSL rk8pd", "odeint rkf78", "odeint dopri5", "odeint rkf78 fixed",
         "CVODE Adams")
FREE = ("sine-free GSL rk8pd", "sine-free odeint rkf78 fixed")

# What a curve is called, its line of style.gpi, and whose it is.
TIMES = (("textbook RK4", 1, ("textbook RK4",)), ("rk4", 2, ("rk4",)),
         ("rk8", 3, ("rk8",)), ("coin_advance", 4, ("coin_advance",)),
         ("floats", 15, ("rk4 of floats",)),
         ("best peer", 7, PEERS), ("our equations", 8, FREE),
         ("ODE, MuJoCo", 12, ("ODE rim contact", "MuJoCo ellipsoid")),
         ("heyoka", 16, ("heyoka",)), ("orbit", 14, ("orbit",)))
SLOPES = (("RK4", 1, ("textbook RK4",)), ("rk8", 3, ("rk8",)),
          ("coin_advance", 4, ("coin_advance",)),
          *((m.removeprefix("odeint ").removeprefix("GSL "), 7 + k, (m,))
            for k, m in enumerate(PEERS)))

# The axes, which accuracy.gp draws: (from, to) of error and of cost, and the
# pixels of a panel.
ERRORS = 1e-16, 1e4
COSTS = {"ns": (20, 1e8), "slopes": (2, 1e6)}
FAILED_FROM, FAILED = 12, 300 # the band of failed runs, and its middle
PANEL = 335, 312
SECOND = 1e3, 1e9, 690, 440 # of the README's picture
FRAMES = {"ns": (40, 700), "error": (1e-15, 0.1)}
QUARTER = 0.0351704 # its natural unit of time [s]

# Points drawn are at least these pixels apart: a line then bends within two
# pixels of where it should, and the marks of failures stay apart.
LINE_GAP = 5
MARK_GAP = 9

# A line of text, in parts of the height of the long runs' charts.
LINE = 0.052

# Lines of style.gpi for the methods of the long runs.
COLOURS = {"rk4": 2, "rk8": 3, "order 14 in tau": 4, "symplectic2": 5,
           "symplectic4": 6}


def rows(name):
    lines = (RESULTS / f"{name}.csv").read_text().splitlines()
    return list(csv.DictReader(l for l in lines if not l.startswith("#")))


def number(text):
    return float(text) if text else math.nan


def thinned(points, gap, panel):
    """The points without those nearer than gap to the last one kept; the ends
    stay."""
    kept = points[:1]
    for point in points[1:-1]:
        if math.dist(panel.pixel(*point), panel.pixel(*kept[-1])) >= gap:
            kept.append(point)
    return kept + points[1:][-1:]


def cheapest(scene, methods, what):
    """(error, cost) of the front of several methods, without the rungs that
    gain next to nothing."""
    fronts = [rungs.front(CURVES.get(("portable", scene, m), []), what)
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


def failures(scene, shown, what, scale, panel):
    """(cost, style) of failed runs: their steps at the cost of others."""
    found = []
    for _, style, methods in shown:
        for m in methods:
            mine = CURVES.get(("portable", scene, m), [])
            each = min((r[what] / r["slopes"] for r in mine
                        if r["status"] == "ok" and r["slopes"]),
                       default=math.nan)
            failed = sorted((FAILED, r["slopes"] * each * scale) for r in mine
                            if r["status"] != "ok")
            found += [(cost, style)
                      for _, cost in thinned(failed, MARK_GAP, panel)]
    return found


def write_labels(stem, of, named, style, end=math.inf):
    """Labels and, in a file of their own, leaders; style by name."""
    places = labels.place(of, named, end)
    missing = [n for n, line in named.items() if line and n not in places]
    if missing:
        print(f"{stem.name}: no room for", *missing, file=sys.stderr)
    stem.with_suffix(".labels").write_text("".join(
        f'{x:g} {y:g} "{name.partition(chr(9))[0]}" {style[name]}\n'
        for name, (x, y, _) in places.items()) or 'nan nan "" 1\n')
    stem.with_suffix(".leaders").write_text("".join(
        f"{a:g} {b:g}\n{c:g} {d:g}\n\n"
        for a, b, c, d in (l for *_, l in places.values() if l)) or "nan nan\n")


def panel(stem, scene, shown, what, scale, of, marks=()):
    """What is drawn in a panel: blocks in the order shown, labels, failures;
    marks are points (x, y) with a name, of a style."""
    lines = {name: [(e, c * scale) for e, c in cheapest(scene, methods, what)]
             for name, _, methods in shown}
    stem.with_suffix(".dat").write_text("\n\n\n".join(
        block(thinned(line, LINE_GAP, of)) for line in lines.values()) + "\n")
    named = {f"{name}\t{k}": [point] for k, (name, point, _) in enumerate(marks)}
    style = {name: k for name, k, _ in shown} | {
        f"{name}\t{k}": s for k, (name, _, s) in enumerate(marks)}
    write_labels(stem, of, lines | named, style, FAILED_FROM)
    failed = failures(scene, shown, what, scale, of)
    stem.with_suffix(".failed").write_text(
        "".join(f"{c:g} {k}\n" for c, k in failed) or "nan 1\n")
    stem.with_suffix(".marks").write_text("".join(
        f"{x:g} {y:g} {k}\n" for _, (x, y), k in marks) or "nan nan 1\n")


def rates():
    """Where frame rates lie on the curves of fixed steps: the error of a frame
    loop, and its steps at the cost of a run's."""
    ns = {r["method"]: number(r["ns_per_step"]) for r in rows("steps")
          if r["build"] == "portable"}
    of = {"textbook RK4": ("textbook RK4", 1), "coin_step": ("rk4", 2),
          "one step of RK8": ("rk8", 3)}
    return [("" if r["call"] == "textbook RK4" else f"{r['rate']}/s",
             (number(r["error"]), number(r["rate"]) * ns[of[r["call"]][0]]),
             of[r["call"]][1])
            for r in rows("frames")
            if r["build"] == "portable" and r["call"] in of]


def frame_loop():
    """One call per frame: what it takes, and the error after a second, against
    the frame rate."""
    style = {"textbook RK4": 1, "coin_step": 2, "one step of RK8": 3,
             "coin_advance 1e-6": 4, "coin_advance 1e-9": 4,
             "coin_orbit_at": 14, "coinf_step": 15}
    calls = [r for r in rows("frames") if r["build"] == "portable"]
    for column, (low, high) in FRAMES.items():
        curves = {name: [(number(r["rate"]), number(r[column]))
                         for r in calls if r["call"] == name] for name in style}
        if column == "error":  # coin_step's errors are the textbook's
            del curves["textbook RK4"]
        stem = OUT / f"frame_{column}"
        stem.with_suffix(".dat").write_text(
            "\n\n\n".join(map(block, curves.values())) + "\n")
        stem.with_suffix(".styles").write_text(
            " ".join(str(style[name]) for name in curves) + "\n")
        write_labels(stem, labels.Panel(310, 330, (50, 1200), (low, high), 12),
                     curves, style)


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
CURVES |= rungs.elsewhere(pathlib.Path(__file__).parent / "peers/heyoka.csv",
                          rungs.plain_step(rows("steps")))
for name in SCENES:
    panel(OUT / f"ns_{name}", name, TIMES, "cost", NS["portable", name],
          labels.Panel(*PANEL, ERRORS, COSTS["ns"]))
    panel(OUT / f"slopes_{name}", name, SLOPES, "slopes", 1,
          labels.Panel(*PANEL, ERRORS, COSTS["slopes"]))
panel(OUT / "second", "quarter", TIMES, "cost",
      NS["portable", "quarter"] / QUARTER,
      labels.Panel(*SECOND[2:], (1e-15, 5), SECOND[:2], 12), rates())
frame_loop()
drifts = rows("longrun")
chart("energy", by_run(drifts, "energy_rms"), -17, 0)
chart("integrals", by_run(drifts, "KY_rms", "KZ_rms"), -17, 0)
chart("phase", by_run(drifts, "phase_rms"), -15, 5)
chart("damping", by_run(rows("damping"), "swing"), 0, 0.7, float, float)
