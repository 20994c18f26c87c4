#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The rungs of work against precision, as programs write them, a line each, and
as accuracy.csv keeps them: a line for each quantity of a curve, which takes a
quarter of the room.

    rungs.py <rungs.csv >accuracy.csv

A cost is in steps of the textbook's RK4 per natural unit of time, each relative
to one timed at the same moments; what that step took when it was quickest is
kept for each build and scene.  Of a curve some 16 rungs are kept, evenly, and
one below the floor of rounding.
"""
import csv
import math
import pathlib
import sys

HEAD = "build,scene,method,quantity,rungs"
BELOW_FLOOR = 1
MANY = 16 # of a curve: a reader sees no difference


# The unit of heyoka.csv, an RK4 on the right-hand side that peers get, in steps
# of the textbook's: by instructions, 1431 to 1646 on scene generic, gcc 12 -O2.
HEYOKA_UNIT = 0.87


def table(lines):
    head = next(l for l in lines if l[:1] != "#")
    return list(csv.DictReader((l for l in lines if l[:1] != "#"),
                               delimiter=";" if ";" in head else ","))


def read(path):
    """The rows of a CSV of results; none if there is no such file."""
    path = pathlib.Path(path)
    return table(path.read_text().splitlines()) if path.exists() else []


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
                ("error", [short(float(r["error"]), 2) if ok
                           else r["status"].replace(" ", "_")
                           for r, ok in zip(ran, good)]),
                ("cost", [rough(float(r["ns_per_unit"])
                                / float(r["textbook_ns"]))
                          for r, ok in zip(ran, good) if ok])):
            yield ",".join([*key, quantity, " ".join(values)])


def curves(path):
    """{(build, scene, method): [rung]} of a kept file, a rung a dict of error
    and cost, NaN where it failed; and {(build, scene): ns of the textbook's
    step}.  heyoka's, measured elsewhere, are among them."""
    found, ns = {}, {}
    for r in read(path):
        key = r["build"], r["scene"], r["method"]
        if r["quantity"] == "ns_per_step":
            ns[key[:2]] = float(r["rungs"])
        else:
            found.setdefault(key, {})[r["quantity"]] = r["rungs"].split()
    each = {key: rungs(**columns) for key, columns in found.items()}
    for r in read(pathlib.Path(__file__).parent / "peers/heyoka.csv"):
        each.setdefault(("portable", r["scene"], "heyoka"), []).append(
            {"error": float(r["error"]),
             "cost": float(r["cost"]) * HEYOKA_UNIT})
    return each, ns


def best_options(rows):
    """Of rows of engine_frames.csv, those that err least, by scene, by whom and
    setting."""
    best = {}
    for r in rows:
        key = r["scene"], r["by"], float(r["setting"])
        if key not in best or float(r["error"]) < float(best[key]["error"]):
            best[key] = r
    return best


def rungs(error, cost):
    costs = iter(cost)
    good = [e[0].isdigit() for e in error]
    return [{"error": float(e) if ok else math.nan,
             "cost": float(next(costs)) if ok else math.nan}
            for e, ok in zip(error, good)]


def front(rungs):
    """Of (error, cost) those that no cheaper rung beats.  An error counts if
    the next finer rung reaches it too: by one alone it can be where two terms
    of an error cancel."""
    pairs = list(zip(rungs, [*rungs[1:], *rungs[-1:]]))
    points = [(max(r["error"], finer["error"]), r["cost"])
              for r, finer in pairs if r["cost"] > 0 and finer["cost"] > 0]
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
