#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the library takes of a processor, against the tables in the docs.

    figures.py KIND OUT DOCS SOURCES NAME=PREFIX...           fails unless they
    figures.py KIND OUT DOCS SOURCES NAME=PREFIX... --update  agree, writes them

KIND is firmware or cross: boards, whose programs are looked at as a whole, or
systems, of whose programs it is the library's part.  OUT/NAME holds what
firmware.mk made for a machine; PREFIX is of its binutils.
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
        ("m4f", "stack", "coinf_step"): 320,
        ("m4f", "stack", "coin_step"): 832}

# An entry of coin.h, and the function of counts.c whose stack was looked at.
WORKS = {"coinf_step": "float_steps", "coinf_run": "float_run",
         "coinf_check": "float_checks",
         "coin_step": "double_steps", "coin_run": "double_run",
         "coin_settle": "settles", "coin_move": "moves"}
UNWANTED = {"malloc", "_malloc_r", "free", "_sbrk", "__errno", "printf"}
HOLDS = {"firmware": stack.Program, "cross": stack.Part}


def size(prefix, files):
    """Bytes of code and constants, which llvm-size calls data."""
    out = subprocess.run([prefix + "size", *map(str, files)], check=True,
                         text=True, capture_output=True).stdout
    lines = [line.split() for line in out.splitlines()[1:]]
    return sum(int(text) + int(data) for text, data, *_ in lines)


def stacks(holds, folder, prefix, counted):
    functions = stack.graph(sorted(folder.glob("*.ci")))
    for entry, work in WORKS.items():
        program = holds(prefix, str(folder / f"reach_{entry}"))
        unwanted = program.address.keys() & UNWANTED
        if unwanted:
            sys.exit(f"figures: {folder.name}: {entry} brings {unwanted}")
        most, way = stack.deepest(functions, program, entry)
        own = next(b for name, (b, _) in functions.items()
                   if name.endswith(":" + work))
        seen = counted[entry][1] - own
        # 0: what it needs lies in the frame of its caller.
        if not 0 <= seen <= most:
            sys.exit(f"figures: {folder.name}: {entry} went {seen} deep, "
                     f"{most} found by {' '.join(way)}")
        yield entry, most


def measured(holds, folder, prefix, sources):
    """{(kind, what): figure} of a machine."""
    floats = [folder / f"{s}.o" for s in sources if s.startswith("coinf_")]
    doubles = [folder / f"{s}.o" for s in sources if s not in
               {f.stem for f in floats}]
    found = {("code", "all of coinf.h"): size(prefix, floats),
             ("code", "all of coin.h"): size(prefix, doubles)}
    for entry in WORKS:
        found["code", entry] = size(prefix, [folder / f"reach_{entry}"])
    counts = folder / "counts.txt"
    if counts.exists():
        lines = [line.split() for line in counts.read_text().splitlines()]
        counted = {name: [int(n) for n in numbers] for name, *numbers in lines}
        for name, (count, _) in counted.items():
            found["instructions", name] = count
        for entry, most in stacks(holds, folder, prefix, counted):
            found["stack", entry] = most
    return found


def tables(machines):
    text = ""
    for kind, title in (("instructions", "instructions per step"),
                        ("stack", "bytes of stack"), ("code", "bytes of code")):
        columns = [w for k, w in next(iter(machines.values())) if k == kind]
        text += f"| {title} | " + " | ".join(
            c if " " in c else f"`{c}`" for c in columns) + " |\n"
        text += "| --- |" + " --- |" * len(columns) + "\n"
        for name, found in machines.items():
            if (kind, columns[0]) in found:
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


def main(kind, out, docs, sources, *rest):
    machines = {}
    for machine in rest:
        if machine != "--update":
            name, prefix = machine.split("=")
            machines[name] = measured(HOLDS[kind], pathlib.Path(out, name),
                                      prefix, sources.split())
    wrong = [f"{m}: {n} {k} in {w}, {most} allowed"
             for (m, k, w), most in MOST.items()
             if m in machines and (n := machines[m][k, w]) > most]
    now, path = tables(machines), pathlib.Path(docs)
    print(now, end="")
    text = path.read_text()
    block = re.search(rf"(<!-- {kind} -->\n)(.*?)(<!-- end -->)", text, re.S)
    if not block:
        sys.exit(f"{docs} has no table <!-- {kind} -->")
    if "--update" in rest:
        path.write_text(text[:block.start(2)] + now + text[block.end(2):])
    else:
        wrong += disagree(now, block[2])
    sys.exit("\n".join(["figures:", *wrong]) if wrong else 0)


main(*sys.argv[1:])
