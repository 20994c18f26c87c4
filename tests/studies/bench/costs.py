#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a step costs, as CSV: time, instructions, arithmetic and bytes, beside
the two limits that no order of the same operations can beat.

    costs.py OUT    (reads OUT/steps.csv, runs OUT/count, OUT/portable/*)

Time and the time of single operations are from steps.csv.  Instructions are
callgrind's, the difference of two lengths of run.  Operations, and the length
of the longest chain of them, are from the library's own sources with a double
that counts (arithmetic.h).  Bytes: what a run carries from step to step, and
the code of the method's object file.
"""
import csv
import pathlib
import re
import subprocess
import sys

OUT = pathlib.Path(sys.argv[1])
OBJECTS = {"rk4": "rk4", "rk8": "rk8", "order 14 in tau": "extrapolation",
           "symplectic2": "symplectic", "symplectic4": "symplectic",
           "textbook RK4": "textbook"}


def rows(path):
    lines = [l for l in path.read_text().splitlines() if not l.startswith("#")]
    return list(csv.DictReader(lines))


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True)


def instructions(method, steps):
    log = run("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
              OUT / "portable/bench_steps", "run", method, str(steps)).stderr
    return int(re.search(r"Collected : (\d+)", log)[1])


def code_bytes(name):
    """Code and constants of an object file."""
    folder = OUT / "portable" / ("" if name == "textbook" else "lib")
    table = run("size", "-A", folder / f"{name}.o").stdout
    return sum(int(size) for size in
               re.findall(r"^\.(?:text|rodata)\S*\s+(\d+)", table, re.M))


def main():
    steps = {r["method"]: r["ns_per_step"] for r in rows(OUT / "steps.csv")
             if r["build"] == "portable"}
    latency = [steps["latency " + k] for k in ("add", "mul", "div", "sqrt")]
    flop = float(steps["per flop at best"])
    counted = {}
    for line in run(OUT / "count", *latency).stdout.splitlines():
        name, *numbers = line.split(",")
        counted[name] = [float(n) for n in numbers]
    print("method,ns,chain_ns,flop_ns,instructions,additions,products,"
          "divisions,roots,code_bytes")
    for method in ("textbook RK4", "rk4", "rk8", "order 14 in tau",
                   "symplectic2", "symplectic4"):
        ins = (instructions(method, 6400) - instructions(method, 3200)) / 3200
        code = code_bytes(OBJECTS[method]) if method in OBJECTS else ""
        limits, ops = ["", ""], [""] * 4
        if method in counted:
            *ops, chain = counted[method]
            limits = [f"{chain:.1f}", f"{flop * sum(ops):.1f}"]
        print(method, steps[method], *limits, f"{ins:.0f}", *ops, code,
              sep=",")


main()
