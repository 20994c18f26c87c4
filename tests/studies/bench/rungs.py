#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The rungs of work against precision, as programs write them, a line each, and
as accuracy.csv keeps them: a line for each quantity of a curve, which takes a
quarter of the room.

    rungs.py <rungs.csv >accuracy.csv

A cost is in steps of the textbook's RK4 per natural unit of time, each relative
to one timed at the same moments; what that step took when it was quickest is
kept for each build and scene.  Of a curve some 16 rungs are kept, evenly, and
one below the floor of rounding.  Right-hand sides are those of the portable build.
"""
import csv
import math
import pathlib
import sys

HEAD = "build,scene,method,quantity,rungs"
BELOW_FLOOR = 1
MANY = 16 # of a curve: a reader sees no difference


def table(lines):
    return list(csv.DictReader(l for l in lines if l[:1] != "#"))


def short(x, digits=3):
    """The shortest text of so many digits."""
    text = f"{x:.{digits}g}"
    mantissa, e, power = text.partition("e")
    return mantissa + (f"e{int(power)}" if e else "")


def rough(x):
    """The same of a time, which is known to some per cent, or of a number that
    is only drawn: two digits, or three if the first is 1."""
    return short(x, 3 if f"{x:e}"[0] == "1" else 2)


def above_floor(rows):
    """The rungs down to the least error, some MANY of them, and what shows that
    it is that."""
    errors = [float(r["error"]) if r["status"] == "ok" else math.inf
              for r in rows]
    least = errors.index(min(errors))
    step = max(1, -(-least // MANY))
    return rows[:least:step] + rows[least:least + 1 + BELOW_FLOOR]


def kept(lines):
    rows = table(lines)
    quiet, curves = {}, {}
    for r in rows:
        key = r["build"], r["scene"], r["method"]
        curves.setdefault(key, []).append(r)
        if r["status"] == "ok":
            ns = float(r["textbook_ns"])
            quiet[key[:2]] = min(quiet.get(key[:2], ns), ns)
    yield HEAD
    for key, ns in quiet.items():
        yield ",".join([*key, "textbook RK4", "ns_per_step", short(ns)])
    for key, all_of_it in curves.items():
        ran = above_floor(all_of_it)
        good = [r["status"] == "ok" for r in ran]
        for quantity, values in (
                ("slopes", [rough(float(r["slopes_per_unit"])) for r in ran]),
                ("error", [short(float(r["error"]), 2) if ok
                           else r["status"].replace(" ", "_")
                           for r, ok in zip(ran, good)]),
                ("cost", [rough(float(r["ns_per_unit"])
                                / float(r["textbook_ns"]))
                          for r, ok in zip(ran, good) if ok])):
            if key[0] == "portable" or quantity in ("error", "cost"):
                yield ",".join([*key, quantity, " ".join(values)])


def curves(path):
    """{(build, scene, method): [rung]} of a kept file, a rung a dict of error,
    cost, slopes and status, its error and cost NaN where that is not "ok"; and
    {(build, scene): ns of the textbook's step}."""
    if not pathlib.Path(path).exists():
        return {}, {}
    found, ns = {}, {}
    for r in table(pathlib.Path(path).read_text().splitlines()):
        key = r["build"], r["scene"], r["method"]
        if r["quantity"] == "ns_per_step":
            ns[key[:2]] = float(r["rungs"])
        else:
            found.setdefault(key, {})[r["quantity"]] = r["rungs"].split()
    return {key: rungs(columns) for key, columns in found.items()}, ns


def elsewhere(path, step):
    """{(build, scene, method): [rung]} of heyoka.csv, whose costs are in steps
    that take so many of the textbook's."""
    found = {}
    if math.isnan(step):
        return found
    for r in table(pathlib.Path(path).read_text().splitlines()):
        found.setdefault(("portable", r["scene"], "heyoka"), []).append(
            {"status": "ok", "error": float(r["error"]),
             "cost": float(r["cost"]) * step, "slopes": math.nan})
    return found


def plain_step(rows):
    """What a step of RK4 without tangent costs, by steps.csv, in the
    textbook's."""
    ns = {r["method"]: float(r["ns_per_step"]) for r in rows
          if r["build"] == "portable"}
    return ns.get("RK4 without tangent", math.nan) / ns["textbook RK4"]


def rungs(columns):
    cost = iter(columns["cost"])
    out = []
    unknown = [math.nan] * len(columns["error"])
    for error, slopes in zip(columns["error"], columns.get("slopes", unknown),
                             strict=True):
        good = error[0].isdigit()
        out.append({"status": "ok" if good else error,
                    "error": float(error) if good else math.nan,
                    "cost": float(next(cost)) if good else math.nan,
                    "slopes": float(slopes)})
    return out


def front(rungs, what="cost"):
    """Of (error, cost) those that no cheaper rung beats.  An error counts if
    the next finer rung reaches it too: by one alone it can be where two terms
    of an error cancel."""
    pairs = list(zip(rungs, [*rungs[1:], *rungs[-1:]]))
    points = [(max(r["error"], finer["error"]), r[what]) for r, finer in pairs
              if r["status"] == finer["status"] == "ok"]
    kept = []
    for error, cost in sorted(points, key=lambda p: p[1]):
        if not kept or error < kept[-1][0]:
            kept.append((error, cost))
    return kept


def cost_at(front, error):
    """What an error costs, straight in the logarithms between two rungs; None
    where no rung reaches it."""
    before = None
    for reached, cost in front:
        if reached <= error:
            if before is None:
                return cost
            share = math.log(before[0] / error) / math.log(before[0] / reached)
            return before[1] * (cost / before[1]) ** share
        before = reached, cost
    return None


if __name__ == "__main__":
    lines = sys.stdin.read().splitlines()
    print("\n".join([*(l for l in lines if l[:1] == "#"), *kept(lines)]))
