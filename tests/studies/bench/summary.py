#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the benchmarks came to, as tables in Markdown.

    summary.py FOLDER [PAGE]...
    summary.py FOLDER PAGE... --check

FOLDER holds accuracy.csv, steps.csv, ...; what is between the lines
<!-- NAME --> and <!-- end --> of a PAGE becomes the table of that name, if it is
one of those made here.  With --check nothing is written: a PAGE whose tables
are others fails.

A ratio compares what an error costs, straight in the logarithms between two
settings, each cost relative to a textbook step timed in the same moments.
"""
import csv
import math
import pathlib
import re
import statistics
import sys

import rungs

FOLDER = pathlib.Path(sys.argv[1])
BUILDS = ("portable", "native")
SCENES = ("wobble", "generic", "tumble", "ring", "quarter", "nearflat")
ERRORS = (1e-3, 1e-6, 1e-9, 1e-12)
OURS = ("rk4", "rk8", "coin_advance")
SYMPLECTIC = ("symplectic2", "symplectic4")
TEXTBOOK = "textbook RK4"
GROWTH_FROM = 1e5 # steps, after which a long run shows its law


def read(name):
    path = FOLDER / f"{name}.csv"
    if not path.exists():
        return []
    lines = [l for l in path.read_text().splitlines() if l[:1] != "#"]
    return list(csv.DictReader(lines))


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, l)) + " |" for l in lines)


CURVES, _ = rungs.curves(FOLDER / "accuracy.csv")
CURVES |= rungs.elsewhere(pathlib.Path(__file__).parent / "peers/heyoka.csv",
                          rungs.plain_step(read("steps")))
FRONTS = {key: rungs.front(curve) for key, curve in CURVES.items()}
FREE = {m for _, _, m in CURVES if m.startswith("sine-free")}
HEYOKA = {"heyoka"}
PEERS = {m for _, _, m in CURVES} - {
    *OURS, *SYMPLECTIC, *FREE, *HEYOKA, TEXTBOOK, "orbit", "rk4 of floats"}


def cheapest(build, scene, methods, error):
    """Cost in textbook steps per unit of time, and whose."""
    found = ((rungs.cost_at(FRONTS.get((build, scene, m), []), error), m)
             for m in methods)
    return min(((cost, m) for cost, m in found if cost), default=None)


def ratio(build, scene, others, error):
    """Their cost over ours, our method, theirs."""
    ours = cheapest("native" if build == "fused" else build, scene, OURS, error)
    theirs = cheapest(build, scene, others, error)
    return ours and theirs and (theirs[0] / ours[0], ours[1], theirs[1])


def ratios(build):
    def cell(scene, error):
        r = ratio(build, scene, (TEXTBOOK,), error)
        return f"{r[0]:.1f} {r[1]}" if r else "not reached by the textbook's"
    return table(["scene", *map("{:g}".format, ERRORS)],
                 [[s, *(cell(s, e) for e in ERRORS)] for s in SCENES])


def peers(others):
    """The best peer's cost over ours, portable / native / native and fused, in
    what builds there are."""
    def cell(scene, error):
        found = (ratio(b, scene, others, error) for b in (*BUILDS, "fused"))
        return " / ".join(f"{r[0]:.1f}" for r in found if r)
    return table(["scene", *map("{:g}".format, ERRORS[1:])],
                 [[s, *(cell(s, e) or "-" for e in ERRORS[1:])]
                  for s in SCENES])


def least():
    """The least of those ratios over all scenes and builds, and where."""
    def cell(others, error):
        found = ((ratio(b, s, others, error), b, s)
                 for b in (*BUILDS, "fused") for s in SCENES)
        worst = min((f for f in found if f[0]), default=None)
        if not worst:
            return "-"
        r, build, scene = worst
        return f"{r[0]:.1f}: {r[2]}, {scene}, {build}"
    return table(["peers", *map("{:g}".format, ERRORS[1:])],
                 [[name, *(cell(others, e) for e in ERRORS[1:])]
                  for name, others in (("with their own equations", PEERS),
                                       ("with our equations", FREE),
                                       ("heyoka, measured elsewhere", HEYOKA))
                  ])


def steps():
    found = {(r["build"], r["method"]): r for r in read("steps")}
    names = [m for b, m in found if b == "portable"
             and found[b, m]["textbook_over_it"]]
    return table(["method", *(f"{b}, ns (textbook's / it)" for b in BUILDS)],
                 [[m, *(f"{float(r['ns_per_step']):.0f} "
                        f"({float(r['textbook_over_it']):.2f})"
                        for r in (found[b, m] for b in BUILDS))]
                  for m in names])


def frames():
    """One call per frame: what it costs at 60 frames/s, and the error after a
    second at each rate."""
    found = {}
    for r in read("frames"):
        if r["build"] == "portable":
            found.setdefault(r["call"], {})[r["rate"]] = r
    rates = list(next(iter(found.values()), {}))
    return table(["call", "ns", "textbook steps",
                  *(f"error at {rate}/s" for rate in rates)],
                 [[call, f"{float(by['60']['ns']):.0f}",
                   by["60"]["textbook_steps"],
                   *(rungs.short(float(by[rate]["error"]), 2)
                     for rate in rates)] for call, by in found.items()])


def costs():
    rows = read("costs")
    return table([k.replace("_", " ") for k in rows[0]],
                 [[v or "-" for v in r.values()] for r in rows])


def batch():
    """Quarters at abs(dt) W = 0.1; the limit is all operations at the best
    rate.  Then the largest part of a loop's time, over all lengths of step."""
    rows = read("batch")
    best = {r["build"]: float(r["abreast_ns"]) for r in rows
            if r["coins"] == "operation at best"}
    cells = [r for r in rows if r["steps"]]
    operations = {r["method"]: sum(float(r[k]) for k in (
        "additions", "products", "divisions")) for r in read("costs")
        if r["additions"]}
    def row(build, method):
        here = [r for r in cells if (r["build"], r["method"]) ==
                (build, method)]
        at = next(r for r in here if (r["coins"], r["steps"], r["dt_W"]) ==
                  ("quarter", "64", "0.1"))
        alone, abreast, book = (float(at[k]) for k in (
            "alone_ns", "abreast_ns", "textbook_ns"))
        def most(coins, steps):
            return max(float(r["abreast_ns"]) / float(r["alone_ns"])
                       for r in here if (r["coins"], r["steps"]) ==
                       (coins, steps))
        limit = operations[method] * best[build]
        return [build, method, f"{alone:.1f}", f"{abreast:.1f}",
                f"{alone / abreast:.2f}", f"{book / abreast:.1f}",
                f"{100 * limit / abreast:.0f} %",
                *(" / ".join(f"{most(coins, steps):.2f}"
                             for steps in ("1", "16", "64"))
                  for coins in ("quarter", "any"))]
    return table(["build", "method", "alone, ns", "abreast, ns",
                  "alone / abreast", "textbook / abreast", "of the limit",
                  "at most, quarters", "at most, any coins"],
                 [row(b, m) for b in BUILDS for m in ("rk4", "rk8")])


