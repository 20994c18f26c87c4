#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the studies came to, as tables in Markdown.

    summary.py FOLDER PAGE...
    summary.py FOLDER PAGE... --check

FOLDER holds accuracy.csv, costs.csv, ...; what is between the lines
<!-- NAME --> and <!-- end --> of a PAGE becomes the table of that name, if it is
one of those made here and its CSV is there.  With --check nothing is written: a
PAGE whose tables are others fails.

A ratio compares what an error costs, straight in the logarithms between two
settings, each cost relative to a textbook step timed in the same moments.
"""
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
STEP = 1496 # instructions of a textbook step, by which all pages count
GROWTH_FROM = 1e5 # steps, after which a long run shows its law


def read(name):
    return rungs.read(FOLDER / f"{name}.csv")


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, l)) + " |" for l in lines)


CURVES, _ = rungs.curves(FOLDER / "accuracy.csv")
FRONTS = {key: rungs.front(curve) for key, curve in CURVES.items()}
FREE = {m for _, _, m in CURVES if m.startswith("sine-free")}
HEYOKA = {"heyoka"}
PEERS = {m for _, _, m in CURVES} - {
    *OURS, *SYMPLECTIC, *FREE, *HEYOKA, TEXTBOOK, "orbit"}


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


def frames():
    """One call per frame: the error after a second, by frame rate."""
    found = {}
    for r in read("frames"):
        found.setdefault(r["call"], {})[r["rate"]] = r["error"]
    rates = next(iter(found.values()))
    return table(["call", *(f"at {rate}/s" for rate in rates)],
                 [[call, *(rungs.short(float(e), 2) for e in by.values())]
                  for call, by in found.items()])


def costs():
    """Each cost in textbook steps: times in those of the first row."""
    rows = read("costs")
    columns = [c for c in rows[0] if c != "call"]
    unit = {c: float(rows[0][c]) for c in columns} | {"instructions": STEP}
    def part(r, c):
        x = float(r[c]) / unit[c]
        return f"{float(f'{x:.3g}'):,.0f}" if x >= 10 else f"{x:.2f}"
    def size(r, c):
        x = float(r[c])
        return f"{x:,.0f}" if x >= 100 else f"{x:.1f}"
    return table(["call", *(v for c in columns for v in (c, "textbook steps"))],
                 [[r["call"], *(v for c in columns
                                for v in (size(r, c), part(r, c)))]
                  for r in rows])


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
                if k not in ("method", "family"):
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


def silent_steps():
    """What steps add without limits, by method and |dt| W."""
    methods = OURS[:2] + SYMPLECTIC
    rows = [r for r in read("silent_steps") if float(r["dtW"]) > 0.02]
    cell = {(r["method"], r["dtW"]): float(r["worst"]) for r in rows}
    return table(["abs(dt) W up to", *methods],
                 [[size, *("lost" if cell[m, size] > 1e3 else
                           f"{cell[m, size]:.1g}" for m in methods)]
                  for size in dict.fromkeys(r["dtW"] for r in rows)])


def adversary():
    """The worst that a directed search found of each function."""
    return table(["function", "law", "evaluations", "worst of the bound"],
                 [[f"`{r['function']}`", r["law"], r["evaluations"],
                   "beyond" if r["ratio"] == "inf" else r["ratio"]]
                  for r in read("adversary")])


def luck(name, what):
    """The rows of a study of docs/luck.md that say one thing."""
    return [r for r in read(f"luck_{name}") if r["what"].strip() == what]


def share(r, digits=4):
    """A share, and its standard error in its last digits, if it has any."""
    error = round(float(r["error"])*10**digits)
    return f"{float(r['share']):.{digits}f}" + (f"({error})" if error else "")


def same_side():
    return table(["angle", "law", "coin_move", "tosses"],
                 [[f"{float(r['x']):g} degrees", f"{float(r['expected']):.4f}",
                   share(r), f"{int(r['tosses']):,}"]
                  for r in luck("caught", "same side")])


def neighbours():
    rows = luck("dust", "neighbour ends otherwise")
    apart = sorted({float(r["y"]) for r in rows}, reverse=True)
    slopes = {r["x"]: share(r, 3) for r in luck("dust", "slope")}
    impacts = {r["x"]: f"{float(r['share']):.0f}"
               for r in luck("dust", "impacts")}

    def seen(x, y):
        found = next(float(r["share"]) for r in rows
                     if r["x"] == x and float(r["y"]) == y)
        return f"{found:.2g}".replace("e-0", "e-")
    return table(["restitution", *(f"{y:.0e}".replace("e-0", "e-")
                                   for y in apart), "slope", "impacts"],
                 [[x, *(seen(x, y) for y in apart), slopes.get(x, ""),
                   impacts[x]] for x in dict.fromkeys(r["x"] for r in rows)])


def hands():
    return table(["restitution", "friction", "same side", "tosses"],
                 [[r["y"], r["x"], share(r, 3), f"{int(r['tosses']):,}"]
                  for r in luck("fair", "same side of a hand by friction")])


def heights():
    return table(["height, radii", "of a quarter", "heads"],
                 [[f"{float(r['x']):.1f}", f"{12.13*float(r['x']):.0f} mm",
                   share(r, 3)]
                  for r in luck("heights", "let go within 5 degrees of flat")])


def edge(what):
    """Thickness over diameter, and the share on the edge at each friction."""
    rows = luck("edge", what)
    return [[h, *(share(r, 3) for r in rows if r["x"] == h)]
            for h in dict.fromkeys(r["x"] for r in rows)]


def tosses_on_edge():
    return table(["thickness/diameter", *(f"{what}, friction {mu}"
                                          for what in ("dry", "angular")
                                          for mu in ("0.1", "0.2", "0.3"))],
                 [dry + angular[1:] for dry, angular in zip(edge("dry"),
                                                            edge("angular"))])


def static_rule():
    return table(["thickness/diameter", "h/sqrt(1 + h^2)", "coin_move",
                  "drops"],
                 [[r["x"], f"{float(r['expected']):.4f}", share(r),
                   f"{int(r['tosses']):,}"]
                  for r in luck("edge", "static rule")])


def third():
    return table(["friction", "losses", "a third at thickness/diameter"],
                 [[r["x"], "angular" if float(r["y"]) else "dry", share(r, 3)]
                  for r in luck("edge", "a third on its edge")])


def engines():
    rows, lines = read("luck_engines"), []
    for r in rows:
        if not r["what"].startswith(" "):
            setting = (f"tolerance {r['x']}" if r["what"] == "coin_move"
                       else f"{r['x']} step" + "s"*(r["x"] != "1")
                       + " a frame")
            lines.append([r["what"], setting, share(r, 3), "0", "",
                          f"{int(r['tosses']):,}"])
        elif "neither" in r["what"]:
            lines[-1][3] = share(r, 3)
        else:
            lines[-1][4] = f"{float(r['share']):.2f} ms"
    return table(["by", "setting", "heads", "on its edge", "a toss takes",
                  "tosses"], lines)


def engine_frames():
    """A frame by coin_move and by engines: of an engine's options, those that
    err least with so many steps."""
    best = rungs.best_options(read("engine_frames"))
    names = [key[1:] for key in best if key[0] == "quarter"]

    def cells(scene, name):
        r = best[scene, *name]
        error = float(r["error"])
        return (f"{float(r['ns'])/1e3:.3g} us",
                f"{error:.1g}" if error < 1e-3 else f"{error:.2g}")
    return table(["by", "setting", "a quarter rolls: a frame",
                  "off its path, radii", "Euler's disk spins: a frame",
                  "energy off by"],
                 [[name, f"tolerance {x:g}" if x < 1 else
                   f"{x:g} step" + "s"*(x > 1),
                   *cells("quarter", (name, x)), *cells("disk", (name, x))]
                  for name, x in names if x < 1 or x in (1, 4, 16, 64)])


# Each table, and the CSV that it is made from.
TABLES = {"frames": ("frames", frames), "costs": ("costs", costs),
          "atlas": ("atlas", atlas), "longrun": ("longrun", longrun),
          "growth": ("longrun", growth), "least": ("accuracy", least),
          "peers": ("accuracy", lambda: peers(PEERS)),
          "peers free": ("accuracy", lambda: peers(FREE)),
          "heyoka": ("accuracy", lambda: peers(HEYOKA)),
          "ratios portable": ("accuracy", lambda: ratios("portable")),
          "ratios native": ("accuracy", lambda: ratios("native")),
          "silent steps": ("silent_steps", silent_steps),
          "silent methods": ("silent", lambda: silent("method")),
          "silent families": ("silent", lambda: silent("family")),
          "adversary": ("adversary", adversary),
          "luck same side": ("luck_caught", same_side),
          "luck neighbours": ("luck_dust", neighbours),
          "luck hands": ("luck_fair", hands),
          "luck heights": ("luck_heights", heights),
          "luck static rule": ("luck_edge", static_rule),
          "luck edge": ("luck_edge", tosses_on_edge),
          "luck third": ("luck_edge", third),
          "engine frames": ("engine_frames", engine_frames),
          "luck engines": ("luck_engines", engines)}


def made(match):
    csv, make = TABLES.get(match[2], (None, None))
    if csv is None or not (FOLDER / f"{csv}.csv").exists():
        return match[0]
    return match[1] + make() + "\n" + match[3]


def main():
    check = "--check" in sys.argv
    for page in map(pathlib.Path, sys.argv[2:len(sys.argv) - check]):
        old = page.read_text()
        new = re.sub(r"(<!-- ([\w ]+) -->\n).*?(<!-- end -->)", made, old,
                     flags=re.S)
        if not check:
            page.write_text(new)
        elif new != old:
            wrong = set(old.splitlines()) - set(new.splitlines())
            sys.exit("\n".join([f"{page}: not what {FOLDER} says:", *wrong]))


main()
