#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the calls of a frame loop cost, as CSV: time, in nanoseconds and in
textbook's RK4 steps of the same windows, and callgrind's instructions, of the
portable build: callgrind does not know all of this processor's.

    natural.py OUT BUILD...    (runs OUT/BUILD/bench_calls)
"""
import pathlib
import re
import subprocess
import sys

# Two lengths of run: what differs is the calls alone.  Multiples of a window.
FEW, MANY = 4096, 8192


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True)


def instructions(program, call, count):
    log = run("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
              program, "run", call, str(count)).stderr
    return int(re.search(r"Collected : (\d+)", log)[1])


def main(out, *builds):
    print("build,call,ns,textbook_steps,instructions")
    for build in builds:
        program = pathlib.Path(out, build, "bench_calls")
        for line in run(program, build).stdout.splitlines():
            call = line.split(",")[1]
            count = ""
            if build == "portable":
                few, many = (instructions(program, call, n)
                             for n in (FEW, MANY))
                count = f"{(many - few) / (MANY - FEW):.0f}"
            print(line, count, sep=",")


main(*sys.argv[1:])
