#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the library takes of a processor, against the tables in the docs.

    figures.py OUT DOCS NAME=PREFIX...           fails unless they agree
    figures.py OUT DOCS NAME=PREFIX... --update  writes them

OUT/NAME holds what firmware.mk made for a board; PREFIX is of its binutils.
"""
import pathlib
import re
import subprocess
import sys

import stack

# The tables are those of one version of each compiler: another moves them by
# some per cent.  What stops to inline, or calls where nothing did, by more.
WITHIN = 0.02

# What firmware was promised: issue by issue, a step must not grow beyond it.
MOST = {("m4f", "instructions", "coinf_step"): 1400,
        ("m4f", "stack", "coinf_step"): 320}

# An entry of coin.h, and the function of counts.c whose stack was looked at.
WORKS = {"coinf_step": "float_steps", "coinf_run": "float_run",
         "coinf_check": "float_checks",
         "coin_step": "double_steps", "coin_run": "double_run"}
UNWANTED = {"malloc", "_malloc_r", "free", "_sbrk", "__errno", "printf"}
BLOCK = re.compile(r"(<!-- firmware -->\n).*?(<!-- end -->)", re.S)


def size(prefix, files, libraries=False):
    """Bytes of code and constants.  Of data there are none, but what compiled
    libraries bring: 8 bytes with picolibc's sqrt."""
    out = subprocess.run([prefix + "size", *map(str, files)], check=True,
                         text=True, capture_output=True).stdout
    total = 0
    for line in out.splitlines()[1:]:
        text, data, bss, _, _, name = line.split()
        if not libraries and (data, bss) != ("0", "0"):
            sys.exit(f"figures: {name} holds {data} + {bss} bytes of data")
        total += int(text)
    return total


def stacks(folder, prefix, counted):
    functions = stack.graph(sorted(folder.glob("*.ci")))
    for entry, work in WORKS.items():
        program = stack.Program(prefix, str(folder / f"reach_{entry}"))
        unwanted = program.address.keys() & UNWANTED
        if unwanted:
            sys.exit(f"figures: {folder.name}: {entry} brings {unwanted}")
        most, way = stack.deepest(functions, program, entry)
        own = next(b for name, (b, _) in functions.items()
                   if name.endswith(":" + work))
        seen = counted[entry][1] - own
        if not 0 < seen <= most:
            sys.exit(f"figures: {folder.name}: {entry} went {seen} deep, "
                     f"{most} found by {' '.join(way)}")
        yield entry, most


def measured(folder, prefix, sources):
    """{(kind, what): figure} of a board."""
    counted = {}
    for line in (folder / "counts.txt").read_text().splitlines():
        name, *numbers = line.split()
        counted[name] = [int(n) for n in numbers]
    floats = [folder / f"{s}.o" for s in sources if s.startswith("coinf_")]
    doubles = [folder / f"{s}.o" for s in sources if s not in
               {f.stem for f in floats}]
    found = {("code", "all of coinf.h"): size(prefix, floats),
             ("code", "all of coin.h"): size(prefix, doubles)}
    for entry in WORKS:
        found["code", entry] = size(
            prefix, [folder / f"reach_{entry}"], libraries=True)
    for entry, most in stacks(folder, prefix, counted):
        found["stack", entry] = most
    for name, (count, _) in counted.items():
        found["instructions", name] = count
    return found


def tables(boards):
    text = ""
    for kind, title in (("instructions", "instructions per step"),
                        ("stack", "bytes of stack"), ("code", "bytes of code")):
        columns = [w for k, w in next(iter(boards.values())) if k == kind]
        text += f"| {title} | " + " | ".join(
            c if " " in c else f"`{c}`" for c in columns) + " |\n"
        text += "| --- |" + " --- |" * len(columns) + "\n"
        for name, found in boards.items():
            text += f"| {name} | " + " | ".join(
                str(found[kind, c]) for c in columns) + " |\n"
        text += "\n"
    return text


def disagree(now, stated):
    """What is not within reach of what the docs state."""
    if re.sub(r"\d+ ", "", now) != re.sub(r"\d+ ", "", stated):
        yield "the tables in the docs are others"
    else:
        lines = zip(now.splitlines(), stated.splitlines())
        for new, old in lines:
            pairs = zip(re.findall(r"(?<=\| )\d+(?= )", new),
                        re.findall(r"(?<=\| )\d+(?= )", old))
            if any(abs(int(n) - int(o)) > WITHIN * int(o) for n, o in pairs):
                yield f"measured {new}\n  stated {old}"


def main(out, docs, sources, *rest):
    boards = {}
    for board in rest:
        if board != "--update":
            name, prefix = board.split("=")
            boards[name] = measured(pathlib.Path(out, name), prefix,
                                    sources.split())
    wrong = [f"{b}: {n} {k} in {w}, {most} allowed"
             for (b, k, w), most in MOST.items()
             if (n := boards[b][k, w]) > most]
    now, path = tables(boards), pathlib.Path(docs)
    print(now, end="")
    text = path.read_text()
    block = BLOCK.search(text)
    if not block:
        sys.exit(f"{docs} has no table <!-- firmware -->")
    if "--update" in rest:
        path.write_text(BLOCK.sub(lambda m: m[1] + now + m[2], text))
    else:
        stated = block[0].split("\n", 1)[1].removesuffix(block[2])
        wrong += disagree(now, stated)
    sys.exit("\n".join(["figures:", *wrong]) if wrong else 0)


main(*sys.argv[1:])
