#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Figures that a page takes from a table of another are that table's.

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
    between <!-- NAME --> and <!-- end -->."""
    block = re.search(rf"<!-- {name} -->\n(.*?)<!-- end -->",
                      (ROOT / page).read_text(), re.S)[1]
    table = next(t for t in block.split("\n\n") if title in t.split("\n")[0])
    head, _, *rows = [[c.strip(" `*") for c in line.strip("|").split("|")]
                      for line in table.strip().split("\n")]
    return {row[0]: dict(zip(head, row)) for row in rows}


def figure(table, row, column):
    return float(table[row][column].replace(",", ""))


COSTS = cells("docs/accuracy.md", "costs")
RATIOS = cells("docs/accuracy.md", "ratios portable")
RUNS = cells("tests/studies/tables.md", "silent methods")
COUNT = cells("docs/embedding.md", "firmware", "instructions")
STEP = 1496 # instructions of a textbook step, by which all pages count
STACK = cells("docs/embedding.md", "firmware", "stack")


def cost(call):
    return figure(COSTS, call, "instructions")


def same(said, truth):
    """Whether a figure is the truth, rounded to the digits that it has."""
    mantissa, e, power = said.replace(",", "").partition("e")
    unit = 10.0**(int(power or 0) - len(mantissa.partition(".")[2]))
    return abs(float(mantissa + e + power) - truth) <= 0.5001 * unit


# A page, what stands there with its figures as groups, and what they are.
QUOTES = (
    ("README.md", r"`coin_step` takes (\d+) instructions, ([\d.]+) of",
     cost("coin_step"), cost("coin_step") / STEP),
    ("README.md", r"([\d.]+) times as fast as a textbook's RK4 at an error of 1e-9",
     min(float(row["1e-09"].split()[0]) for row in RATIOS.values())),
    ("include/coin.h", r"Cost: ([\d,]+) instructions, where a further step of "
     r"coin_run\(\) takes (\d+);", cost("coin_step"),
     cost("coin_run, a further step of RK4")),
    *((page, r"Of ([\d,]+) random runs", figure(RUNS, "all", "runs"))
      for page in ("README.md", "docs/limits.md")),
    ("README.md", r"(\d+) bytes of stack on a Cortex-M4F",
     figure(STACK, "m4f", "coinf_step")),
    ("docs/embedding.md", r"takes a Cortex-M4F (\d+) times",
     figure(COUNT, "m4f", "coin_step") / figure(COUNT, "m4f", "coinf_step")),
    ("docs/embedding.md", r"Cortex-M4F at 64 MHz needs (\d+) ms for a call",
     figure(COUNT, "m4f", "coin_move") / 64e3),
)

wrong = []
for page, pattern, *truths in QUOTES:
    found = re.findall(pattern, re.sub(r"\s+", " ", (ROOT / page).read_text()))
    if len(found) != 1:
        wrong.append(f"{page}: {len(found)} times {pattern}")
        continue
    groups = found[0] if isinstance(found[0], tuple) else found
    wrong += [f"{page}: {said} for {truth:g} in {pattern}"
              for said, truth in zip(groups, truths, strict=True)
              if not same(said, truth)]
print(f"{len(QUOTES)} quotes of tables")
sys.exit("\n".join(wrong) if wrong else 0)
