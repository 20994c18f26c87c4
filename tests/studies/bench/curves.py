#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From the kept CSV to what gnuplot draws: NAME.dat with one block per curve,
NAME.styles with their lines of style.gpi, and NAME.labels: x, y, text, style.

    curves.py RESULTS OUT

Work against precision is that of the portable build.  A curve leaves out the
rungs that a cheaper one beats, as all do below the floor of rounding; the CSV
has them.  Of several methods in one curve the cheapest counts at each error.
"""
import math
import pathlib
import sys

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
BESIDE_ENGINES = (SOLVERS[0], SOLVERS[3], ("ODE", 12, ENGINES[:1]),
                  ("MuJoCo", 13, ENGINES[1:]))
SECOND = (("rollcoin", 4, OURS), ("other solvers", 7, PEERS),
          ("a textbook's RK4", 1, ("textbook RK4",)),
          ("engines", 12, ENGINES))
CALLS = {"textbook RK4": 1, "coin_step": 2, "one step of RK8": 3,
         "coin_advance 1e-6": 4, "coin_orbit_at": 14, "coin_move 1e-6": 17,
         "coin_settle 1e-6": 18}
# Of a frame: the line, and the label's place: a setting, its error and cost
# times so much.
MOVERS = {"coin_move": (17, -1, 5, 2.2), "ODE": (12, 2, 0.08, 1),
          "MuJoCo": (13, -1, 0.04, 1), "Bullet": (19, 4, 25, 1)}
LONG = {"rk4": 2, "rk8": 3, "order 14 in tau": 4, "symplectic2": 5,
        "symplectic4": 6}

QUARTER = 0.0351704 # its natural unit of time [s]
MIDDLE = 1e-12      # the error at which the curves of speed.svg are labelled
BESIDE = 1.65       # how far from its curve or mark a label stands
LINE = 0.052        # a line of text, in parts of the height of a chart


def rows(name):
    return rungs.read(RESULTS / f"{name}.csv")


def cheapest(scene, methods, scale):
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
    return [(error, cost * scale) for error, cost in kept]


def write(name, curves, styles, labels):
    blocks = ("\n".join(f"{x:g} {y:g}" for x, y in points) or "nan nan"
              for points in curves)
    (OUT / f"{name}.dat").write_text("\n\n\n".join(blocks) + "\n")
    (OUT / f"{name}.styles").write_text(" ".join(map(str, styles)) + "\n")
    (OUT / f"{name}.labels").write_text("".join(
        f'{x:g} {y:g} "{text}" {style}\n' for x, y, text, style in labels))


def solvers(name, scene, shown, scale, place):
    """Curves of a scene; place(points) is where a label stands."""
    curves = [cheapest(scene, methods, scale) for _, _, methods in shown]
    labels = [(*place(points), text, style)
              for (text, style, _), points in zip(shown, curves) if points]
    write(name, curves, [style for _, style, _ in shown], labels)


def by_middle(points):
    """Below a curve of less than 0.1 ms, else above it."""
    error, cost = min(points, key=lambda p: abs(math.log(p[0] / MIDDLE)))
    return min(error, 1e-4), cost * BESIDE**(2 if cost > 1e5 else -2)


def below_end(points):
    return points[0][0], points[0][1] / BESIDE**1.5


def second():
    """The second of speed.svg, and that second from Python."""
    solvers("second", "quarter", SECOND, NS["portable", "quarter"] / QUARTER,
            by_middle)
    marks = [(float(r["error"]), float(r["ns"]), r["method"], style)
             for r, style in zip(rows("python"), (7, 4))]
    write("python", [[(x, y)] for x, y, _, _ in marks],
          [style for *_, style in marks],
          [(x, y, method.replace("coin_advance ", ""), style)
           for x, y, method, style in marks])


def spread(labels, low, high):
    """Moves labels (y, ...) apart, and keeps their order."""
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


def chart(name, data, low, high, at, scale=math.log10, back=lambda v: 10 ** v):
    """data: {(text, style): [(x, y), ...]}; labels go to x = at, right.  scale
    and back: from y to the axis, which ends at low and high, and back."""
    data = {k: [(x, y) for x, y in points if y > 0]
            for k, points in data.items()}
    labels = spread([(scale(points[-1][1]), *key)
                     for key, points in data.items() if points], low, high)
    write(name, data.values(), [style for _, style in data],
          [(at, back(y), *key) for y, *key in labels])


def frames(column, but=None):
    """One call per frame, against the frame rate."""
    return {(name, style): [(float(r["rate"]), float(r[column]))
                            for r in rows("frames") if r["call"] == name]
            for name, style in CALLS.items() if name != but}


def engine_frames(scene):
    """A frame's cost against its error."""
    best = rungs.best_options(rows("engine_frames"))
    curves, labels = [], []
    for who, (style, at, along, up) in MOVERS.items():
        curves.append([(float(r["error"]), float(r["ns"]))
                       for key, r in best.items() if key[:2] == (scene, who)])
        error, ns = curves[-1][at]
        labels.append((error * along, ns * up, who, style))
    write(f"engines_{scene}", curves, [style for style, *_ in MOVERS.values()],
          labels)


def by_run(name, *columns):
    """The largest of the columns against t, for each method and step."""
    runs = {}
    for r in rows(name):
        key = f"{r['method']}, {r['h']}", LONG[r["method"]]
        runs.setdefault(key, []).append(
            (float(r["t"]), max(float(r[c] or "nan") for c in columns)))
    return runs


OUT.mkdir(parents=True, exist_ok=True)
for scene in ("wobble", "generic", "tumble", "ring", "quarter", "nearflat"):
    solvers(f"ns_{scene}", scene, SOLVERS, NS["portable", scene], below_end)
solvers("ns_engines", "quarter", BESIDE_ENGINES, NS["portable", "quarter"],
        below_end)
second()
chart("frame_ns", frames("ns"), math.log10(40), math.log10(3000), 1100)
chart("frame_error", frames("error", "textbook RK4"), -15, -1, 1100)
for scene in ("quarter", "disk"):
    engine_frames(scene)
chart("energy", by_run("longrun", "energy_rms"), -17, 0, 1.3e7)
chart("integrals", by_run("longrun", "KY_rms", "KZ_rms"), -17, 0, 1.3e7)
chart("phase", by_run("longrun", "phase_rms"), -15, 5, 1.3e7)
chart("damping", by_run("damping", "swing"), 0, 0.7, 1.3e6, float, float)