def abreast():
    return table(["build", "coins abreast", "a coin's step, ns",
                  "in coin_advance, ns", "gain", "busy, coins alike",
                  "busy, coins of any kind"],
                 [list(r.values()) for r in read("abreast")])


def calls():
    """What a frame loop calls; instructions are the portable build's."""
    found = {}
    for r in read("natural"):
        found.setdefault(r["call"], {})[r["build"]] = r
    return table(["call", *(f"{b}, textbook steps" for b in BUILDS),
                  "instructions"],
                 [[call, *(by[b]["textbook_steps"] for b in BUILDS),
                   by["portable"]["instructions"]]
                  for call, by in found.items()])


def reliability():
    head = ("tol", "coins", "within tol", "within 3 tol", "within 10 tol",
            "median/tol", "worst/tol")
    return table(head, [[v for k, v in r.items() if k != "refused"]
                        for r in read("reliability")])


def best():
    rows = read("best")
    def share(r):
        return min(float(r["coin_advance"]), float(r["rk8"])) / float(r["limit"])
    named = [r for r in rows if not r["scene"].startswith("random")]
    drawn = [r for r in rows if r["scene"].startswith("random")]
    def error(r, method):
        return "refused" if r[method] == "inf" else r[method]
    lines = [[r["scene"], r["units"], r["amp"], error(r, "coin_advance"),
              error(r, "rk8"), r["limit"], r["reached"]] for r in named]
    worst = max(drawn, key=share)
    within = sum(share(r) <= 1 for r in drawn)
    lines.append([f"{len(drawn)} random, the worst of which", worst["units"],
                  worst["amp"], worst["coin_advance"], worst["rk8"],
                  worst["limit"], f"{within} of {len(drawn)}"])
    return table(["scene", "units of time", "amp", "coin_advance", "rk8",
                  "limit", "within"], lines)


