#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Instructions over random valid states, against what is said of them.

    bound.py OUT DOCS INCLUDE           fails unless those of steps are within
                                        5 % of the table in DOCS, and those of
                                        other calls within coin.h's sentence
    bound.py OUT DOCS INCLUDE update    writes the table

OUT is callgrind's, with a part for each call of bound.c.  A call takes at most
one textbook step, or what its comment says: "at most N textbook steps", or any
other "Cost:".
"""
import collections
import pathlib
import re
import statistics
import sys

# Another version of the same compiler moves a row by a few per cent; what
# fails to inline, or calls where nothing did, by more.
WITHIN = 0.05
STATES = 1000
LONG = 12  # steps of coin_advance that make its start and end count little
STEPS = 64
TEXTBOOK = 1496  # instructions of a textbook step, by which all pages count
DOCUMENTED = re.compile(r"/\*\*((?:(?!\*/).)*)\*/\s*COIN_API[^;(]*?\b(\w+)\(",
                        re.S)
BLOCK = re.compile(r"(<!-- bound -->\n).*?(<!-- end -->)", re.S)


def parts(path):
    """(label, instructions, calls of a step of coin_advance) of each part."""
    label, total, steps, is_step = None, 0, 0, False
    with open(path, encoding="ascii", errors="replace") as out:
        for line in out:
            if line.startswith("desc: Trigger: Client Request: "):
                label, steps = line.split(": ", 3)[3].strip(), 0
            elif line.startswith("summary: "):
                total = int(line.split()[1])
            elif line.startswith("cfn="):
                is_step = line.strip() == "cfn=coin_priv_extrapolate"
            elif line.startswith("calls=") and is_step:
                steps += int(line[6:].split()[0])
            elif line.startswith("part: ") and label:
                yield label, total, steps
                label = None
    if label:
        yield label, total, steps


def measured(path):
    """{row: instructions of each state}."""
    found, first = collections.defaultdict(list), 0
    for label, total, steps in parts(path):
        name, what = label.split(",")
        if what == "first":
            found[name, "a call of one step"].append(total)
            first = total
        elif what == "all":
            found[name, "each further step"].append((total - first) / STEPS)
        elif what == "landed" and steps >= LONG:
            found["coin_advance", "each step, its call's share included"] \
                .append(total / steps)
    return found


def table(found):
    rows = ["| method | what | states | least | median | most |",
            "| --- | --- | --- | --- | --- | --- |"]
    for (name, what), counts in found.items():
        figures = min(counts), statistics.median(counts), max(counts)
        rows.append(f"| {name} | {what} | {len(counts)} | "
                    + " | ".join(f"{n:.0f}" for n in figures) + " |")
    return "\n".join(rows) + "\n"


def numbers(text):
    """{first two cells: the others} of the rows of a table."""
    rows = [[c.strip() for c in line.strip("| ").split("|")]
            for line in text.splitlines()[2:] if line.startswith("|")]
    return {tuple(r[:2]): [int(n) for n in r[2:]] for r in rows}


def compare(got, stated):
    wrong = [f"{key}: not in the docs, or not measured"
             for key in sorted(got.keys() ^ stated.keys())]
    for key in got.keys() & stated.keys():
        for name, g, s in zip(("states", "least", "median", "most"),
                              got[key], stated[key]):
            if abs(g - s) > WITHIN * s:
                wrong.append(f"{' '.join(key)}: {name} {g}, stated {s}")
    return wrong


def allowed(include):
    """{function: textbook steps that a call may take}."""
    most = {}
    for header in "coin.h", "coinf.h":
        for comment, name in DOCUMENTED.findall((include / header).read_text()):
            said = " ".join(comment.replace("*", " ").split())
            stated = re.search(r"at most ([\d.,]+) textbook steps", said)
            most[name] = (float(stated[1].replace(",", "")) if stated else
                          float("inf") if "Cost:" in said else
                          most.get(name.replace("coinf", "coin"), 1))
    return most


def dear(out, include):
    """The functions that a call of takes more than is said."""
    taken, most = collections.defaultdict(int), allowed(include)
    for label, total, _ in parts(out):
        row, what = label.split(",")
        if what == "call":
            name = max((n for n in most if f"{row}_".startswith(f"{n}_")),
                       key=len)
            taken[name] = max(taken[name], total / TEXTBOOK)
    dearest = max((n for n in taken if most[n] == 1), key=taken.get)
    print(f"{len(taken)} other functions; of those that state no cost "
          f"{dearest} takes most: {taken[dearest]:.2f} textbook steps")
    if len(taken) < 60:
        yield "too few functions were called"
    for name, steps in taken.items():
        if steps > most[name]:
            yield f"{name}: {steps:.2f} textbook steps, stated {most[name]:g}"


def main(out, docs, include, update=None):
    found = measured(out)
    calls = [len(c) for (_, what), c in found.items() if "one step" in what]
    if calls != [STATES] * 4:
        sys.exit(f"bound: {calls} calls, not {STATES} of each of 4 kinds")
    path, now = pathlib.Path(docs), table(found)
    print(now, end="")
    text = path.read_text()
    block = BLOCK.search(text)
    if not block:
        sys.exit(f"{docs} has no table <!-- bound -->")
    if update:
        path.write_text(BLOCK.sub(lambda m: m[1] + now + m[2], text))
        return
    wrong = [*compare(numbers(now), numbers(block[0].split("\n", 1)[1])),
             *dear(out, pathlib.Path(include))]
    sys.exit("\n".join(["bound: other figures than are stated", *wrong])
             if wrong else 0)


main(*sys.argv[1:])
