#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Figures that a page takes from the table of another are that table's.

    quotes.py ROOT

The tables are written, or held, by what measures them.  A figure has to be what
stands there, rounded to the digits that it has.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])


def cells(page, name, title=""):
    """{row: {column: text}} of the table, of that title if there are several
    between <!-- NAME --> and <!-- end -->; a build is half of a row's name."""
    text = (ROOT / "docs" / page).read_text()
    block = re.search(rf"<!-- {name} -->\n(.*?)<!-- end -->", text, re.S)[1]
    table = next(t for t in block.split("\n\n") if title in t.split("\n")[0])
    head, _, *rows = [[c.strip(" `*") for c in line.strip("|").split("|")]
                      for line in table.strip().split("\n")]
    named = 2 if head[0] == "build" else 1
    return {" ".join(row[:named]): dict(zip(head, row)) for row in rows}


def figure(table, row, column):
    return float(table[row][column].replace(",", ""))


FRAMES = cells("accuracy.md", "frames")
CALLS = cells("accuracy.md", "calls")
BATCH = cells("accuracy.md", "batch")
RUNS = cells("limits.md", "silent methods")
COUNT = cells("embedding.md", "firmware", "instructions")
STACK = cells("embedding.md", "firmware", "stack")
ORBITS = cells("accuracy.md", "orbit ratios")
STEPS = cells("accuracy.md", "steps")
GROWTH = cells("accuracy.md", "growth")
WALKS = [figure(GROWTH, row, integral) for row in GROWTH
         if row.startswith("symplectic") for integral in ("K_Y", "K_Z")]


def abreast(build):
    return figure(BATCH, build + " rk4", "abreast, ns")


def count(board, *calls):
    return sum(figure(COUNT, board, call) for call in calls)


def further(method):
    """Instructions of a step of a run, by the table of bounds."""
    page = (ROOT / "docs/accuracy.md").read_text()
    return float(re.search(
        rf"\| {method} \| each further step \|.*\| (\d+) \| \d+ \|\n",
        page)[1])


def same(said, truth):
    """Whether a figure is the truth, rounded to the digits that it has."""
    mantissa, e, power = said.replace(",", "").partition("e")
    unit = 10.0**(int(power or 0) - len(mantissa.partition(".")[2]))
    return abs(float(mantissa + e + power) - truth) <= 0.5001 * unit


def quarter(call, *rates):
    return [figure(FRAMES, call, f"error at {rate}/s") for rate in rates]


def longrun(method, h, steps, column):
    """The table of long runs, whose rows are told by three columns."""
    page = (ROOT / "docs/accuracy.md").read_text()
    head, _, *rows = [[c.strip() for c in line.strip("|").split("|")]
                      for line in re.search(
                          r"<!-- longrun -->\n(.*?)\n<!-- end -->", page,
                          re.S)[1].split("\n")]
    return next(float(r[head.index(column)]) for r in rows
                if r[:3] == [method, h, steps])


def portable_step(method):
    """In ns."""
    return float(STEPS[method]["portable, ns (textbook's / it)"].split()[0])


def drift(h):
    """Of the energy of rk8 in a unit of time."""
    return longrun("rk8", h, "1e+07", "energy, rms") / 1e7 / float(h)


def orbits(column):
    return [figure(ORBITS, scene, column) for scene in ORBITS]


def slide(scene, method, error=1e-3):
    """The least cost of an error, in textbook steps."""
    rows = [line.split(",") for line in
            (ROOT / "tests/studies/bench/results/slides.csv").read_text().split("\n")
            if line.startswith(f"{scene},{method},")]
    return min((float(r[5]) for r in rows if float(r[4]) <= error),
               default=float("inf"))


def slides(scene):
    """Of each method that gets there."""
    costs = [slide(scene, method) for method in (
        "located", "usual RK4", "regularised RK4", "regularised BDF",
        "time stepping")]
    return [cost for cost in costs if cost < float("inf")]


# A page, what stands there with its figures as groups, and what they are.
QUOTES = (
    ("README.md", r"`coin_step` takes (\d+) instructions; .*? takes (\d+)\.",
     figure(CALLS, "coin_step", "instructions"),
     figure(CALLS, "textbook RK4 step", "instructions")),
    ("include/coin.h", r"Cost: ([\d,]+) instructions, where a further step of "
     r"coin_run\(\) takes (\d+);",
     figure(CALLS, "coin_step", "instructions"), further("rk4")),
    ("README.md", r"Of ([\d,]+) random runs of this library \[(\d+) exceeded",
     figure(RUNS, "all", "runs"), figure(RUNS, "all", "wrong and silent")),
    ("README.md", r"(\d+) bytes of stack on a Cortex-M4F",
     figure(STACK, "m4f", "coinf_step")),
    ("docs/accuracy.md", r"(\d\.\d)e13 steps",
     longrun("symplectic2", "0.05", "1e+07", "energy, rms") /
     drift("0.05") / 0.05 / 1e13),
    ("docs/accuracy.md", r"13 steps, which take (\d+) days",
     longrun("symplectic2", "0.05", "1e+07", "energy, rms") / drift("0.05") /
     0.05 * portable_step("rk8") / 86400e9),
    ("docs/accuracy.md", r"`rk8` divides it by about (\d+)0\.",
     drift("0.1") / drift("0.05") / 10),
    ("docs/accuracy.md", r"grows as `t\^([\d.]+)` to `t\^([\d.]+)` here",
     min(WALKS), max(WALKS)),
    ("docs/limits.md", r"Of ([\d,]+) random runs",
     figure(RUNS, "all", "runs")),
    ("docs/embedding.md", r"takes a Cortex-M4F (\d+) times",
     count("m4f", "coin_step") / count("m4f", "coinf_step")),
    ("docs/embedding.md", r"spends (\d+) us .*?`coinf_step` and (\d+) in",
     count("m4f", "coinf_step") / 64, count("m4f", "coinf_check") / 64),
    ("docs/embedding.md", r"at 48 MHz takes ([\d.]+) ms",
     count("m0", "coinf_step") / 48e3),
    ("docs/embedding.md", r"of the (\d+) instructions of rv64",
     count("rv64", "coinf_run")),
)

wrong = []
for page, pattern, *truths in QUOTES:
    text = re.sub(r"\s+", " ", (ROOT / page).read_text())
    found = re.findall(pattern, text)
    if len(found) != 1:
        wrong.append(f"{page}: {len(found)} times {pattern}")
        continue
    groups = found[0] if isinstance(found[0], tuple) else found
    for said, truth in zip(groups, truths, strict=True):
        if not same(said, truth):
            wrong.append(f"{page}: {said} for {truth:g} in {pattern}")
print(f"{len(QUOTES)} quotes of tables")
sys.exit("\n".join(wrong) if wrong else 0)