def longrun():
    rows = [r for r in read("longrun") if r["steps"] in ("1e+07", "10000000",
                                                       "100000000")]
    return table(["method", "h", "steps", "starts", "energy, rms", "worst",
                  "K_Y, rms", "K_Z, rms", "phase, rms [rad]"],
                 [[r["method"], r["h"], f"{float(r['steps']):.0e}",
                   r["starts"], r["energy_rms"], r["energy_worst"],
                   r["KY_rms"], r["KZ_rms"], r["phase_rms"]] for r in rows])


def growth():
    """Powers of time with which errors grow, by least squares in logarithms
    from GROWTH_FROM on."""
    runs = {}
    for r in read("longrun"):
        if r["starts"] != "1" and float(r["steps"]) >= GROWTH_FROM:
            runs.setdefault((r["method"], r["h"]), []).append(r)
    def power(rows, column):
        if not all(float(r[column]) > 0 for r in rows):
            return ""
        points = [[math.log(float(r[name])) for r in rows]
                  for name in ("t", column)]
        return f"{statistics.linear_regression(*points).slope:.2f}"
    return table(["method", "h", "energy", "K_Y", "K_Z", "phase"],
                 [[*run, *(power(rows, name + "_rms")
                           for name in ("energy", "KY", "KZ", "phase"))]
                  for run, rows in runs.items()])


def atlas():
    """How often each letter of atlas.c; a warning makes it small."""
    of = {}
    for r in read("atlas"):
        of[r["method"]] = of.get(r["method"], "") + r["outcomes"]
    def count(cells, letters):
        return sum(map(cells.count, letters))
    head = ("method", "runs", "right", "right, warned", "wrong, warned",
            "refused", "wrong and silent", "of these through the table or NaN")
    return table(head, [[m, len(o), *(count(o, w) for w in
                         ("R", "r", "plgs", "X", "PLGS", "S"))]
                        for m, o in of.items()])


def silent(key):
    """What became of random runs, by method or family."""
    of = {}
    for r in read("silent"):
        for name in (r[key], "all"):
            sums = of.setdefault(name, dict.fromkeys(r, 0))
            for k in r:
                if k not in ("method", "family", "closest"):
                    sums[k] += int(r[k])
    of["all"] = of.pop("all", {})
    head = (key, "runs", "right", "nothing stated", "warned, right",
            "warned, wrong", "refused, right", "refused, wrong",
            "**wrong and silent**")
    return table(head, [
        [name, r["runs"], r["right"], r["orbit_right"] + r["unstated"],
         r["flagged_right"], r["flagged_wrong"], r["refused_right"],
         r["refused_wrong"], f"**{r['silent']}**"]
        for name, r in of.items() if r])


def silent_steps(column, methods):
    """What comes of steps without limits, by method and |dt| W."""
    rows = [r for r in read("silent_steps") if float(r["dtW"]) > 0.02]
    cell = {(r["method"], r["dtW"]): float(r[column]) for r in rows}
    return table(["abs(dt) W up to", *methods],
                 [[size, *("lost" if cell[m, size] > 1e3 else
                           f"{cell[m, size]:.1g}" for m in methods)]
                  for size in dict.fromkeys(r["dtW"] for r in rows)])


def silent_truth():
    return table(["family", "runs", "worst error, the motion's amplification "
                  "taken out", "of what is allowed for"],
                 [[r["family"], r["runs"], r["worst_error_before_amplification"],
                   r["worst_share"]] for r in read("silent_truth")])


