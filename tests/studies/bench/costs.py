#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What calls cost, as CSV: callgrind's instructions, and the time of each build.

    costs.py OUT BUILD...    runs OUT/BUILD/bench_costs
"""
import pathlib
import re
import subprocess
import sys


def lines(*command):
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True)
    return [line.split(";") for line in done.stdout.splitlines()]


def instructions(out):
    """{row: instructions}.  Callgrind does not know all of this processor's:
    the portable build's."""
    file = out / "callgrind.out"
    rows = lines("valgrind", "--tool=callgrind", "--combine-dumps=yes",
                 f"--callgrind-out-file={file}",
                 out / "portable/bench_costs", "count")
    parts = re.findall(r"Client Request: row$.*?^summary: (\d+)",
                       file.read_text(), re.M | re.S)
    return {name: int(part) / int(times)
            for (name, times), part in zip(rows, parts, strict=True)}


def main(out, *builds):
    out = pathlib.Path(out)
    counts = instructions(out)
    ns = {(build, name): t for b in builds
          for build, name, t in lines(out / b / "bench_costs", b)}
    print("call", "instructions", *(f"{b} ns" for b in builds), sep=";")
    for name, count in counts.items():
        print(name, f"{count:.0f}", *(ns[b, name] for b in builds), sep=";")


main(*sys.argv[1:])