def adversary():
    """The worst that a directed search found of each function."""
    return table(["function", "law", "evaluations", "worst of the bound"],
                 [[f"`{r['function']}`", r["law"], r["evaluations"],
                   "beyond" if r["ratio"] == "inf" else r["ratio"]]
                  for r in read("adversary")])


WAYS = ("rk8", "coin_advance", "rk4", TEXTBOOK, "GSL rk8pd")


def digits(x, n=2):
    return f"{float(f'{x:.{n}g}'):g}"


def time_of(ns):
    for unit, size in (("s", 1e9), ("ms", 1e6), ("us", 1e3), ("ns", 1)):
        if ns >= size:
            return f"{digits(ns / size)} {unit}"


def pays_from(orbit, way):
    """The n at which what n frames cost is the same, {n: cost}: straight in
    the logarithms between two n."""
    before = None
    for n in orbit:
        excess = math.log(orbit[n] / way[n])
        if excess <= 0 and before is None:
            return 0
        if excess <= 0:
            share = before[1] / (before[1] - excess)
            return before[0] * (n / before[0])**share
        before = n, excess
    return math.inf


def orbit():
    """What one frame costs by each way, and from how many on an orbit, which
    costs the same whatever T, is cheaper; or how many times it is for one."""
    cost = {}
    for r in read("orbit_costs"):
        of = cost.setdefault((r["way"], float(r["T"])), {})
        of[float(r["n"])] = float(r["ns"])
    if not cost:
        return "not measured"
    def cell(T, way):
        ns, orbit = cost.get((way, T)), cost["orbit", T]
        if not ns:
            return "-"
        n = pays_from(orbit, ns)
        return f"{time_of(ns[1])}: " + (
            f"{digits(ns[1] / orbit[1])} times" if n == 0
            else f"from {digits(n, 1)} on")
    rows = [[f"{T:.0f}", time_of(cost["orbit", T][1]),
             *(cell(T, w) for w in WAYS)]
            for w, T in cost if w == TEXTBOOK]
    most = max(cost["orbit", 100])
    rows.append([f"100, {digits(most)} frames",
                 f"{time_of(cost['orbit', 100][most] / most)} each",
                 *(f"{digits(cost[w, 100][most] / cost['orbit', 100][most])}"
                   " times" for w in WAYS)])
    return table(["T, units", "orbit", *WAYS], rows)


def orbit_ratios():
    return table(["scene", "query", "init"],
                 [[r["scene"], f"{float(r['query']):.2f}",
                   f"{float(r['init']):.0f}"] for r in read("orbit_ratios")])


TABLES = {"orbit": orbit, "orbit ratios": orbit_ratios, "atlas": atlas,
          "batch": batch, "steps": steps, "frames": frames,
          "costs": costs, "reliability": reliability,
          "best": best, "abreast": abreast, "calls": calls, "longrun": longrun,
          "growth": growth, "least": least,
          "peers": lambda: peers(PEERS), "peers free": lambda: peers(FREE),
          "heyoka": lambda: peers(HEYOKA),
          "silent steps": lambda: silent_steps("worst", OURS[:2] + SYMPLECTIC),
          "silent pairs": lambda: silent_steps("astray", OURS[:2]),
          "silent methods": lambda: silent("method"),
          "silent families": lambda: silent("family"),
          "silent truth": silent_truth, "adversary": adversary}
for name in BUILDS:
    TABLES[f"ratios {name}"] = lambda b=name: ratios(b)


def main():
    if len(sys.argv) == 2:
        for name, make in TABLES.items():
            print(f"\n{name}\n\n{make()}")
        return
    pages = [pathlib.Path(a) for a in sys.argv[2:] if a != "--check"]
    for page in pages:
        old = page.read_text()
        new = re.sub(r"(<!-- ([\w ]+) -->\n).*?(<!-- end -->)",
                     lambda m: m[1] + TABLES[m[2]]() + "\n" + m[3]
                     if m[2] in TABLES else m[0], old, flags=re.S)
        if "--check" not in sys.argv:
            page.write_text(new)
        elif new != old:
            wrong = set(old.splitlines()) - set(new.splitlines())
            sys.exit("\n".join([f"{page}: not what {FOLDER} says:", *wrong]))


main()
